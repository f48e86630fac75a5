// SPDX-License-Identifier: MIT
#include "robot/simulator/arm/motion.h"

#include "robot/simulator/arm/motion_generator.h"

namespace tiller::simulator::arm {

MotionStart Motion::moveJ(const MoveTarget& target, const MoveParameters& parameters) {
    return generator_.move(Segment::Kind::Joint, target, parameters);
}

MotionStart Motion::moveL(const MoveTarget& target, const MoveParameters& parameters) {
    return generator_.move(Segment::Kind::Linear, target, parameters);
}

MotionStart Motion::moveP(const MoveTarget& target, const MoveParameters& parameters) {
    return generator_.move(Segment::Kind::Process, target, parameters);
}

MotionStart Motion::moveC(const MoveTarget& via, const MoveTarget& target, const MoveParameters& parameters,
                          ArcOrientation orientation) {
    return generator_.move(Segment::Kind::Circular, target, parameters, &via, orientation);
}

MotionStart Motion::servoJ(const JointPositions& q, double t, double lookaheadTime, double gain) {
    return generator_.servoJ(q, t, lookaheadTime, gain);
}

MotionStart Motion::servoC(const Pose& target, double a, double v, double r) {
    return generator_.servoC(target, a, v, r);
}

MotionStart Motion::speedJ(const JointVelocities& qd, double a, std::optional<double> t) {
    return generator_.speedJ(qd, a, t);
}

MotionStart Motion::speedL(const Twist& twist, double a, std::optional<double> t,
                           std::optional<double> aRot) {
    return generator_.speedL(twist, a, t, aRot);
}

MotionStart Motion::stopJ(double a) {
    return generator_.stopJ(a);
}

MotionStart Motion::stopL(double a, std::optional<double> aRot) {
    return generator_.stopL(a, aRot);
}

MotionStart Motion::directTorque(const JointTorques& torques, const Vector6& viscousScale,
                                 const Vector6& coulombScale) {
    return generator_.directTorque(torques, viscousScale, coulombScale);
}

MotionProgress Motion::progress(MotionId id) const {
    return generator_.progress(id);
}

void Motion::abandon() {
    generator_.abandon();
}

Pose Motion::targetWaypoint() const {
    return generator_.targetWaypoint();
}

bool Motion::isActive() const {
    return generator_.isActive();
}

const char* stopReasonName(StopReason reason) {
    switch (reason) {
        case StopReason::Singularity:
            return "Singularity";
        case StopReason::PoseUnreachable:
            return "PoseUnreachable";
        case StopReason::JointPositionLimit:
            return "JointPositionLimit";
        case StopReason::JointSpeedLimit:
            return "JointSpeedLimit";
        case StopReason::TcpForceLimit:
            return "TcpForceLimit";
        case StopReason::PathDeviation:
            return "PathDeviation";
        case StopReason::Overload:
            return "Overload";
        case StopReason::WrongPayload:
            return "WrongPayload";
    }
    return "";
}

const char* motionErrorName(MotionError error) {
    switch (error) {
        case MotionError::None:
            return "None";
        case MotionError::InvalidArgument:
            return "InvalidArgument";
        case MotionError::JointTargetOutOfRange:
            return "JointTargetOutOfRange";
        case MotionError::NoInverseKinematics:
            return "NoInverseKinematics";
        case MotionError::NotOperational:
            return "NotOperational";
        case MotionError::Busy:
            return "Busy";
    }
    return "";
}

}  // namespace tiller::simulator::arm
