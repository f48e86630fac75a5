// SPDX-License-Identifier: MIT
#include "robot/station/jog/jog_motion.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "robot/core/angles.h"
#include "robot/kinematics/speed_bounds.h"

namespace tiller {

namespace {

// Steps use the acceleration of a jog, so only the speed must be limited.
double capped(double speed, double cap) {
    return std::min(speed, cap);
}

Eigen::Vector3d unit(int axis, int direction) {
    Eigen::Vector3d v = Eigen::Vector3d::Zero();
    v[axis % 3] = direction;
    return v;
}

/// Modifier keys never increase the speed of an UntilContact motion.
double allowed(const JogSelection& selection, double factor) {
    return selection.motion == MotionChoice::UntilContact ? std::min(factor, 1.0) : factor;
}

/// Speed parameter of a linear move that is a pure rotation [m/s].
double turnSpeed(double rotation, const control::MotionLimits& limits) {
    return std::min(capped(rotation, limits.tcpRotationSpeed) * kinematics::kTurnRadius, limits.tcpSpeed);
}

double contactForce(const JogSelection& selection) {
    return selection.motion == MotionChoice::UntilContact
               ? std::clamp(selection.contactForce, kMinContactForce, kMaxContactForce)
               : 0;
}

}  // namespace

const std::array<SpeedClass, kSpeedClassCount>& speedClasses() {
    static const std::array<SpeedClass, kSpeedClassCount> classes = {{
        {0.005, toRadians(3), toRadians(1)},
        {0.020, toRadians(10), toRadians(3)},
        {0.050, toRadians(15), toRadians(10)},
        {0.100, toRadians(30), toRadians(20)},
        {0.250, toRadians(45), toRadians(30)},
    }};
    return classes;
}

StepSize stepSize(MotionChoice motion) {
    switch (motion) {
        case MotionChoice::Hold:
        case MotionChoice::UntilContact:
            break;
        case MotionChoice::FineStep:
            return {0.0001, toRadians(0.1)};
        case MotionChoice::Step:
            return {0.001, toRadians(1)};
        case MotionChoice::CoarseStep:
            return {0.010, toRadians(5)};
    }
    return {};
}

control::JogTarget cartesianJog(const JogSelection& selection, const CartesianKey& key, double factor,
                                const control::MotionLimits& limits) {
    control::JogTarget target;
    target.kind = control::JogTarget::Kind::Cartesian;
    switch (selection.frame) {
        case FrameChoice::Base:
            target.frame = control::JogFrame::Base;
            break;
        case FrameChoice::Tool:
            target.frame = control::JogFrame::Tool;
            break;
        case FrameChoice::View:
            target.frame = control::JogFrame::Custom;
            target.T_base_frame.rotation = rotationVector(selection.R_base_view);
            break;
        case FrameChoice::Taught:
            target.frame = control::JogFrame::Custom;
            if (selection.taught) {
                target.T_base_frame = selection.taught->T_base_frame;
            }
            break;
    }
    const SpeedClass speed = chosenSpeed(selection);
    if (key.axis < 3) {
        target.twist.linear =
            unit(key.axis, key.direction) * capped(speed.tcp * allowed(selection, factor), limits.tcpSpeed);
    } else {
        target.twist.angular = unit(key.axis, key.direction) *
                               capped(speed.rotation * allowed(selection, factor), limits.tcpRotationSpeed);
    }
    target.contactForce = contactForce(selection);
    return target;
}

control::JogTarget jointJog(const JogSelection& selection, int joint, int direction, double factor,
                            const control::MotionLimits& limits) {
    control::JogTarget target;
    target.kind = control::JogTarget::Kind::Joint;
    target.qd[joint] =
        direction * capped(chosenSpeed(selection).joint * allowed(selection, factor), limits.jointSpeed);
    target.speedCap = capped(chosenSpeed(selection).tcp * allowed(selection, factor), limits.tcpSpeed);
    target.contactForce = contactForce(selection);
    return target;
}

MoveRequest cartesianStep(const JogSelection& selection, const CartesianKey& key, double factor,
                          const Pose& from, const control::MotionLimits& limits) {
    const StepSize step = chosenStep(selection);
    const Eigen::Matrix3d R_base_frame = frameAxes(selection, from);
    MoveRequest request;
    request.kind = MoveRequest::Kind::MoveL;
    request.pose = from;
    const Eigen::Vector3d axis = R_base_frame * unit(key.axis, key.direction);
    if (key.axis < 3) {
        request.pose.position += axis * step.length;
    } else {
        request.pose.rotation =
            rotationVector(Eigen::AngleAxisd(step.angle, axis) * rotationMatrix(from.rotation));
    }
    request.speed = key.axis < 3 ? capped(chosenSpeed(selection).tcp * factor, limits.tcpSpeed)
                                 : turnSpeed(chosenSpeed(selection).rotation * factor, limits);
    request.acceleration = limits.jogAcceleration;
    return request;
}

MoveRequest jointStep(const JogSelection& selection, int joint, int direction, double factor,
                      const JointPositions& from, const RobotModel& model, const Pose& tcpOffset,
                      const control::MotionLimits& limits) {
    MoveRequest request;
    request.kind = MoveRequest::Kind::MoveJ;
    request.q = from;
    request.q[joint] = std::clamp(from[joint] + direction * chosenStep(selection).angle, -kJointPositionLimit,
                                  kJointPositionLimit);
    request.speed = jointKeySpeed(selection, joint, factor, from, model, tcpOffset, limits);
    request.acceleration = limits.jointAcceleration;
    return request;
}

double jointKeySpeed(const JogSelection& selection, int joint, double factor, const JointPositions& from,
                     const RobotModel& model, const Pose& tcpOffset, const control::MotionLimits& limits) {
    const control::JogTarget target = jointJog(selection, joint, 1, factor, limits);
    // While only this joint rotates, TCP and elbow keep their distances from its axis, so the bound is the
    // same for any target.
    JointPositions to = from;
    to[joint] += 1;
    return std::min(target.qd[joint],
                    kinematics::jointSpeedBound(model.dh, from, to, tcpOffset, target.speedCap).speed);
}

MoveRequest homeMove(const JogSelection& selection, const JointPositions& from, const JointPositions& home,
                     const RobotModel& model, const Pose& tcpOffset, const control::MotionLimits& limits) {
    MoveRequest request;
    request.kind = MoveRequest::Kind::MoveJ;
    request.q = home;
    const SpeedClass chosen = chosenSpeed(selection);
    const double tcpSpeed = std::min(chosen.tcp, 0.95 * limits.tcpSpeed);
    request.acceleration = limits.jointAcceleration;
    request.speed = std::min(capped(chosen.joint, limits.jointSpeed),
                             kinematics::jointSpeedBound(model.dh, from, home, tcpOffset, tcpSpeed).speed);
    return request;
}

Eigen::Matrix3d frameAxes(const JogSelection& selection, const Pose& tcp) {
    switch (selection.frame) {
        case FrameChoice::Base:
            break;
        case FrameChoice::Tool:
            return rotationMatrix(tcp.rotation);
        case FrameChoice::View:
            return selection.R_base_view;
        case FrameChoice::Taught:
            if (selection.taught) {
                return rotationMatrix(selection.taught->T_base_frame.rotation);
            }
            break;
    }
    return Eigen::Matrix3d::Identity();
}

QString frameName(const JogSelection& selection) {
    switch (selection.frame) {
        case FrameChoice::Base:
            break;
        case FrameChoice::Tool:
            return QCoreApplication::translate("JogColumn", "Tool");
        case FrameChoice::View:
            return QCoreApplication::translate("JogColumn", "View");
        case FrameChoice::Taught:
            if (selection.taught) {
                return selection.taught->name;
            }
            break;
    }
    return QCoreApplication::translate("JogColumn", "Base");
}

Pose readingFrame(const JogSelection& selection) {
    Pose frame;
    if (selection.frame == FrameChoice::View) {
        frame.rotation = rotationVector(selection.R_base_view);
    } else if (selection.frame == FrameChoice::Taught && selection.taught) {
        frame = selection.taught->T_base_frame;
    }
    return frame;
}

QString readingFrameName(const JogSelection& selection) {
    return selection.frame == FrameChoice::Tool ? QCoreApplication::translate("JogColumn", "Base")
                                                : frameName(selection);
}

StepSize chosenStep(const JogSelection& selection) {
    return selection.step && selection.motion == MotionChoice::CoarseStep ? *selection.step
                                                                          : stepSize(selection.motion);
}

SpeedClass chosenSpeed(const JogSelection& selection) {
    const int index = std::clamp(selection.speedClass, 0, kSpeedClassCount - 1);
    const SpeedClass speed =
        selection.speed ? *selection.speed : speedClasses()[static_cast<std::size_t>(index)];
    if (selection.motion != MotionChoice::UntilContact) {
        return speed;
    }
    return {std::min(speed.tcp, kContactSpeed.tcp), std::min(speed.rotation, kContactSpeed.rotation),
            std::min(speed.joint, kContactSpeed.joint)};
}

bool isHeld(MotionChoice motion) {
    return motion == MotionChoice::Hold || motion == MotionChoice::UntilContact;
}

SpeedClass speedFor(double tcpSpeed) {
    const auto& classes = speedClasses();
    if (tcpSpeed <= classes.front().tcp) {
        const double factor = std::max(0.0, tcpSpeed) / classes.front().tcp;
        return {tcpSpeed, classes.front().rotation * factor, classes.front().joint * factor};
    }
    for (std::size_t i = 1; i < classes.size(); ++i) {
        if (tcpSpeed <= classes[i].tcp) {
            const double t = (tcpSpeed - classes[i - 1].tcp) / (classes[i].tcp - classes[i - 1].tcp);
            return {tcpSpeed, std::lerp(classes[i - 1].rotation, classes[i].rotation, t),
                    std::lerp(classes[i - 1].joint, classes[i].joint, t)};
        }
    }
    return {tcpSpeed, classes.back().rotation, classes.back().joint};
}

bool stepRunsToEnd(const JogSelection& selection, bool turns) {
    const StepSize step = chosenStep(selection);
    return !isHeld(selection.motion) &&
           (turns ? step.angle <= kFreeStepAngle * 1.0001 : step.length <= kFreeStepLength * 1.0001);
}

MoveRequest alignMove(const JogSelection& selection, const Pose& from, const control::MotionLimits& limits) {
    const Eigen::Matrix3d R_base_tool = rotationMatrix(from.rotation);
    const Eigen::Matrix3d R_base_frame = selection.frame == FrameChoice::Tool
                                             ? Eigen::Matrix3d(Eigen::Matrix3d::Identity())
                                             : frameAxes(selection, from);
    const Eigen::Vector3d z = R_base_tool.col(2);
    Eigen::Index axis = 0;
    const Eigen::Vector3d along = R_base_frame.transpose() * z;
    along.cwiseAbs().maxCoeff(&axis);
    const Eigen::Vector3d target = R_base_frame.col(axis) * (along[axis] < 0 ? -1.0 : 1.0);
    const Eigen::Quaterniond turn = Eigen::Quaterniond::FromTwoVectors(z, target);
    MoveRequest request;
    request.kind = MoveRequest::Kind::MoveL;
    request.pose = from;
    request.pose.rotation = rotationVector(turn.toRotationMatrix() * R_base_tool);
    request.speed = turnSpeed(chosenSpeed(selection).rotation, limits);
    request.acceleration = limits.jogAcceleration;
    return request;
}

double modifierFactor(Qt::KeyboardModifiers modifiers) {
    if (modifiers.testFlag(Qt::ControlModifier)) {
        return 0.1;
    }
    return modifiers.testFlag(Qt::ShiftModifier) ? 3.0 : 1.0;
}

JointPositions defaultHome() {
    return {0, -std::numbers::pi / 2, 0, -std::numbers::pi / 2, 0, 0};
}

}  // namespace tiller
