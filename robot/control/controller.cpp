// SPDX-License-Identifier: MIT
#include "robot/control/controller.h"

#include <QStringList>
#include <algorithm>
#include <cmath>

#include "robot/control/controller_private.h"
#include "robot/kinematics/speed_bounds.h"
#include "robot/realtime/thread_priority.h"

namespace tiller::control {

namespace {

// How often the control thread looks up when no data come. In real time only: whether they are late is
// decided by the Clock.
constexpr std::chrono::milliseconds kLookUp(4);

bool isFinite(const JogTarget& target) {
    return target.twist.linear.allFinite() && target.twist.angular.allFinite() && target.qd.allFinite() &&
           target.T_base_frame.allFinite();
}

bool isPositive(double value) {
    return std::isfinite(value) && value > 0;
}

Error invalid(const QString& context, const QString& what) {
    return {ErrorCode::InvalidArgument, context, what};
}

QString degrees(double radians) {
    constexpr double kDegreesPerRadian = 57.29577951308232;
    return QString::number(radians * kDegreesPerRadian, 'f', 1);
}

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
    d_->stopThread();
    auto taken = d_->take(deadline);
    if (!taken) {
        d_->stopThread();
        d_->loop.publishLoss(ControlLoss::NotTaken);
    }
    return taken;
}

void Controller::release() {
    const std::lock_guard lock(d_->taking);
    d_->mailbox.stop(StopCause::ControlLost, d_->now());
    if (!d_->running) {
        d_->stopThread();
        return;
    }
    d_->loop.requestEnd();
    const Deadline patience = Deadline::after(std::chrono::milliseconds(600));
    while (d_->running && d_->loop.isInControl() && !patience.hasExpired()) {
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    d_->stopThread();
    d_->loop.publishLoss(ControlLoss::Released);
}

void Controller::Private::run() {
    realtime::nameThread("control");
    loop.setPriorityGranted(options.priority <= 0 || realtime::requestThreadPriority(options.priority).ok());
    std::vector<double> values(connection->outputs().size());
    const auto send = [this](const Command& command) {
        const auto inputs = encode(command);
        return connection->sendInputs(0, inputs) != rtde::Connection::Send::Failed;
    };
    bool alive = true;
    while (alive && !quit.load(std::memory_order_acquire)) {
        switch (connection->readPackage(values, kLookUp)) {
            case rtde::Connection::Read::Package:
                alive = send(loop.tick(layout.decode(values, now())));
                break;
            case rtde::Connection::Read::Nothing: {
                Command command;
                if (loop.fallback(now(), command)) {
                    alive = send(command);
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
    if (now() - status.dataTimeNs > kMaxDataAgeNs) {
        return {ErrorCode::LinkLost, context, QStringLiteral("no data for more than 100 ms")};
    }
    if (status.roundTripMs > kMaxRoundTripMs) {
        return {
            ErrorCode::LinkLost, context,
            QStringLiteral("commands take %1 ms to the robot and back").arg(status.roundTripMs, 0, 'f', 0)};
    }
    return {};
}

Result<JogId> Controller::startJog(const JogTarget& target) {
    const QString context = QStringLiteral("start a jog");
    if (!isFinite(target)) {
        return invalid(context, QStringLiteral("not a number"));
    }
    if (const Error error = d_->obstacle(context); error.code != ErrorCode::None) {
        return error;
    }
    MotionCommand command;
    command.kind = MotionCommand::Kind::Jog;
    command.jog = target;
    return d_->mailbox.start(command, d_->now());
}

bool Controller::refreshJog(JogId jog) {
    return d_->mailbox.refresh(jog, d_->now());
}

bool Controller::refreshJog(JogId jog, const JogTarget& target) {
    if (!isFinite(target)) {
        end(jog, StopCause::ApiCall);
        return false;
    }
    return d_->mailbox.refresh(jog, target, d_->now());
}

Result<MoveId> Controller::moveJ(const JointPositions& target, const MoveParameters& parameters) {
    const QString context = QStringLiteral("start a MoveJ");
    if (!target.allFinite() || !isPositive(parameters.speed) || !isPositive(parameters.acceleration)) {
        return invalid(context, QStringLiteral("target, speed and acceleration must be positive numbers"));
    }
    ArmLimits arm;
    {
        const std::lock_guard lock(d_->arm);
        arm = d_->armLimits;
    }
    for (int joint = 0; joint < kJointCount; ++joint) {
        const auto i = static_cast<std::size_t>(joint);
        if (target[joint] < arm.minPosition[i] || target[joint] > arm.maxPosition[i]) {
            return Error{ErrorCode::LimitExceeded, context,
                         QStringLiteral("%1 at %2 deg is outside %3 to %4 deg")
                             .arg(QLatin1String(kJointNames[i]), degrees(target[joint]),
                                  degrees(arm.minPosition[i]), degrees(arm.maxPosition[i]))};
        }
        if (parameters.speed > arm.maxSpeed[i] || parameters.acceleration > kJointAccelerationLimit) {
            return Error{ErrorCode::LimitExceeded, context,
                         QStringLiteral("%1 cannot turn faster than %2 deg/s")
                             .arg(QLatin1String(kJointNames[i]), degrees(arm.maxSpeed[i]))};
        }
    }
    if (const Error error = d_->obstacle(context); error.code != ErrorCode::None) {
        return error;
    }
    MotionCommand command;
    const ControllerStatus status = d_->loop.status();
    command.kind = MotionCommand::Kind::MoveJ;
    command.held = parameters.holding == Holding::Held;
    command.target = target.array();
    command.speed =
        std::min(parameters.speed,
                 kinematics::jointSpeedBound(arm.dh, JointPositions(status.q), target,
                                             Pose::fromArray(status.tcpOffset), d_->options.limits.tcpSpeed));
    command.acceleration = parameters.acceleration;
    return d_->mailbox.start(command, d_->now());
}

Result<MoveId> Controller::moveL(const Pose& target, const MoveParameters& parameters) {
    const QString context = QStringLiteral("start a MoveL");
    if (!target.allFinite() || !isPositive(parameters.speed) || !isPositive(parameters.acceleration)) {
        return invalid(context, QStringLiteral("target, speed and acceleration must be positive numbers"));
    }
    constexpr double kRounding = 1e-9;
    if (parameters.speed > d_->options.limits.tcpSpeed + kRounding) {
        return Error{ErrorCode::LimitExceeded, context,
                     QStringLiteral("%1 m/s is above the cap of %2 m/s")
                         .arg(parameters.speed)
                         .arg(d_->options.limits.tcpSpeed)};
    }
    if (const Error error = d_->obstacle(context); error.code != ErrorCode::None) {
        return error;
    }
    MotionCommand command;
    ArmLimits arm;
    {
        const std::lock_guard lock(d_->arm);
        arm = d_->armLimits;
    }
    const ControllerStatus status = d_->loop.status();
    const MotionLimits& limits = d_->options.limits;
    command.kind = MotionCommand::Kind::MoveL;
    command.held = parameters.holding == Holding::Held;
    command.target = target.array();
    command.speed =
        std::min(parameters.speed, kinematics::lineSpeedBound(arm.dh, JointPositions(status.q), target,
                                                              Pose::fromArray(status.tcpOffset),
                                                              limits.tcpSpeed, limits.tcpRotationSpeed));
    command.acceleration = parameters.acceleration;
    return d_->mailbox.start(command, d_->now());
}

bool Controller::refreshMove(MoveId move) {
    return d_->mailbox.refresh(move, d_->now());
}

void Controller::stop(StopCause cause) {
    d_->mailbox.stop(cause, d_->now());
}

bool Controller::end(MotionId motion, StopCause cause) {
    return d_->mailbox.end(motion, cause, d_->now());
}

MotionState Controller::motionState(MotionId motion) const {
    return d_->mailbox.epoch().state(motion);
}

ControllerStatus Controller::status() const {
    return d_->loop.status();
}

const MotionLimits& Controller::limits() const {
    return d_->options.limits;
}

SoftwareVersion Controller::version() const {
    const std::lock_guard lock(d_->arm);
    return d_->version;
}

}  // namespace tiller::control
