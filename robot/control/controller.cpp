// SPDX-License-Identifier: MIT
#include "robot/control/controller.h"

#include <algorithm>
#include <array>
#include <span>

#include "robot/control/detail/argument_check.h"
#include "robot/control/detail/controller_private.h"
#include "robot/realtime/realtime_report.h"

namespace tiller::control {

namespace {

// How often the control thread looks up when no data come. In real time only: whether they are late is
// decided by the Clock.
constexpr std::int64_t kLookUpNs = 4 * kNsPerMs;
// What is found so soon after the thread had something to do may have come meanwhile.
constexpr std::int64_t kBusyNs = kNsPerMs / 20;

}  // namespace

Controller::Controller(const ControllerOptions& options) : d_(std::make_unique<Private>(options)) {
    d_->armLimits = ArmLimits::of(robotModel(options.model));
    d_->loop.publishLoss(ControlLoss::NotTaken);
}

Controller::~Controller() {
    release();
}

Result<void> Controller::takeControl(const Deadline& deadline) {
    const std::lock_guard lock(d_->taking);
    if (d_->running && d_->loop.isInControl()) {
        return {};
    }
    const UnderWay cancellable(*d_, deadline);
    d_->stopThread();
    auto taken = d_->take(deadline, false);
    if (!taken) {
        d_->stopThread();
        d_->loop.publishLoss(ControlLoss::NotTaken);
    }
    return taken;
}

Result<void> Controller::joinProgram(const Deadline& deadline) {
    const std::lock_guard lock(d_->taking);
    if (d_->running && d_->loop.isInControl()) {
        return {};
    }
    const UnderWay cancellable(*d_, deadline);
    if (d_->running) {
        const QString context = QStringLiteral("go on with the control program");
        if (d_->loop.status().runtimeState != RuntimeState::Playing || d_->session == 0) {
            return Error{ErrorCode::NotInControl, context, QStringLiteral("it does not run")};
        }
        d_->loop.expectSession(d_->session);
        return d_->awaitControl(deadline, context);
    }
    d_->stopThread();
    auto taken = d_->take(deadline, true);
    if (!taken) {
        d_->stopThread();
        d_->loop.publishLoss(ControlLoss::NotTaken);
    }
    return taken;
}

void Controller::Private::end(const std::function<void()>& whenRunning) {
    {
        const std::lock_guard lock(patience);
        ++ending;
        underWay.cancel();
    }
    const std::lock_guard lock(taking);
    {
        const std::lock_guard guard(patience);
        --ending;
    }
    if (running) {
        whenRunning();
    }
    stopThread();
    loop.publishLoss(ControlLoss::Released);
}

void Controller::release() {
    stop(StopCause::ControlLost);
    d_->end([this] {
        stop(StopCause::ControlLost);
        d_->loop.requestEnd();
        // Enough to see the arm come to rest from a jog; a longer way it brakes without us.
        const Deadline patience = Deadline::after(std::chrono::milliseconds(160));
        while (d_->running && d_->loop.isInControl() && !patience.hasExpired()) {
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
        }
    });
}

void Controller::leave() {
    const auto stopEndless = [this] {
        if (!d_->mailbox.hasAnEnd()) {
            stop(StopCause::ControlLost);
        }
        d_->loop.permitForce(false);
    };
    stopEndless();
    d_->end([&] {
        stopEndless();
        d_->loop.permitFinish();
        d_->wake();
        // Some 5 ms, unless the robot hangs: then its program ends the motion by itself.
        const Deadline patience = Deadline::after(std::chrono::milliseconds(160));
        while (d_->running && d_->loop.isInControl() && !d_->loop.isFinishPermitted() &&
               !patience.hasExpired()) {
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
    });
    stop(StopCause::ControlLost);  // for those who wait for it here: we hear no more of it
}

void Controller::Private::run() {
    realtime::nameThread("control");
    loop.setGranted(options.priority <= 0 || realtime::requestThreadPriority(options.priority).ok(),
                    options.cpus.empty() || realtime::bindToCpus(options.cpus).isEmpty());
    std::vector<double> values(connection->outputs().size());
    const auto isSent = [this](Inputs recipe, std::span<const double> inputs) {
        return connection->sendInputs(recipe, inputs) != rtde::Connection::Send::Failed;
    };
    const auto send = [&](const Command& command) {
        const auto inputs = encode(command);
        bool sent = isSent(kCommandInputs, inputs);
        if (sent && watchdogUsable && kick.exchange(false, std::memory_order_acq_rel)) {
            constexpr std::array<double, 1> kNothing{};
            sent = isSent(kWatchdogInputs, kNothing);
        }
        if (const auto* measured = sent && wrenchUsable ? wrench.take() : nullptr; measured != nullptr) {
            sent = isSent(kWrenchInputs, *measured);
        }
        return sent;
    };
    bool alive = true;
    std::int64_t doneNs = now();
    const auto lastData = [this] { return loop.status().dataTimeNs; };
    const std::int64_t silenceNs = std::chrono::nanoseconds(options.silence).count();
    const std::int64_t begunNs = doneNs;
    const auto answer = [&](const Command& command) {
        doneNs = now();
        return send(command);
    };
    while (alive && !quit.load(std::memory_order_acquire)) {
        const std::int64_t due = loop.dueNs();
        // The last of the wait for a cycle that is due is spent looking, not asleep.
        const std::int64_t left = due == kNoCycleDue ? kLookUpNs : due - now() - kWakeUpNs;
        const std::chrono::nanoseconds wait(std::clamp<std::int64_t>(left, 0, kLookUpNs));
        switch (connection->readPackage(values, wait, &waker)) {
            case rtde::Connection::Read::Package: {
                Feedback data = layout.decode(values, now());
                data.awaited = data.hostNs - doneNs > kBusyNs;
                alive = answer(loop.tick(data));
                if (loop.takePaused() && (!options.keepPaused || loop.yieldedWhenPaused())) {
                    primary->requestProgramStop();  // set before this thread began, and until it has ended
                }
                break;
            }
            case rtde::Connection::Read::Nothing: {
                const bool looksOn = wait.count() == 0 && now() < due;
                Command command;
                if ((waker.take() && loop.early(now(), command)) ||
                    (!looksOn && loop.fallback(now(), command))) {
                    alive = answer(command);
                }
                if (silenceNs > 0 && now() - std::max(lastData(), begunNs) > silenceNs) {
                    alive = false;
                }
                break;
            }
            case rtde::Connection::Read::Closed:
            case rtde::Connection::Read::Failed:
            case rtde::Connection::Read::Malformed:
                alive = false;
                break;
        }
    }
    if (!alive) {
        loop.lost(now(), ControlLoss::LinkLost);
        connection->close();  // frees the registers for whoever comes next
    }
    running.store(false, std::memory_order_release);
}

Error Controller::Private::obstacle(const QString& context) const {
    const ControllerStatus status = loop.status();
    if (!loop.isInControl()) {
        return {ErrorCode::NotInControl, context, {}};
    }
    if (status.robotMode != RobotMode::Running || !allowsMotion(status.safetyMode)) {
        return {
            ErrorCode::UnsafeState, context,
            QStringLiteral("%1, %2").arg(robotModeName(status.robotMode), safetyModeName(status.safetyMode))};
    }
    if (now() - status.dataTimeNs > patienceNs()) {
        return {ErrorCode::LinkLost, context,
                QStringLiteral("no data for more than %1 ms").arg(options.patience.count())};
    }
    if (status.roundTripMs > static_cast<double>(options.patience.count())) {
        return {
            ErrorCode::LinkLost, context,
            QStringLiteral("commands take %1 ms to the robot and back").arg(status.roundTripMs, 0, 'f', 0)};
    }
    return {};
}

Result<MotionId> Controller::Private::start(const MotionCommand& command, std::uint64_t stops,
                                            const QString& context) {
    const MotionId id = mailbox.startUnlessStopped(stops, command, now());
    if (id == kNoMotion) {
        return Error{ErrorCode::Stopped, context, QStringLiteral("a stop came first")};
    }
    // Control may have ended since it was looked at, and nobody else would end this motion then.
    if (!loop.confirmControl()) {
        mailbox.end(id, StopCause::ControlLost, now());
        return Error{ErrorCode::NotInControl, context, {}};
    }
    wake();
    return id;
}

void Controller::stop(StopCause cause) {
    d_->mailbox.stop(cause, d_->now());
    d_->loop.permitForce(false);  // afterwards: see setForceMode()
    d_->wake();
}

bool Controller::end(MotionId motion, StopCause cause) {
    const bool ended = d_->mailbox.end(motion, cause, d_->now());
    d_->wake();
    return ended;
}

MotionState Controller::motionState(MotionId motion) const {
    return d_->mailbox.epoch().state(motion);
}

ControllerStatus Controller::status() const {
    return d_->loop.status();
}

JointLimits Controller::jointLimits() const {
    const ArmLimits arm = d_->armNow();
    return {arm.minPosition, arm.maxPosition, arm.maxSpeed};
}

bool Controller::isConnected() const {
    return d_->running.load(std::memory_order_acquire);
}

MotionLimits Controller::limits() const {
    return d_->limitsNow();
}

Result<void> Controller::setSpeedCap(double metresPerSecond) {
    const ArgumentCheck check =
        ArgumentCheck("set the speed cap").positive("cap", metresPerSecond, kHighestToolSpeed, "m/s", "mm/s");
    if (!check.ok()) {
        return check.error();
    }
    if (metresPerSecond != d_->loop.speedCap()) {
        // In this order: what is begun in between has the new cap, or is stopped.
        d_->loop.setSpeedCap(metresPerSecond);
        stop(StopCause::SelectionChanged);
    }
    return {};
}

SoftwareVersion Controller::version() const {
    return d_->versionNow();
}

}  // namespace tiller::control
