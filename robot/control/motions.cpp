// SPDX-License-Identifier: MIT
#include "robot/control/motions.h"

#include <QStringList>
#include <algorithm>

#include "robot/control/detail/argument_check.h"
#include "robot/control/detail/controller_private.h"
#include "robot/control/detail/setpoint_command.h"
#include "robot/kinematics/arm_kinematics.h"
#include "robot/kinematics/speed_bounds.h"

namespace tiller::control {

namespace {

using std::chrono::milliseconds;

constexpr SoftwareVersion kHasContact{5, 4, 0, 0};
/// Minimum deceleration of a stop [m/s2] and [rad/s2].
constexpr double kSoftestBrake = 0.1;

MotionCommand program(ScriptCommand what, Holding holding) {
    MotionCommand command;
    command.kind = MotionCommand::Kind::Program;
    command.program = static_cast<std::int32_t>(what);
    command.held = holding == Holding::Held;
    return command;
}

/// Joint positions for the pose that are nearest to the current joint positions, computed with the dimensions
/// reported by the robot.
std::optional<JointPositions> reach(const ArmLimits& arm, const ControllerStatus& status,
                                    const Pose& target) {
    return kinematics::inverseNearest(arm.dh, target, Pose::fromArray(status.tcpOffset),
                                      JointPositions(status.q));
}

Error outOfReach(const char* context, const char* name) {
    return {ErrorCode::NoSolution, QString::fromLatin1(context),
            QStringLiteral("%1: the arm cannot reach this pose").arg(QLatin1String(name))};
}

Error inEntry(std::size_t index, Error error) {
    error.controllerMessage.prepend(QStringLiteral("entry %1, ").arg(index + 1));
    return error;
}

ArgumentCheck& checkHeartbeatTimeout(ArgumentCheck& check, milliseconds heartbeatTimeout) {
    using Seconds = std::chrono::duration<double>;
    return check.range("heartbeatTimeout", Seconds(heartbeatTimeout).count(), Seconds(kHoldTime).count(),
                       Seconds(kMaxHeartbeatTimeout).count(), "s");
}

/// Heartbeat timeout of a command; 0: default.
milliseconds effectiveHeartbeatTimeout(Holding holding, milliseconds heartbeatTimeout) {
    return holding == Holding::Free && heartbeatTimeout > kHoldTime ? heartbeatTimeout : milliseconds(0);
}

/// Speed and acceleration of a move, with defaults applied.
struct Dynamics {
    double speed = 0;
    double acceleration = 0;
};

Dynamics jointDynamics(const MoveParameters& parameters) {
    constexpr double kSpeed = 1.05;        // [rad/s]
    constexpr double kAcceleration = 1.4;  // [rad/s2]
    return {parameters.speed.value_or(kSpeed), parameters.acceleration.value_or(kAcceleration)};
}

Dynamics toolDynamics(const MoveParameters& parameters, double cap) {
    constexpr double kSpeed = 0.25;        // [m/s]
    constexpr double kAcceleration = 1.2;  // [m/s2]
    return {parameters.speed.value_or(std::min(kSpeed, cap)),
            parameters.acceleration.value_or(kAcceleration)};
}

ArgumentCheck jointMove(const char* context, const MoveParameters& parameters, const ArmLimits& arm) {
    const Dynamics given = jointDynamics(parameters);
    ArgumentCheck check(context);
    check.positive("speed", given.speed, highestJointSpeed(arm), "rad/s", "deg/s")
        .positive("acceleration", given.acceleration, kJointAccelerationLimit, "rad/s2", "deg/s2");
    return checkHeartbeatTimeout(check, parameters.heartbeatTimeout);
}

ArgumentCheck toolMove(const char* context, const MoveParameters& parameters, double cap) {
    const Dynamics given = toolDynamics(parameters, cap);
    ArgumentCheck check(context);
    check.toolSpeed("speed", given.speed, cap)
        .positive("acceleration", given.acceleration, kHighestToolAcceleration, "m/s2", "mm/s2");
    return checkHeartbeatTimeout(check, parameters.heartbeatTimeout);
}

LimiterKind kindOf(kinematics::SpeedLimit limit) {
    switch (limit) {
        case kinematics::SpeedLimit::Tcp:
            return LimiterKind::TcpSpeed;
        case kinematics::SpeedLimit::Elbow:
            return LimiterKind::ElbowSpeed;
        case kinematics::SpeedLimit::Rotation:
            return LimiterKind::RotationSpeed;
        case kinematics::SpeedLimit::None:
            break;
    }
    return LimiterKind::None;
}

/// Reduces the requested speed to the limits of TCP and elbow along this path.
MotionPlan planned(double length, const Dynamics& asked, const kinematics::SpeedBound& bound) {
    MotionPlan plan;
    plan.speed = std::min(asked.speed, bound.speed);
    if (bound.speed < asked.speed) {
        plan.limiter.kind = kindOf(bound.by);
        plan.limiter.scale = bound.speed / asked.speed;
    }
    plan.duration =
        std::chrono::duration<double>(kinematics::moveDuration(length, plan.speed, asked.acceleration));
    return plan;
}

/// Start position of a move and the limits that apply.
struct Beginning {
    const char* context;
    Controller& controller;
    std::uint64_t stops;  ///< read before all other values
    Controller::Private& d = ControllerAccess::of(controller);
    ArmLimits arm = d.program.arm();
    MotionLimits limits = d.limitsNow();
    ControllerStatus status = controller.status();
    JointPositions q{status.q};
    Pose tcpOffset = Pose::fromArray(status.tcpOffset);

    Error obstacle(const ArgumentCheck& check) const {
        return check.ok() ? d.obstacle(QString::fromLatin1(context)) : check.error();
    }

    /// The part of a command that all moves share.
    MotionCommand command(const MoveParameters& parameters, const std::array<double, 6>& target,
                          const MotionPlan& plan, double acceleration) const {
        MotionCommand command;
        command.held = parameters.holding == Holding::Held;
        command.heartbeatTimeout = effectiveHeartbeatTimeout(parameters.holding, parameters.heartbeatTimeout);
        command.target = target;
        command.speed = plan.speed;
        command.acceleration = acceleration;
        command.limiter = plan.limiter;
        return command;
    }

    Result<Motion> start(const MotionCommand& command, MotionKind kind, const std::array<double, 6>& from,
                         const std::array<double, 6>& to, const MotionPlan& plan) const {
        const auto id = d.start(command, stops, QString::fromLatin1(context));
        return id ? MotionAccess::move(controller, *id, kind, from, to, plan) : Result<Motion>(id.error());
    }
};

/// Moves to these joint positions. With `toPose`, the pose is sent, and the robot calculates the joint
/// positions.
Result<Motion> jointMoveTo(const Beginning& from, const JointPositions& target, const Pose* toPose,
                           const MoveParameters& parameters) {
    const Dynamics asked = jointDynamics(parameters);
    const MotionPlan plan = planned(
        (target.values - from.q.values).cwiseAbs().maxCoeff(), asked,
        kinematics::jointSpeedBound(from.arm.dh, from.q, target, from.tcpOffset, from.limits.tcpSpeed));
    MotionCommand command = from.command(parameters, toPose != nullptr ? toPose->array() : target.array(),
                                         plan, asked.acceleration);
    command.kind = toPose != nullptr ? MotionCommand::Kind::Program : MotionCommand::Kind::MoveJ;
    command.program = static_cast<std::int32_t>(ScriptCommand::MoveJToPose);
    return from.start(command, MotionKind::MoveJ, from.status.q, target.array(), plan);
}

/// Moves along a straight line to this pose. With `toJoints`, the target is sent as joint positions.
Result<Motion> lineTo(const Beginning& from, const Pose& target, const JointPositions* toJoints,
                      const MoveParameters& parameters) {
    const Dynamics asked = toolDynamics(parameters, from.limits.tcpSpeed);
    const MotionPlan plan =
        planned(kinematics::lineLength(Pose::fromArray(from.status.tcpPose), target), asked,
                kinematics::lineSpeedBound(from.arm.dh, from.q, target, from.tcpOffset, from.limits.tcpSpeed,
                                           from.limits.tcpRotationSpeed));
    MotionCommand command = from.command(parameters, toJoints != nullptr ? toJoints->array() : target.array(),
                                         plan, asked.acceleration);
    command.kind = toJoints != nullptr ? MotionCommand::Kind::Program : MotionCommand::Kind::MoveL;
    command.program = static_cast<std::int32_t>(ScriptCommand::MoveLToJoints);
    return from.start(command, MotionKind::MoveL, from.status.tcpPose, target.array(), plan);
}

/// The path, with speeds reduced to the limits of TCP and elbow, and without a blend at the last target.
Result<MotionPath> fitted(const MotionPath& path, const ArmLimits& arm, const ControllerStatus& status,
                          const MotionLimits& limits) {
    MotionPath out = path;
    out.back().blend = 0;
    const Pose tcp = Pose::fromArray(status.tcpOffset);
    const auto lineBound = [&](const JointPositions& from, const Pose& to) {
        return kinematics::lineSpeedBound(arm.dh, from, to, tcp, limits.tcpSpeed, limits.tcpRotationSpeed)
            .speed;
    };
    JointPositions q(status.q);
    for (std::size_t i = 0; i < out.size(); ++i) {
        PathEntry& entry = out[i];
        JointPositions next = q;
        if (const auto* joints = std::get_if<JointPositions>(&entry.target)) {
            const ArgumentCheck check = ArgumentCheck("start a path").joints("target", *joints, arm);
            if (!check.ok()) {
                return inEntry(i, check.error());
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
            entry.speed = std::min(entry.speed,
                                   kinematics::jointSpeedBound(arm.dh, q, next, tcp, limits.tcpSpeed).speed);
        } else {
            if (const auto check =
                    ArgumentCheck("start a path").toolSpeed("speed", entry.speed, limits.tcpSpeed);
                !check.ok()) {
                return inEntry(i, check.error());
            }
            // An arc is checked along two chords.
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

template <class Parameters>
Result<Motion> startStream(Controller& controller, std::uint64_t stops, ScriptCommand what, MotionKind kind,
                           const Parameters& parameters, Holding holding) {
    auto& d = ControllerAccess::of(controller);
    const QString context = QStringLiteral("start a stream");
    if (const Error error = rulesOf(controller).check(parameters); error.code != ErrorCode::None) {
        return error;
    }
    if (const Error error = d.obstacle(context); error.code != ErrorCode::None) {
        return error;
    }
    MotionCommand command = program(what, holding);
    fill(command, parameters, d.program.version().controlPeriod());
    const auto id = d.start(command, stops, context);
    return id ? MotionAccess::make(controller, *id, kind) : Result<Motion>(id.error());
}

}  // namespace

std::uint64_t Motions::stops() const {
    return stops_.value_or(controller_->stops());
}

Result<Motion> Motions::moveJ(const JointPositions& target, const MoveParameters& parameters) {
    const Beginning from{"start a MoveJ", *controller_, stops()};
    const ArgumentCheck check =
        jointMove(from.context, parameters, from.arm).joints("target", target, from.arm);
    if (const Error error = from.obstacle(check); error.code != ErrorCode::None) {
        return error;
    }
    return jointMoveTo(from, target, nullptr, parameters);
}

Result<Motion> Motions::moveJToPose(const Pose& target, const MoveParameters& parameters) {
    const Beginning from{"start a MoveJ to a pose", *controller_, stops()};
    const ArgumentCheck check = jointMove(from.context, parameters, from.arm).pose("target", target);
    if (const Error error = from.obstacle(check); error.code != ErrorCode::None) {
        return error;
    }
    const auto q = reach(from.arm, from.status, target);
    return q ? jointMoveTo(from, *q, &target, parameters) : outOfReach(from.context, "target");
}

Result<Motion> Motions::moveL(const Pose& target, const MoveParameters& parameters) {
    const Beginning from{"start a MoveL", *controller_, stops()};
    const ArgumentCheck check =
        toolMove(from.context, parameters, from.limits.tcpSpeed).pose("target", target);
    if (const Error error = from.obstacle(check); error.code != ErrorCode::None) {
        return error;
    }
    return reach(from.arm, from.status, target) ? lineTo(from, target, nullptr, parameters)
                                                : outOfReach(from.context, "target");
}

Result<Motion> Motions::moveLToJoints(const JointPositions& target, const MoveParameters& parameters) {
    const Beginning from{"start a MoveL to joint positions", *controller_, stops()};
    const ArgumentCheck check =
        toolMove(from.context, parameters, from.limits.tcpSpeed).joints("target", target, from.arm);
    if (const Error error = from.obstacle(check); error.code != ErrorCode::None) {
        return error;
    }
    return lineTo(from, kinematics::forwardTcp(from.arm.dh, target, from.tcpOffset), &target, parameters);
}

Result<Motion> Motions::movePath(const MotionPath& path, const Deadline& start, Holding holding,
                                 milliseconds heartbeatTimeout) {
    ArgumentCheck check("start a path");
    if (!checkHeartbeatTimeout(check, heartbeatTimeout).ok()) {
        return check.error();
    }
    const auto prepared = preparePath(path, start);
    return prepared ? startPath(*prepared, holding, heartbeatTimeout) : Result<Motion>(prepared.error());
}

Result<PreparedPath> Motions::preparePath(const MotionPath& path, const Deadline& start) {
    const QString context = QStringLiteral("start a path");
    if (const auto checked = checkPath(path); !checked) {
        return checked.error();
    }
    auto& d = ControllerAccess::of(*controller_);
    const std::uint64_t stops = this->stops();
    if (const Error error = d.obstacle(context); error.code != ErrorCode::None) {
        return error;
    }
    const auto fit = fitted(path, d.program.arm(), controller_->status(), d.limitsNow());
    if (!fit) {
        return fit.error();
    }
    QStringList lines;
    for (const PathEntry& entry : *fit) {
        lines.append(QStringLiteral("tiller_waypoint = %1").arg(lines.size() / 2 + 1));
        lines.append(pathMove(entry));
    }
    const auto epoch =
        d.sendSection(lines.join(QLatin1Char('\n')), QStringLiteral("path"), stops, start, context);
    if (!epoch) {
        return epoch.error();
    }
    PreparedPath prepared;
    prepared.epoch_ = *epoch;
    prepared.waypoints_ = static_cast<int>(path.size());
    return prepared;
}

Result<Motion> Motions::startPath(const PreparedPath& path, Holding holding, milliseconds heartbeatTimeout) {
    ArgumentCheck check("start a path");
    if (!checkHeartbeatTimeout(check, heartbeatTimeout).ok()) {
        return check.error();
    }
    auto& d = ControllerAccess::of(*controller_);
    const auto id = d.beginSection(path.epoch_, holding, effectiveHeartbeatTimeout(holding, heartbeatTimeout),
                                   QStringLiteral("start a path"));
    return id ? MotionAccess::path(*controller_, *id, path.waypoints_) : Result<Motion>(id.error());
}

Result<Motion> Motions::moveUntilContact(const Twist& twist, const Deadline& start,
                                         const ContactParameters& parameters) {
    constexpr auto kContext = "move until contact";
    auto& d = ControllerAccess::of(*controller_);
    const std::uint64_t stops = this->stops();
    ArgumentCheck check =
        ArgumentCheck(kContext)
            .twist("twist", twist, std::min(d.limitsNow().tcpSpeed, kHighestToolSpeed))
            .finite("direction", parameters.direction.vector().data(), 6)
            .positive("acceleration", parameters.acceleration, kHighestToolAcceleration, "m/s2", "mm/s2");
    if (!check.ok()) {
        return check.error();
    }
    const QString context = QString::fromLatin1(kContext);
    if (twist.isZero()) {
        return Error{ErrorCode::InvalidArgument, context, QStringLiteral("twist: all components are zero")};
    }
    if (const Error error = d.obstacle(context); error.code != ErrorCode::None) {
        return error;
    }
    if (const auto known = d.program.needs(kHasContact, {}, context); !known) {
        return known.error();
    }
    const Vector6 values = parameters.direction.vector();
    const std::span<const double> numbers(values.data(), 6);
    if (const auto set = d.requests.request(RequestKind::WatchContact, 0, numbers, context, start); !set) {
        return set.error();
    }
    MotionCommand command = program(ScriptCommand::UntilContact, parameters.holding);
    const Vector6 speeds = twist.vector();
    std::copy_n(speeds.data(), 6, command.target.begin());
    constexpr double kSlowestReturn = 0.01;  // [m/s]
    command.speed = std::max(twist.linear.norm(), kSlowestReturn);
    command.acceleration = parameters.acceleration;
    command.rotationAcceleration = parameters.acceleration;
    command.choice = parameters.sought == Sought::AnyContact ? 1 : 0;
    const auto id = d.start(command, stops, context);
    return id ? MotionAccess::make(*controller_, *id, MotionKind::UntilContact) : Result<Motion>(id.error());
}

Result<Jog> Motions::startJog(const JogTarget& target, Holding holding) {
    auto& d = ControllerAccess::of(*controller_);
    const std::uint64_t stops = this->stops();
    const QString context = QStringLiteral("start a jog");
    if (!isFinite(target)) {
        return Error{ErrorCode::InvalidArgument, context, QStringLiteral("target: a value is not a number")};
    }
    constexpr double kHighestForce = 1000.0;  // [N]; above the forces of all arms
    if (const auto check =
            ArgumentCheck("start a jog").range("contactForce", target.contactForce, 0, kHighestForce, "N");
        !check.ok()) {
        return check.error();
    }
    if (const Error error = d.obstacle(context); error.code != ErrorCode::None) {
        return error;
    }
    if (target.contactForce > 0 && !controller_->status().forceKnown) {
        return Error{ErrorCode::FieldUnknown, context, QStringLiteral("actual_TCP_force")};
    }
    MotionCommand command;
    command.kind = MotionCommand::Kind::Jog;
    command.held = holding == Holding::Held;
    command.jog = target;
    const auto id = d.start(command, stops, context);
    if (!id) {
        return id.error();
    }
    const bool turnsJoints = target.kind == JogTarget::Kind::Joint;
    return Jog(MotionAccess::make(*controller_, *id,
                                  turnsJoints ? MotionKind::JogJoints : MotionKind::JogCartesian));
}

Result<JointServo> Motions::startServoJ(const ServoParameters& parameters, Holding holding) {
    const auto motion =
        startStream(*controller_, stops(), ScriptCommand::ServoJ, MotionKind::ServoJ, parameters, holding);
    return motion ? Result<JointServo>(JointServo(*motion, parameters)) : motion.error();
}

Result<PoseServo> Motions::startServoL(const ServoParameters& parameters, Holding holding) {
    const auto motion =
        startStream(*controller_, stops(), ScriptCommand::ServoL, MotionKind::ServoL, parameters, holding);
    return motion ? Result<PoseServo>(PoseServo(*motion, parameters)) : motion.error();
}

Result<CircularServo> Motions::startServoC(const CircularServoParameters& parameters, Holding holding) {
    auto& d = ControllerAccess::of(*controller_);
    if (const auto known = d.program.knows("servoc", QStringLiteral("start a stream")); !known) {
        return known.error();
    }
    const auto motion =
        startStream(*controller_, stops(), ScriptCommand::ServoC, MotionKind::ServoC, parameters, holding);
    return motion ? Result<CircularServo>(CircularServo(*motion, parameters)) : motion.error();
}

Result<JointSpeed> Motions::startSpeedJ(const SpeedParameters& parameters, Holding holding) {
    const auto motion =
        startStream(*controller_, stops(), ScriptCommand::SpeedJ, MotionKind::SpeedJ, parameters, holding);
    return motion ? Result<JointSpeed>(JointSpeed(*motion, parameters)) : motion.error();
}

Result<ToolSpeed> Motions::startSpeedL(const SpeedParameters& parameters, Holding holding) {
    const auto motion =
        startStream(*controller_, stops(), ScriptCommand::SpeedL, MotionKind::SpeedL, parameters, holding);
    return motion ? Result<ToolSpeed>(ToolSpeed(*motion, parameters)) : motion.error();
}

Result<JointTorque> Motions::startTorque(const TorqueParameters& parameters, Holding holding) {
    constexpr SoftwareVersion kOnESeries{5, 25, 1, 0};
    constexpr SoftwareVersion kOnPolyScopeX{10, 12, 1, 0};
    const QString context = QStringLiteral("start a stream");
    auto& d = ControllerAccess::of(*controller_);
    if (const Error error = d.obstacle(context); error.code != ErrorCode::None) {
        return error;  // the version is unknown without control
    }
    if (const auto known = d.program.needs(kOnESeries, {}, context, kOnPolyScopeX); !known) {
        return known.error();
    }
    for (const char* name : {"direct_torque", "get_mass_matrix"}) {
        if (const auto known = d.program.knows(name, context); !known) {
            return known.error();
        }
    }
    const auto motion =
        startStream(*controller_, stops(), ScriptCommand::Torque, MotionKind::Torque, parameters, holding);
    return motion ? Result<JointTorque>(JointTorque(*motion, parameters)) : motion.error();
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
    d.link.wake();
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
    d.link.wake();
    return MotionAccess::make(*controller_, id, MotionKind::Stop);
}

}  // namespace tiller::control
