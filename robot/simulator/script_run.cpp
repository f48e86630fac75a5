// SPDX-License-Identifier: MIT
#include "robot/simulator/script_run.h"

#include <utility>

#include "robot/simulator/box/controller_model.h"
#include "robot/simulator/host/script_host.h"
#include "robot/simulator/programs/program_runner.h"

namespace tiller::simulator {

namespace {

SimulatorOptions plantOptions(const ScriptRunOptions& options) {
    SimulatorOptions plant;
    plant.model = options.model;
    plant.software = options.software;
    plant.time = Time::Virtual;
    plant.poweredOn = true;
    plant.startJoints = options.start;
    plant.seed = options.seed;
    return plant;
}

}  // namespace

class ScriptRun::Impl {
public:
    explicit Impl(const ScriptRunOptions& options) : plant(plantOptions(options)) {
        if (options.tcp) {
            plant.arm().setTcp(*options.tcp);
        }
        plant.registers().followed.number = static_cast<std::size_t>(options.followedRegister);
        // Runs one period without a program. After this period, the arm reports its position.
        plant.step();
    }

    ControllerModel plant;
    double began = 0;
};

ScriptRun::ScriptRun(const ScriptRunOptions& options) : d_(std::make_unique<Impl>(options)) {}
ScriptRun::~ScriptRun() = default;

std::optional<ScriptFault> ScriptRun::check(const QString& script, const SoftwareVersion& software) {
    urscript::CompileOptions options;
    options.version = software;
    const urscript::CompileOutcome outcome = urscript::compile(script.toStdString(), options);
    return outcome
               ? std::nullopt
               : std::optional(ScriptFault{outcome.error.line, QString::fromStdString(outcome.error.text)});
}

std::optional<ScriptFault> ScriptRun::start(const QString& script) {
    if (auto fault = check(script, d_->plant.options().software)) {
        return fault;
    }
    d_->plant.programs().submitText(script.toStdString());
    d_->began = d_->plant.elapsed();
    return std::nullopt;
}

bool ScriptRun::step() {
    d_->plant.step();
    static_cast<void>(d_->plant.takeOutbox());
    return d_->plant.programs().isActive() && !d_->plant.programs().isPaused();
}

double ScriptRun::stepTime() const {
    return d_->plant.stepTime();
}
double ScriptRun::time() const {
    return d_->plant.elapsed() - d_->began;
}
JointPositions ScriptRun::q() const {
    return d_->plant.arm().state().targetQ;
}
Pose ScriptRun::tcpPose() const {
    return d_->plant.arm().state().targetTcpPose;
}
std::uint64_t ScriptRun::digitalOutputs() const {
    return d_->plant.pins().digitalOutputs;
}
SafetyMode ScriptRun::safetyMode() const {
    return d_->plant.safety().mode();
}
std::vector<std::int32_t> ScriptRun::takeWritten() {
    return std::exchange(d_->plant.registers().followed.values, {});
}
std::optional<ScriptFault> ScriptRun::failure() const {
    const auto& failure = d_->plant.programs().failure();
    return failure ? std::optional(ScriptFault{failure->line, QString::fromStdString(failure->text)})
                   : std::nullopt;
}
QString ScriptRun::stopText() const {
    return QString::fromStdString(d_->plant.stopText());
}

bool ScriptRun::waitsForOperator() const {
    return d_->plant.popups().anyBlocking() || d_->plant.scriptHost().asked();
}
void ScriptRun::answerOperator() {
    d_->plant.popups().closeBlocking();
    if (const auto asked = d_->plant.scriptHost().asked()) {
        using urscript::RequestedType;
        switch (*asked) {
            case RequestedType::Boolean:
                d_->plant.scriptHost().answerRequest(false);
                break;
            case RequestedType::Integer:
                d_->plant.scriptHost().answerRequest(std::int32_t{0});
                break;
            case RequestedType::Float:
                d_->plant.scriptHost().answerRequest(0.0);
                break;
            case RequestedType::String:
                d_->plant.scriptHost().answerRequest(std::string());
                break;
        }
    }
}

void ScriptRun::setDigitalInput(int channel, bool value) {
    if (channel >= 0 && channel < kDigitalPins) {
        Pins::setBit(d_->plant.pins().digitalInputs, channel, value);
    }
}
void ScriptRun::setAnalogInput(int number, double value) {
    if (number == 0 || number == 1) {
        d_->plant.pins().analogInputs[static_cast<std::size_t>(number)] = value;
    }
}

}  // namespace tiller::simulator
