// SPDX-License-Identifier: MIT
#include "robot/control/motions.h"

#include <QStringList>
#include <algorithm>

#include "robot/control/detail/argument_check.h"
#include "robot/control/detail/controller_private.h"
#include "robot/kinematics/arm_kinematics.h"
#include "robot/kinematics/speed_bounds.h"

namespace tiller::control {

namespace {

constexpr SoftwareVersion kHasContact{5, 4, 0, 0};
/// [m/s2] and [rad/s2]: a stop that brakes more softly is none.
constexpr double kSoftestBrake = 0.1;

MotionCommand program(ScriptCommand what, Holding holding) {
    MotionCommand command;
    command.kind = MotionCommand::Kind::Program;
    command.program = static_cast<std::int32_t>(what);
    command.held = holding == Holding::Held;
    return command;
}

/// The joint positions nearest to where the arm stands, by the dimensions the robot told.
std::optional<JointPositions> reach(const ArmLimits& arm, const ControllerStatus& status,
                                    const Pose& target) {
    return kinematics::inverseNearest(arm.dh, target, Pose::fromArray(status.tcpOffset),
                                      JointPositions(status.q));
}

Error outOfReach(const char* context, const char* name) {
    return {ErrorCode::NoSolution, QString::fromLatin1(context),
            QStringLiteral("%1: the arm cannot reach this pose").arg(QLatin1String(name))};
}

ArgumentCheck jointMove(const char* context, const MoveParameters& parameters, const ArmLimits& arm) {
    return ArgumentCheck(context)
        .positive("speed", parameters.speed, highestJointSpeed(arm), "rad/s", "deg/s")
        .positive("acceleration", parameters.acceleration, kJointAccelerationLimit, "rad/s2", "deg/s2");
}

ArgumentCheck toolMove(const char* context, const MoveParameters& parameters, double cap) {
    return ArgumentCheck(context)
        .positive("speed", parameters.speed, std::min(cap, kHighestToolSpeed), "m/s", "mm/s")
        .positive("acceleration", parameters.acceleration, kHighestToolAcceleration, "m/s2", "mm/s2");
}

/// The same path, no faster than the cap on TCP and elbow allows, and ending without a blend.
Result<MotionPath> fitted(const MotionPath& path, const ArmLimits& arm, const ControllerStatus& status,
                          const MotionLimits& limits) {
    MotionPath out = path;
    out.back().blend = 0;
    const Pose tcp = Pose::fromArray(status.tcpOffset);
    const auto lineBound = [&](const JointPositions& from, const Pose& to) {
        return kinematics::lineSpeedBound(arm.dh, from, to, tcp, limits.tcpSpeed, limits.tcpRotationSpeed);
    };
    JointPositions q(status.q);
    for (std::size_t i = 0; i < out.size(); ++i) {
        PathEntry& entry = out[i];
        JointPositions next = q;
        if (const auto* joints = std::get_if<JointPositions>(&entry.target)) {
            const ArgumentCheck check = ArgumentCheck("start a path").joints("target", *joints, arm);
            if (!check.ok()) {
                Error error = check.error();
                error.controllerMessage.prepend(QStringLiteral("entry %1, ").arg(i + 1));
                return error;
            }
            next = *joints;
        } else if (const auto found =
                       kinematics::inverseNearest(arm.dh, std::get<Pose>(entry.target), tcp, q)) {
            next = *found;
        } else {
            return Error{ErrorCode::NoSolution, QStringLiteral("start a path"),
                         QStringLiteral("entry %1, target: the arm cannot reach this pose").arg(i + 1)};
        }
        if (entry.kind == PathEntry::Kind::MoveJ) {
            entry.speed =
                std::min(entry.speed, kinematics::jointSpeedBound(arm.dh, q, next, tcp, limits.tcpSpeed));
        } else if (entry.speed > limits.tcpSpeed) {
            return Error{ErrorCode::LimitExceeded, QStringLiteral("start a path"),
                         QStringLiteral("entry %1, speed: %2 is above %3 m/s")
                             .arg(i + 1)
                             .arg(entry.speed)
                             .arg(limits.tcpSpeed)};
        } else {
            // An arc is looked at along its two chords.
            JointPositions from = q;
            if (entry.kind == PathEntry::Kind::MoveC && entry.via) {
                Pose middle = kinematics::forwardTcp(arm.dh, q, tcp);
                const auto* joints = std::get_if<JointPositions>(&*entry.via);
                middle.position = joints != nullptr ? kinematics::forwardTcp(arm.dh, *joints, tcp).position
                                                    : std::get<Pose>(*entry.via).position;
                entry.speed = std::min(entry.speed, lineBound(from, middle));
                from = kinematics::inverseNearest(arm.dh, middle, tcp, from).value_or(from);
            }
            entry.speed = std::min(entry.speed, lineBound(from, kinematics::forwardTcp(arm.dh, next, tcp)));
        }
        q = next;
    }
    return out;
}

}  // namespace

Result<Motion> Motions::moveJ(const JointPositions& target, const MoveParameters& parameters) {
    const auto id = controller_->moveJ(target, parameters);
    if (!id) {
        return id.error();
    }
    return MotionAccess::make(*controller_, *id, MotionKind::MoveJ, controller_->status().q, target.array());
}

Result<Motion> Motions::moveL(const Pose& target, const MoveParameters& parameters) {
    if (target.allFinite() && controller_->status().inControl) {
        const auto& d = ControllerAccess::of(*controller_);
        ArgumentCheck check = toolMove("start a MoveL", parameters, d.limitsNow().tcpSpeed);
        if (check.pose("target", target).ok() && !reach(d.armNow(), controller_->status(), target)) {
            return outOfReach("start a MoveL", "target");
        }
    }
    const auto id = controller_->moveL(target, parameters);
    if (!id) {
        return id.error();
    }
    return MotionAccess::make(*controller_, *id, MotionKind::MoveL, controller_->status().tcpPose,
                              target.array());
}

Result<Motion> Motions::moveJ(const Pose& target, const MoveParameters& parameters) {
    constexpr auto kContext = "start a MoveJ to a pose";
    auto& d = ControllerAccess::of(*controller_);
    const std::uint64_t stops = d.mailbox.epoch().stops();
    const ArmLimits arm = d.armNow();
    const ArgumentCheck check = jointMove(kContext, parameters, arm).pose("target", target);
    if (!check.ok()) {
        return check.error();
    }
    if (const Error error = d.obstacle(QString::fromLatin1(kContext)); error.code != ErrorCode::None) {
        return error;
    }
    const ControllerStatus status = controller_->status();
    const auto q = reach(arm, status, target);
    if (!q) {
        return outOfReach(kContext, "target");
    }
    MotionCommand command = program(ScriptCommand::MoveJToPose, parameters.holding);
    command.target = target.array();
    command.speed =
        std::min(parameters.speed,
                 kinematics::jointSpeedBound(arm.dh, JointPositions(status.q), *q,
                                             Pose::fromArray(status.tcpOffset), d.limitsNow().tcpSpeed));
    command.acceleration = parameters.acceleration;
    const auto id = d.start(command, stops, QString::fromLatin1(kContext));
    if (!id) {
        return id.error();
    }
    return MotionAccess::make(*controller_, *id, MotionKind::MoveJ, status.q, q->array());
}

Result<Motion> Motions::moveL(const JointPositions& target, const MoveParameters& parameters) {
    constexpr auto kContext = "start a MoveL to joint positions";
    auto& d = ControllerAccess::of(*controller_);
    const std::uint64_t stops = d.mailbox.epoch().stops();
    const ArmLimits arm = d.armNow();
    const MotionLimits limits = d.limitsNow();
    const ArgumentCheck check = toolMove(kContext, parameters, limits.tcpSpeed).joints("target", target, arm);
    if (!check.ok()) {
        return check.error();
    }
    if (const Error error = d.obstacle(QString::fromLatin1(kContext)); error.code != ErrorCode::None) {
        return error;
    }
    const ControllerStatus status = controller_->status();
    const Pose tcp = Pose::fromArray(status.tcpOffset);
    const Pose pose = kinematics::forwardTcp(arm.dh, target, tcp);
    MotionCommand command = program(ScriptCommand::MoveLToJoints, parameters.holding);
    command.target = target.array();
    command.speed =
        std::min(parameters.speed, kinematics::lineSpeedBound(arm.dh, JointPositions(status.q), pose, tcp,
                                                              limits.tcpSpeed, limits.tcpRotationSpeed));
    command.acceleration = parameters.acceleration;
    const auto id = d.start(command, stops, QString::fromLatin1(kContext));
    if (!id) {
        return id.error();
    }
    return MotionAccess::make(*controller_, *id, MotionKind::MoveL, status.tcpPose, pose.array());
}

Result<Motion> Motions::movePath(const MotionPath& path, const Deadline& start, Holding holding) {
    const QString context = QStringLiteral("start a path");
    if (const auto checked = checkPath(path); !checked) {
        return checked.error();
    }
    auto& d = ControllerAccess::of(*controller_);
    const std::uint64_t stops = d.mailbox.epoch().stops();
    if (const Error error = d.obstacle(context); error.code != ErrorCode::None) {
        return error;
    }
    const auto fit = fitted(path, d.armNow(), controller_->status(), d.limitsNow());
    if (!fit) {
        return fit.error();
    }
    QStringList lines;
    for (const PathEntry& entry : *fit) {
        lines.append(QStringLiteral("tiller_waypoint = %1").arg(lines.size() / 2 + 1));
        lines.append(pathMove(entry));
    }
    const auto id =
        d.startSection(lines.join(QLatin1Char('\n')), QStringLiteral("path"), holding, stops, start, context);
    if (!id) {
        return id.error();
    }
    return MotionAccess::path(*controller_, *id, static_cast<int>(path.size()));
}

Result<Motion> Motions::moveUntilContact(const Twist& twist, const Twist& direction, double acceleration,
                                         const Deadline& start, Sought sought) {
    constexpr auto kContext = "move until contact";
    auto& d = ControllerAccess::of(*controller_);
    const std::uint64_t stops = d.mailbox.epoch().stops();
    ArgumentCheck check =
        ArgumentCheck(kContext)
            .twist("twist", twist, std::min(d.limitsNow().tcpSpeed, kHighestToolSpeed))
            .finite("direction", direction.vector().data(), 6)
            .positive("acceleration", acceleration, kHighestToolAcceleration, "m/s2", "mm/s2");
    if (!check.ok()) {
        return check.error();
    }
    const QString context = QString::fromLatin1(kContext);
    if (twist.isZero()) {
        return Error{ErrorCode::InvalidArgument, context, QStringLiteral("twist: it moves nothing")};
    }
    if (const Error error = d.obstacle(context); error.code != ErrorCode::None) {
        return error;
    }
    if (const auto known = d.needs(kHasContact, {}, context); !known) {
        return known.error();
    }
    const Vector6 values = direction.vector();
    const std::span<const double> numbers(values.data(), 6);
    if (const auto set = d.request(RequestKind::WatchContact, 0, numbers, context, start); !set) {
        return set.error();
    }
    MotionCommand command = program(ScriptCommand::UntilContact, Holding::Free);
    const Vector6 speeds = twist.vector();
    std::copy_n(speeds.data(), 6, command.target.begin());
    constexpr double kSlowestReturn = 0.01;  // [m/s]
    command.speed = std::max(twist.linear.norm(), kSlowestReturn);
    command.acceleration = acceleration;
    command.rotationAcceleration = acceleration;
    command.choice = sought == Sought::AnyContact ? 1 : 0;
    const auto id = d.start(command, stops, context);
    return id ? MotionAccess::make(*controller_, *id, MotionKind::UntilContact) : Result<Motion>(id.error());
}

Result<Motion> Motions::stopJ(double deceleration, StopCause cause) {
    const ArgumentCheck check =
        ArgumentCheck("stopj")
            .positive("deceleration", deceleration, kJointAccelerationLimit, "rad/s2", "deg/s2")
            .range("deceleration", deceleration, kSoftestBrake, kJointAccelerationLimit, "rad/s2");
    if (!check.ok()) {
        return check.error();
    }
    auto& d = ControllerAccess::of(*controller_);
    const MotionId id = d.mailbox.stop({0, Brake::Along::Joints, deceleration, deceleration}, cause, d.now());
    d.loop.permitForce(false);
    d.wake();
    return MotionAccess::make(*controller_, id, MotionKind::Stop);
}

Result<Motion> Motions::stopL(double deceleration, double rotationDeceleration, StopCause cause) {
    const double rotation = rotationDeceleration == 0 ? deceleration : rotationDeceleration;
    const ArgumentCheck check =
        ArgumentCheck("stopl")
            .positive("deceleration", deceleration, kHighestToolAcceleration, "m/s2", "mm/s2")
            .positive("rotationDeceleration", rotation, kHighestToolAcceleration, "rad/s2", "deg/s2")
            .range("deceleration", deceleration, kSoftestBrake, kHighestToolAcceleration, "m/s2")
            .range("rotationDeceleration", rotation, kSoftestBrake, kHighestToolAcceleration, "rad/s2");
    if (!check.ok()) {
        return check.error();
    }
    auto& d = ControllerAccess::of(*controller_);
    const MotionId id = d.mailbox.stop({0, Brake::Along::Line, deceleration, rotation}, cause, d.now());
    d.loop.permitForce(false);
    d.wake();
    return MotionAccess::make(*controller_, id, MotionKind::Stop);
}

}  // namespace tiller::control
