// SPDX-License-Identifier: MIT
#pragma once

// Implementation of Motion: checks and plans motion commands and passes them to the drive.

#include <optional>

#include "robot/simulator/arm/motion_drive.h"

namespace tiller::simulator::arm {

class MotionGenerator : public MotionDrive {
public:
    using MotionDrive::MotionDrive;

    // See Motion.
    MotionStart move(Segment::Kind kind, const MoveTarget& target, const MoveParameters& parameters,
                     const MoveTarget* via = nullptr,
                     ArcOrientation orientation = ArcOrientation::Interpolated);
    MotionStart servoJ(const JointPositions& q, double t, double lookahead, double gain);
    MotionStart servoC(const Pose& target, double a, double v, double r);
    MotionStart speedJ(const JointVelocities& qd, double a, std::optional<double> t);
    MotionStart speedL(const Twist& twist, double a, std::optional<double> t, std::optional<double> aRot);
    MotionStart stopJ(double a);
    MotionStart stopL(double a, std::optional<double> aRot);
    MotionStart directTorque(const JointTorques& torques, const Vector6& viscous, const Vector6& coulomb);

private:
    MotionError buildSegment(Segment& segment, Segment::Kind kind, const Vector6& fromQ,
                             const ToolPoint& fromTool, const MoveTarget& target, const MoveTarget* via,
                             ArcOrientation orientation, int& joint);
    MotionStart queueMove(Segment::Kind kind, const MoveTarget& target, const MoveParameters& parameters,
                          const MoveTarget* via, ArcOrientation orientation);
    ToolPoint toolPoint(const MoveTarget& target) const;
};

}  // namespace tiller::simulator::arm
