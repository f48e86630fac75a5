// SPDX-License-Identifier: MIT
#include "robot/control/controller.h"

#include <algorithm>
#include <array>
#include <span>

#include "robot/control/detail/argument_check.h"
#include "robot/control/detail/controller_private.h"
#include "robot/core/wait_until.h"
#include "robot/receive/sample.h"

namespace tiller::control {

namespace {

// Maximum time for the last commands to reach the control program before the connection is closed.
constexpr std::chrono::milliseconds kLastWords(160);

Error stoppedBefore(const QString& context) {
    return {ErrorCode::Stopped, context, QStringLiteral("interrupted by a stop")};
}

}  // namespace

Controller::Controller(const ControllerOptions& options) : d_(std::make_unique<Private>(options)) {
    d_->loop.publishLoss(ControlLoss::NotTaken);
}

Controller::~Controller() {
    release();
}

Result<void> Controller::takeControl(const Deadline& deadline) {
    const std::lock_guard lock(d_->taking);
    if (d_->isInControl()) {
        return {};
    }
    const UnderWay cancellable(*d_, deadline);
    return d_->take(deadline, false);
}

Result<void> Controller::joinProgram(const Deadline& deadline) {
    const std::lock_guard lock(d_->taking);
    if (d_->isInControl()) {
        return {};
    }
    const UnderWay cancellable(*d_, deadline);
    if (!d_->link.isRunning()) {
        return d_->take(deadline, true);
    }
    const QString context = QStringLiteral("continue with the control program");
    const std::int32_t session = d_->program.session();
    if (d_->loop.status().runtimeState != RuntimeState::Playing || session == 0) {
        return Error{ErrorCode::NotInControl, context, QStringLiteral("the control program is not running")};
    }
    d_->loop.expectSession(session);
    return d_->program.awaitControl(deadline, context);
}

Result<void> Controller::Private::take(const Deadline& deadline, bool join) {
    disconnect();
    std::fill(pulseEndsNs.begin(), pulseEndsNs.end(), 0);  // pulses have ended with the previous program
    auto taken = connect(deadline, join);
    if (!taken) {
        disconnect();
        loop.publishLoss(ControlLoss::NotTaken);
    }
    return taken;
}

// Each step reports its own error.
Result<void> Controller::Private::connect(const Deadline& deadline, bool join) {
    if (const Error error = checkLimits(options.limits, "take control"); error.code != ErrorCode::None) {
        return error;
    }
    if (const QStringList unknown = receive::unknownOutputs(options.fields); !unknown.isEmpty()) {
        return Error{ErrorCode::FieldUnknown, QStringLiteral("take control"),
                     unknown.join(QStringLiteral("; "))};
    }
    loop.publishLoss(ControlLoss::Taking);
    if (auto opened = link.open(deadline); !opened) {
        return opened;
    }
    if (options.awaitProgram) {
        if (auto safe = link.checkModes(deadline); !safe) {
            return safe;
        }
    }
    std::optional<Echo> joined;
    if (join) {
        const auto found = link.findProgram(deadline);
        if (!found) {
            return found.error();
        }
        joined = *found;
    }
    if (auto heard = program.listen(link.version(), deadline); !heard) {
        return heard;
    }
    const std::int32_t session = joined ? joined->session : ControlProgram::newSession();
    requests.restart([&] {
        program.setSession(session);
        loop.begin(session, link.period(), program.arm(), now());
        if (joined) {
            // Ignore the commands of the previous client.
            mailbox.skipTo(static_cast<std::uint64_t>(joined->epoch) + 1);
            loop.follow(*joined);
        }
        link.begin(program.listener());
    });
    return joined ? program.awaitControl(
                        deadline, QStringLiteral("connect to the control program at %1").arg(options.host))
                  : program.upload(session, {}, deadline);
}

void Controller::Private::disconnect() {
    link.end();
    program.stopListening();
}

void Controller::Private::end(const std::function<void()>& whenRunning) {
    {
        const std::lock_guard lock(tokenMutex);
        ++ending;
        underWay.cancel();
    }
    const std::lock_guard lock(taking);
    {
        const std::lock_guard guard(tokenMutex);
        --ending;
    }
    if (link.isRunning()) {
        whenRunning();
    }
    disconnect();
    loop.publishLoss(ControlLoss::Released);
}

void Controller::release() {
    stop(StopCause::ControlLost);
    d_->end([this] {
        stop(StopCause::ControlLost);
        d_->loop.requestEnd();
        // This time is sufficient to stop a jog. A deceleration that takes longer continues unsupervised.
        waitUntil(Deadline::after(kLastWords), [this] { return !d_->isInControl(); });
    });
}

void Controller::leave(Supervision supervision) {
    const auto stopEndless = [this, supervision] {
        if (supervision == Supervision::Heartbeat || !d_->mailbox.hasAnEnd()) {
            stop(StopCause::ControlLost);
        }
        d_->loop.permitForce(false);
    };
    stopEndless();
    d_->end([&] {
        stopEndless();
        d_->loop.permitFinish();
        d_->link.wake();
        // The robot typically receives the permission within 5 ms. If the robot does not respond, its program
        // ends the motion.
        waitUntil(Deadline::after(kLastWords),
                  [this] { return !d_->isInControl() || d_->loop.isFinishPermitted(); });
    });
    stop(StopCause::ControlLost);  // completes waiting calls, because no further data arrive
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
    if (now() - status.dataTimeNs > dataTimeoutNs()) {
        return {ErrorCode::LinkLost, context,
                QStringLiteral("no data for more than %1 ms").arg(options.dataTimeout.count())};
    }
    if (status.roundTripMs > static_cast<double>(options.dataTimeout.count())) {
        return {ErrorCode::LinkLost, context,
                QStringLiteral("the round-trip time of commands is %1 ms: check the network")
                    .arg(status.roundTripMs, 0, 'f', 0)};
    }
    return {};
}

Result<MotionId> Controller::Private::start(const MotionCommand& command, std::uint64_t stops,
                                            const QString& context) {
    const MotionId id = mailbox.startUnlessStopped(stops, command, now());
    if (id == kNoMotion) {
        return stoppedBefore(context);
    }
    // If control was lost after the check, end the motion here.
    if (!loop.confirmControl()) {
        mailbox.end(id, StopCause::ControlLost, now());
        return Error{ErrorCode::NotInControl, context, {}};
    }
    link.wake();
    return id;
}

Result<void> Controller::Private::awaitPulses(std::uint64_t stops, const Deadline& deadline,
                                              const QString& context) const {
    const auto last = [this] { return std::max_element(pulseEndsNs.begin(), pulseEndsNs.end()); };
    const bool over = waitUntil(deadline, [&] {
        return last()->load() <= now() || mailbox.epoch().stops() != stops || !loop.isInControl();
    });
    if (over) {
        return {};
    }
    return Error{
        deadline.isCancelled() ? ErrorCode::Cancelled : ErrorCode::Timeout, context,
        QStringLiteral("the pulse of digital output %1 is active for another %2 s: wait, or end the pulse")
            .arg(std::distance(pulseEndsNs.begin(), last()))
            .arg(static_cast<double>(last()->load() - now()) * 1e-9, 0, 'f', 1)};
}

Result<std::uint64_t> Controller::Private::sendSection(const QString& section, const QString& name,
                                                       std::uint64_t stops, const Deadline& deadline,
                                                       const QString& context) {
    const std::lock_guard lock(taking);
    const UnderWay cancellable(*this, deadline);
    if (!loop.isInControl()) {
        return Error{ErrorCode::NotInControl, context, {}};
    }
    if (auto quiet = awaitPulses(stops, deadline, context); !quiet) {
        return quiet.error();
    }
    // Stop first, so that the arm decelerates and no earlier command can start.
    const std::uint64_t epoch = mailbox.stop(Brake{}, StopCause::Superseded, now());
    if (mailbox.epoch().stops() != stops) {
        return stoppedBefore(context);
    }
    if (auto sent = program.restart(section, name, deadline); !sent) {
        Error error = sent.error();
        error.context = context;
        // If the section does not compile, continue with the plain control program to keep control.
        if (error.code == ErrorCode::ScriptError) {
            if (auto back = program.restart({}, {}, deadline); !back) {
                error.controllerMessage +=
                    QStringLiteral("; control could not be regained: ") + back.error().toString();
            }
        }
        return error;
    }
    return epoch;
}

Result<MotionId> Controller::Private::beginSection(std::uint64_t epoch, Holding holding,
                                                   std::chrono::milliseconds heartbeatTimeout,
                                                   const QString& context) {
    MotionCommand command;
    command.kind = MotionCommand::Kind::Program;
    command.program = static_cast<std::int32_t>(ScriptCommand::Section);
    command.held = holding == Holding::Held;
    command.heartbeatTimeout = heartbeatTimeout;
    const MotionId id = mailbox.startAfter(epoch, command, now());
    if (id == kNoMotion) {
        return stoppedBefore(context);
    }
    if (!loop.confirmControl()) {
        mailbox.end(id, StopCause::ControlLost, now());
        return Error{ErrorCode::NotInControl, context, {}};
    }
    return id;
}

Result<MotionId> Controller::Private::startSection(const QString& section, const QString& name,
                                                   Holding holding,
                                                   std::chrono::milliseconds heartbeatTimeout,
                                                   std::uint64_t stops, const Deadline& deadline,
                                                   const QString& context) {
    const auto epoch = sendSection(section, name, stops, deadline, context);
    return epoch ? beginSection(*epoch, holding, heartbeatTimeout, context) : Result<MotionId>(epoch.error());
}

std::uint64_t Controller::stop(StopCause cause) {
    const std::uint64_t epoch = d_->mailbox.stop(cause, d_->now());
    d_->loop.permitForce(false);  // after the stop: see setForceMode()
    d_->link.wake();
    return epoch;
}

std::uint64_t Controller::stops() const {
    return d_->mailbox.epoch().stops();
}

bool Controller::end(MotionId motion, StopCause cause) {
    const bool ended = d_->mailbox.end(motion, cause, d_->now());
    d_->link.wake();
    return ended;
}

MotionState Controller::motionState(MotionId motion) const {
    return d_->mailbox.epoch().state(motion);
}

ControllerStatus Controller::status() const {
    ControllerStatus status = d_->loop.status();
    status.fresh = d_->now() - status.dataTimeNs <= d_->dataTimeoutNs();
    if (status.inControl && !status.fresh) {
        status.inControl = false;
        status.loss = ControlLoss::DataStale;
    }
    return status;
}

void Controller::setCollisionCheck(std::shared_ptr<const collision::CollisionCheck> check) {
    d_->loop.setCollisionCheck(std::move(check));
}

JointLimits Controller::jointLimits() const {
    const ArmLimits arm = d_->program.arm();
    return {arm.minPosition, arm.maxPosition, arm.maxSpeed};
}

std::uint16_t Controller::localPort() const {
    return d_->link.localPort();
}

bool Controller::isConnected() const {
    return d_->link.isRunning();
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
        // Set the cap before stopping: a motion that starts in between uses the new cap or is stopped.
        d_->loop.setSpeedCap(metresPerSecond);
        stop(StopCause::SelectionChanged);
    }
    return {};
}

const ControllerOptions& Controller::options() const {
    return d_->options;
}

SoftwareVersion Controller::version() const {
    return d_->program.version();
}

}  // namespace tiller::control
