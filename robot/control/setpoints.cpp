// SPDX-License-Identifier: MIT
#include "robot/control/setpoints.h"

#include <algorithm>
#include <cmath>

#include "robot/control/detail/argument_check.h"
#include "robot/control/detail/controller_private.h"
#include "robot/control/detail/setpoint_command.h"
#include "robot/control/motions.h"

namespace tiller::control {

namespace {

std::array<double, 6> six(const Vector6& v) {
    std::array<double, 6> out{};
    std::copy_n(v.data(), out.size(), out.begin());
    return out;
}

template <class Target>
Target targetOf(const std::array<double, 6>& values) {
    if constexpr (std::is_same_v<Target, Pose>) {
        return Pose::fromArray(values);
    } else {
        return Target(values);
    }
}

double orSame(double rotation, double linear) {
    return rotation == 0 ? linear : rotation;
}

}  // namespace

Error SetpointRules::check(const JointPositions& target) const {
    return ArgumentCheck("send a servo target").joints("target", target, arm).error();
}
Error SetpointRules::check(const Pose& target) const {
    return ArgumentCheck("send a servo target").pose("target", target).error();
}
Error SetpointRules::check(const JointVelocities& target) const {
    return ArgumentCheck("send joint speeds").jointSpeeds("target", target, arm).error();
}
Error SetpointRules::check(const Twist& target) const {
    return ArgumentCheck("send a tool speed").twist("target", target, toolSpeed).error();
}
Error SetpointRules::check(const JointTorques& target) const {
    return ArgumentCheck("send joint torques").torques("target", target, arm).error();
}

namespace {

Error tooFar(const QString& what, double way, double limit, const QString& unit) {
    return {ErrorCode::LimitExceeded, QStringLiteral("send a servo target"),
            QStringLiteral("target: %1 would move by %2 %4 in one step; the maximum is %3 %4")
                .arg(what)
                .arg(way, 0, 'f', 3)
                .arg(limit, 0, 'f', 3)
                .arg(unit)};
}

}  // namespace

double stepTime(double since, double rules) {
    return std::min(std::max(since, rules), kMaxServoStep);
}

Error SetpointRules::step(const JointPositions& from, const JointPositions& to, double seconds) const {
    for (int joint = 0; joint < kJointCount; ++joint) {
        const auto i = static_cast<std::size_t>(joint);
        const double way = std::abs(to[joint] - from[joint]);
        const double limit = arm.maxSpeed[i] * seconds + kJointLeeway;
        if (way > limit) {
            return tooFar(QString::fromLatin1(kJointNames[i]), way, limit, QStringLiteral("rad"));
        }
    }
    return {};
}

Error SetpointRules::step(const Pose& from, const Pose& to, double seconds) const {
    const double way = (to.position - from.position).norm();
    const double limit = kHighestToolSpeed * seconds + kToolLeeway;
    if (way > limit) {
        return tooFar(QStringLiteral("the TCP"), way, limit, QStringLiteral("m"));
    }
    const double turn =
        Eigen::AngleAxisd(rotationMatrix(from.rotation).transpose() * rotationMatrix(to.rotation)).angle();
    const double most = highestJointSpeed(arm) * seconds + kJointLeeway;
    return turn > most ? tooFar(QStringLiteral("the orientation"), turn, most, QStringLiteral("rad"))
                       : Error();
}

Error SetpointRules::check(const ServoParameters& p) const {
    constexpr double kLongest = 10.0;
    return ArgumentCheck("servo parameters")
        .range("duration", p.duration, 0, kLongest, "s")
        .range("lookahead", p.lookahead, 0.03, 0.2, "s")
        .range("gain", p.gain, 100, 2000, "")
        .error();
}
Error SetpointRules::check(const CircularServoParameters& p) const {
    return ArgumentCheck("servo parameters")
        .positive("speed", p.speed, toolSpeed, "m/s", "mm/s")
        .positive("acceleration", p.acceleration, kHighestToolAcceleration, "m/s2", "mm/s2")
        .range("blend", p.blend, 0, kHighestBlend, "m")
        .error();
}
Error SetpointRules::check(const SpeedParameters& p) const {
    return ArgumentCheck("speed parameters")
        .positive("acceleration", p.acceleration, kHighestToolAcceleration, "m/s2 or rad/s2", "mm/s2")
        .positive("rotationAcceleration", orSame(p.rotationAcceleration, p.acceleration),
                  kHighestToolAcceleration, "rad/s2", "deg/s2")
        .range("duration", p.duration, 0, 3600, "s")
        .pose("T_base_frame", p.T_base_frame)
        .error();
}
Error SetpointRules::check(const TorqueParameters& p) const {
    ArgumentCheck check("torque parameters");
    for (std::size_t joint = 0; joint < p.viscousScale.size(); ++joint) {
        check.range("viscousScale", p.viscousScale[joint], 0, 1, "")
            .range("coulombScale", p.coulombScale[joint], 0, 1, "");
    }
    return check.error();
}

void fill(MotionCommand& command, const JointPositions& target) {
    command.target = target.array();
    command.choice = 1;
}
void fill(MotionCommand& command, const Pose& target) {
    command.target = target.array();
    command.choice = 1;
}
void fill(MotionCommand& command, const JointVelocities& target) {
    command.target = six(target.values);
}
void fill(MotionCommand& command, const Twist& target) {
    command.target = six(target.vector());
}
void fill(MotionCommand& command, const JointTorques& target) {
    command.target = target.array();
    command.choice = 1;
}

void fill(MotionCommand& command, const ServoParameters& p, double period) {
    command.speed = p.duration > 0 ? p.duration : period;
    command.acceleration = p.lookahead;
    command.rotationAcceleration = p.gain;
}
void fill(MotionCommand& command, const CircularServoParameters& p, double) {
    command.speed = p.speed;
    command.acceleration = p.acceleration;
    command.rotationAcceleration = p.blend;
}
void fill(MotionCommand& command, const SpeedParameters& p, double) {
    command.acceleration = p.acceleration;
    command.rotationAcceleration = orSame(p.rotationAcceleration, p.acceleration);
    command.speed = p.duration;
    command.choice = static_cast<std::int32_t>(p.frame);
    const Eigen::Vector3d& rotation = p.T_base_frame.rotation;
    command.rotation = {rotation.x(), rotation.y(), rotation.z()};
}
// Two scales packed into one number; spread_scales() in control.script separates them.
void fill(MotionCommand& command, const TorqueParameters& p, double) {
    const auto packed = [&p](std::size_t joint) {
        constexpr double kThousand = 1000;
        return (std::round(p.viscousScale[joint] * kThousand) + 0.25 + p.coulombScale[joint] / 2) / kThousand;
    };
    command.speed = packed(0);
    command.acceleration = packed(1);
    command.rotationAcceleration = packed(2);
    command.rotation = {packed(3), packed(4), packed(5)};
}

SetpointRules rulesOf(Controller& controller) {
    auto& d = ControllerAccess::of(controller);
    return {d.program.arm(), std::min(d.limitsNow().tcpSpeed, kHighestToolSpeed)};
}

template <class Target, class Parameters>
Result<void> Setpoints<Target, Parameters>::send(const Target& target) {
    return send(target, parameters_);
}

template <class Target, class Parameters>
Result<void> Setpoints<Target, Parameters>::send(const Target& target, const Parameters& parameters) {
    Controller* const controller = MotionAccess::controller(motion_);
    if (controller == nullptr) {
        return Error{ErrorCode::Stopped, QStringLiteral("send a target"), QStringLiteral("not started")};
    }
    auto& d = ControllerAccess::of(*controller);
    const SetpointRules rules = rulesOf(*controller);
    if (const Error error = rules.check(target); error.code != ErrorCode::None) {
        return error;
    }
    if (const Error error = rules.check(parameters); error.code != ErrorCode::None) {
        return error;
    }
    MotionCommand command;
    fill(command, target);
    fill(command, parameters, d.program.version().controlPeriod());
    if constexpr (std::is_same_v<Parameters, ServoParameters>) {
        command.choice = parameters.guarded ? 1 : 2;
    }
    Error refused;
    const auto mayFollow = [&](const MotionCommand& before, std::int64_t sinceNs) {
        if constexpr (std::is_same_v<Parameters, ServoParameters>) {
            if (!parameters.guarded) {
                return true;
            }
            const bool first = before.choice == 0;
            const ControllerStatus status = first ? d.loop.status() : ControllerStatus();
            const auto here = std::is_same_v<Target, Pose> ? status.tcpPose : status.q;
            refused = rules.step(targetOf<Target>(first ? here : before.target), target,
                                 stepTime(first ? 0 : static_cast<double>(sinceNs) / 1e9, command.speed));
        }
        return refused.code == ErrorCode::None;
    };
    switch (d.mailbox.changeIf(motion_.id(), command, d.now(), mayFollow)) {
        case Mailbox::Change::Done:
            d.link.wake();
            return {};
        case Mailbox::Change::Refused:
            return refused;
        case Mailbox::Change::Ended:
            break;
    }
    return Error{ErrorCode::Stopped, QStringLiteral("send a target"), QStringLiteral("the stream has ended")};
}

template class Setpoints<JointPositions, ServoParameters>;
template class Setpoints<Pose, ServoParameters>;
template class Setpoints<Pose, CircularServoParameters>;
template class Setpoints<JointVelocities, SpeedParameters>;
template class Setpoints<Twist, SpeedParameters>;
template class Setpoints<JointTorques, TorqueParameters>;

}  // namespace tiller::control
