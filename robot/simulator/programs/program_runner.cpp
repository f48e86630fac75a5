// SPDX-License-Identifier: MIT
#include "robot/simulator/programs/program_runner.h"

#include <QHostAddress>
#include <algorithm>
#include <charconv>
#include <utility>

#include "robot/simulator/plant/plant.h"

namespace tiller::simulator {

using urscript::Interpreter;
using urscript::Program;
using urscript::ProgramKind;

namespace {
constexpr std::string_view kSetSpeed = "set speed ";  // followed by the new speed slider value, 0 to 1
}

ProgramRunner::ProgramRunner(Plant& plant, urscript::Host& host) : plant_(plant), host_(host) {}

void ProgramRunner::endAll() {
    controlled_.reset();
    runningSecondary_ = true;  // a secondary program does not affect the arm when it ends
    secondaries_.clear();
    runningSecondary_ = false;
    main_.reset();
}

void ProgramRunner::submit(const Unit& unit) {
    if (unit.kind == Unit::Kind::Command) {
        runCommand(unit.text);
    } else {
        enqueue(unit.text, false);
    }
}

bool ProgramRunner::submitText(std::string_view text) {
    return enqueue(text, true);
}

void ProgramRunner::submitControlled(std::string text, ScriptProvider provider) {
    // A controller that listens only on this PC can only reach a script provider on this PC.
    const QHostAddress here(plant_.options().listenAddress);
    if (here.isLoopback() && !QHostAddress(provider.host).isLoopback()) {
        provider.host = QStringLiteral("127.0.0.1");
    }
    controlled_ =
        std::make_unique<Controlled>(std::move(text), std::move(provider), plant_.options().scriptSilence);
}

void ProgramRunner::takeControlScript() {
    std::optional<std::string> script = controlled_ ? controlled_->request.poll() : std::nullopt;
    if (!script) {
        return;
    }
    const std::unique_ptr<Controlled> done = std::move(controlled_);
    if (script->empty()) {
        const ScriptProvider& from = done->provider;
        script = "popup(\"No script was received from " + from.host.toStdString() + ':' +
                 std::to_string(from.port) + "\", title=\"External Control\", error=True, blocking=True)";
    }
    enqueue(withControlScript(std::move(done->text), std::move(*script)), true);
}

urscript::CompileOptions ProgramRunner::compileOptions() const {
    urscript::CompileOptions options;
    options.version = plant_.options().software;
    options.isListed = plant_.assumptions().firstVersions == BehaviourOptions::FirstVersions::Latest;
    options.missing = plant_.assumptions().missingBuiltins();
    return options;
}

bool ProgramRunner::enqueue(std::string_view text, bool fromFile) {
    urscript::CompileOutcome outcome = urscript::compile(text, compileOptions());
    if (!outcome) {
        plant_.publish(primary::runtimeException(plant_.timestampNs(), outcome.error.line,
                                                 outcome.error.column, outcome.error.text));
        return false;
    }
    requests_.push_back({std::move(outcome.program), fromFile});
    return true;
}

void ProgramRunner::runCommand(std::string_view words) {
    if (words == "power on") {
        plant_.powerOn();
    } else if (words == "power off") {
        plant_.power().powerOff();
    } else if (words == "set robotmode run") {
        plant_.releaseBrakes();
    } else if (words == "set unlock protective stop") {
        plant_.safety().unlockProtectiveStop(false);
    } else if (words == "stop program") {
        requestStop();
    } else if (words == "pause program") {
        pause();
    } else if (words == "run program") {
        resume();
    } else if (words == "set robotmode freedrive") {
        plant_.setFreedriveButton(true);
    } else if (words.starts_with(kSetSpeed)) {
        setSpeed(words.substr(kSetSpeed.size()));
    }
    // Other commands, such as "set sim" and "set real", are accepted without effect.
}

void ProgramRunner::setSpeed(std::string_view fraction) {
    double value = 0;
    const auto parsed = std::from_chars(fraction.data(), fraction.data() + fraction.size(), value);
    if (parsed.ec == std::errc() && parsed.ptr == fraction.data() + fraction.size()) {
        plant_.setSpeedSlider(value);
    }
}

void ProgramRunner::requestStop() {
    controlled_.reset();
    requests_.push_back({});
}

bool ProgramRunner::isStopRequested() const {
    return std::any_of(requests_.begin(), requests_.end(),
                       [](const NextProgram& r) { return r.program == nullptr; });
}

void ProgramRunner::takeRequests() {
    while (!requests_.empty()) {
        const NextProgram next = std::move(requests_.front());
        const std::shared_ptr<const Program>& program = next.program;
        requests_.pop_front();
        if (!program) {
            beginStopping();
        } else if (program->kind() == ProgramKind::Secondary ||
                   (program->isRaw() && !program->commandsMotion() && main_)) {
            startSecondary(program);
        } else {
            startMain(program);
            fromFile_ = next.fromFile;
        }
    }
}

void ProgramRunner::startMain(std::shared_ptr<const Program> program) {
    const SafetyMode safety = plant_.safety().mode();
    if (!allowsMotion(safety)) {
        plant_.publish(primary::runtimeException(
            plant_.timestampNs(), 0, 0,
            "program " + program->name() + " not started: " + safetyModeName(safety).toStdString()));
        return;
    }
    stopNow();
    name_ = program->name();
    urscript::Limits limits;
    limits.randomSeed = plant_.options().seed;
    limits.threadsBeginNextFrame =
        plant_.assumptions().threadStart == BehaviourOptions::ThreadStart::NextPeriod;
    limits.remoteServersMayBeAbsent = plant_.assumptions().rpcFactory == BehaviourOptions::RpcFactory::Defers;
    limits.mainFirst = plant_.assumptions().threadOrder == BehaviourOptions::ThreadOrder::MainFirst;
    main_ = std::make_unique<Interpreter>(std::move(program), host_, limits);
    ended_ = false;
    failure_.reset();
    state_ = RuntimeState::Playing;
    begun_ = plant_.elapsed();
    ++starts_;
    plant_.publish(primary::key(plant_.timestampNs(), primary::kProgramStarted, name_));
}

void ProgramRunner::startSecondary(std::shared_ptr<const Program> program) {
    constexpr std::size_t kMaxSecondaries = 32;
    if (secondaries_.size() < kMaxSecondaries) {
        secondaries_.push_back(std::make_unique<Interpreter>(std::move(program), host_));
    }
}

void ProgramRunner::step() {
    takeControlScript();
    takeRequests();
    stepMain();
    stepSecondaries();
}

void ProgramRunner::stepMain() {
    const arm::ArmState& arm = plant_.arm().state();
    switch (state_) {
        case RuntimeState::Stopped:
        case RuntimeState::Paused:
            return;
        case RuntimeState::Stopping:
            stopping_ += plant_.stepTime();
            if (stopping_ >= kStopTime && arm.isStandstill()) {
                finishStopping();
            }
            return;
        case RuntimeState::Pausing:
            if (ended_) {
                break;
            }
            if (arm.isStandstill()) {
                state_ = RuntimeState::Paused;
            }
            return;
        case RuntimeState::Resuming:
            if (arm.speedScaling > 0.99) {
                state_ = RuntimeState::Playing;
            }
            break;
        case RuntimeState::Playing:
            break;
    }
    if (ended_) {
        if (plant_.elapsed() - begun_ < kMinPlayingTime - 0.5 * plant_.stepTime()) {
            return;
        }
        main_.reset();
        if (arm.isStandstill()) {
            finishStopping();
        } else {
            state_ = RuntimeState::Stopping;
            stopping_ = 0;
        }
        return;
    }
    main_->runFrame();
    if (main_->ended()) {
        reportFailure(*main_);
        failure_ = main_->error();
        if (main_->error() && main_->error()->overrun) {
            plant_.safety().protectiveStop();  // exceeding the time limit causes a protective stop
        }
        ended_ = true;  // in this period, the program is still playing
    }
}

void ProgramRunner::stepSecondaries() {
    runningSecondary_ = true;
    for (auto& secondary : secondaries_) {
        secondary->runFrame();
        if (secondary->ended()) {
            reportFailure(*secondary);
            secondary.reset();
        }
    }
    std::erase(secondaries_, nullptr);
    runningSecondary_ = false;
}

void ProgramRunner::reportFailure(const Interpreter& interpreter) {
    if (const auto& error = interpreter.error()) {
        const bool secondary = interpreter.program().kind() == ProgramKind::Secondary;
        plant_.publish(
            primary::runtimeException(plant_.timestampNs(), error->line, error->column,
                                      (secondary ? "SECONDARY_PROGRAM_EXCEPTION_XXX: " : "") + error->text));
    }
}

void ProgramRunner::beginStopping() {
    if (!main_ || state_ == RuntimeState::Stopping) {
        return;
    }
    main_->stop();  // the host decelerates the arm
    main_.reset();
    state_ = RuntimeState::Stopping;
    stopping_ = 0;
}

void ProgramRunner::stopNow() {
    controlled_.reset();
    if (main_) {
        main_->stop();
    }
    if (isActive()) {
        finishStopping();
    }
}

void ProgramRunner::finishStopping() {
    main_.reset();
    ended_ = false;
    plant_.arm().resume();  // a paused program still holds the arm
    state_ = RuntimeState::Stopped;
    plant_.publish(primary::key(plant_.timestampNs(), primary::kProgramStopped, name_));
}

void ProgramRunner::pause() {
    if (main_ && (state_ == RuntimeState::Playing || state_ == RuntimeState::Resuming)) {
        main_->pause();
        plant_.arm().hold();
        state_ = RuntimeState::Pausing;
    }
}

void ProgramRunner::haltForProtectiveStop() {
    if (fromFile_ || plant_.assumptions().protectiveStop != BehaviourOptions::ProtectiveStop::Ends) {
        pause();
    } else {
        beginStopping();
    }
}

void ProgramRunner::resume() {
    if (main_ && (state_ == RuntimeState::Paused || state_ == RuntimeState::Pausing) &&
        allowsMotion(plant_.safety().mode())) {
        main_->resume();
        plant_.arm().resume();
        state_ = RuntimeState::Resuming;
    }
}

std::uint32_t ProgramRunner::currentLine() const {
    return main_ && !ended_ ? static_cast<std::uint32_t>(std::max(0, main_->currentLine())) : 0U;
}

}  // namespace tiller::simulator
