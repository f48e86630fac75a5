// SPDX-License-Identifier: MIT
#include "robot/station/program/detail/move_target.h"

#include "robot/kinematics/arm_kinematics.h"
#include "robot/project/reachability.h"
#include "robot/station/program/detail/fields.h"
#include "robot/station/program/expression.h"

namespace tiller::program {
namespace {

constexpr double kMaxToolSpeed = 3.0;
constexpr double kMaxToolAcceleration = 15.0;
constexpr double kMaxJointSpeed = 3.3;
constexpr double kMaxJointAcceleration = 40.0;
constexpr double kMaxBlend = 1.0;
constexpr double kMaxDistanceBefore = 1.0;

Pose along(double before) {
    return {0, 0, -before, 0, 0, 0};
}

void writeActions(StepWriter& writer, const project::Waypoint& waypoint) {
    using Kind = project::WaypointActionKind;
    for (const project::WaypointAction& action : waypoint.actions) {
        const Kind& kind = kindOf(action);
        const int channel = project::channelOf(action.group, action.pin);
        if (kind.grip != Kind::Grip::None) {
            writer.error("actions", ProgramText::tr("The waypoint “%1” moves the gripper. In a program, use "
                                                    "the Gripper step and turn off “Run waypoint actions”.")
                                        .arg(waypoint.name));
        }
        if (kind.pin == Kind::Pin::Input) {
            writer.waitUntil(QStringLiteral("%1 == %2").arg(inputCall(channel), scriptFlag(action.value)),
                             action.seconds > 0 ? std::optional(action.seconds) : std::nullopt);
        }
        if (kind.pin == Kind::Pin::Output) {
            writer.line(outputCall(channel, action.value));
        }
        if (kind.time == Kind::Time::Duration) {
            writer.line(QStringLiteral("sleep(%1)").arg(scriptNumber(action.seconds)));
            if (kind.pin == Kind::Pin::Output) {
                writer.line(outputCall(channel, !action.value));
            }
        }
    }
}

void writeCommand(StepWriter& writer, MoveCommand command, const MoveTarget& target, double acceleration,
                  double speed, double blend, const QString& name) {
    const bool joint = command == MoveCommand::J;
    QString text = QStringLiteral("%1(%2, a=%3, v=%4, r=%5)")
                       .arg(joint                       ? QStringLiteral("movej")
                            : command == MoveCommand::L ? QStringLiteral("movel")
                                                        : QStringLiteral("movep"),
                            joint ? target.asJoints() : target.either(), scriptNumber(acceleration),
                            scriptNumber(joint ? writer.jointSpeed(speed) : writer.toolSpeed(speed)),
                            scriptNumber(blend));
    if (!name.isEmpty()) {
        text += QStringLiteral("  # ") + name;
    }
    writer.line(text);
    writer.noteMove(target.known, blend);
}

}  // namespace

std::vector<StepField> moveFields(MoveCommand command) {
    const bool joint = command == MoveCommand::J;
    const QString speed = ProgramText::tr("Speed");
    const QString acceleration = ProgramText::tr("Acceleration");
    return {
        optionalField("waypoint", ProgramText::tr("Waypoint"), FieldType::Waypoint),
        optionalField("pose", ProgramText::tr("Pose"), FieldType::Expression),
        numberField("before", ProgramText::tr("Approach distance"), Unit::Length, -kMaxDistanceBefore,
                    kMaxDistanceBefore, 0),
        joint ? optionalNumber("speed", speed, Unit::AngularSpeed, 0.001, kMaxJointSpeed)
              : optionalNumber("speed", speed, Unit::Speed, 0.0001, kMaxToolSpeed),
        joint ? optionalNumber("acceleration", acceleration, Unit::AngularAcceleration, 0.001,
                               kMaxJointAcceleration)
              : optionalNumber("acceleration", acceleration, Unit::Acceleration, 0.001, kMaxToolAcceleration),
        optionalNumber("blend", ProgramText::tr("Blend"), Unit::Length, 0, kMaxBlend),
        flagField("actions", ProgramText::tr("Run waypoint actions"), true)};
}

QString MoveTarget::asJoints() const {
    return !joints.isEmpty() ? joints
           : near.isEmpty()  ? QStringLiteral("get_inverse_kin(%1)").arg(pose)
                             : QStringLiteral("get_inverse_kin(%1, %2)").arg(pose, near);
}

const project::Waypoint& waypointOf(StepWriter& writer, const char* key) {
    return writer.project().waypoints.at(writer.project().waypoints.indexOf(writer.id(key)));
}

std::optional<MoveTarget> targetAt(StepWriter& writer, const project::Waypoint& waypoint, double before,
                                   const char* key) {
    const std::optional<Pose> tcp = writer.tcpFor(waypoint, key);
    const project::FrameList& frames = writer.project().frames;
    const std::optional<Pose> taught = waypoint.priority == project::TargetKind::Joints
                                           ? kinematics::forwardTcp(writer.model().dh, waypoint.joints, *tcp)
                                           : project::targetForTcp(waypoint, frames, *tcp);
    MoveTarget target;
    target.near = scriptJoints(waypoint.joints);
    if (taught) {
        target.known = *taught * along(before);
    }
    const bool joints = waypoint.priority == project::TargetKind::Joints;
    const bool reached = joints && before == 0
                             ? waypoint.joints.values.cwiseAbs().maxCoeff() <= kJointPositionLimit
                             : target.known && kinematics::inverseNearest(writer.model().dh, *target.known,
                                                                          *tcp, waypoint.joints);
    if (!reached) {
        writer.error(
            key,
            ProgramText::tr("The arm cannot reach “%1”. Change the waypoint, or select a different waypoint.")
                .arg(waypoint.name));
        return std::nullopt;
    }
    if (joints) {
        // The robot calculates the pose, because it uses its calibrated kinematics.
        target.joints = before == 0 ? target.near : QString();
        target.pose =
            QStringLiteral("pose_trans(get_forward_kin(%1), %2)").arg(target.near, scriptPose(along(before)));
        if (before == 0) {
            target.pose = QStringLiteral("get_forward_kin(%1)").arg(target.near);
        }
    } else {
        target.pose = scriptPose(*target.known);
    }
    return target;
}

void writeMoveTo(StepWriter& writer, MoveCommand command, const project::Waypoint& waypoint, bool stops) {
    const double before = writer.has("before") ? writer.number("before") : 0;
    const bool acts = writer.flag("actions") && !waypoint.actions.empty();
    const std::optional<MoveTarget> target = targetAt(writer, waypoint, before, "waypoint");
    if (!target) {
        return;
    }
    const bool joint = command == MoveCommand::J;
    const double blend = acts || stops ? 0 : writer.given("blend").value_or(waypoint.blend);
    writeCommand(
        writer, command, *target,
        writer.given("acceleration")
            .value_or(joint ? project::kDefaultJointAcceleration : project::kDefaultToolAcceleration),
        writer.given("speed").value_or(joint ? waypoint.jointSpeed : waypoint.toolSpeed), blend,
        scriptComment(waypoint.name));
    if (acts) {
        writeActions(writer, waypoint);
    }
}

void writeMove(StepWriter& writer, MoveCommand command) {
    const bool joint = command == MoveCommand::J;
    if (writer.has("waypoint") == writer.has("pose")) {
        writer.error("waypoint", writer.has("pose")
                                     ? ProgramText::tr("Set either a waypoint or a pose, not both.")
                                     : ProgramText::tr("Set a waypoint or a pose."));
        return;
    }
    if (writer.has("waypoint")) {
        writeMoveTo(writer, command, waypointOf(writer, "waypoint"), false);
        return;
    }
    MoveTarget target;
    const double before = writer.number("before");
    target.pose =
        before == 0
            ? writer.expression("pose")
            : QStringLiteral("pose_trans(%1, %2)").arg(writer.expression("pose"), scriptPose(along(before)));
    writeCommand(
        writer, command, target,
        writer.given("acceleration")
            .value_or(joint ? project::kDefaultJointAcceleration : project::kDefaultToolAcceleration),
        writer.given("speed").value_or(joint ? project::kDefaultJointSpeed : project::kDefaultToolSpeed),
        writer.given("blend").value_or(0), {});
}

}  // namespace tiller::program
