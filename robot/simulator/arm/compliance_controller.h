// SPDX-License-Identifier: MIT
#pragma once

// Implementation of Compliance: an admittance controller superposed on the programmed motion. In force mode,
// the compliant axes of the force frame move like a damped mass driven by the difference between the
// requested and the measured force. The other axes follow the program. In freedrive, the joints move like
// damped inertias driven by the hand.

#include "robot/simulator/arm/arm_geometry.h"
#include "robot/simulator/arm/compliance.h"
#include "robot/simulator/arm/motion_generator.h"

namespace tiller::simulator::arm {

class ComplianceController {
public:
    ComplianceController(const ArmGeometry& geometry, MotionGenerator& generator, double period);

    MotionError startForceMode(const ForceModeParameters& parameters);
    void endForceMode();
    MotionError startFreedrive(const FreedriveParameters& parameters);
    void endFreedrive();
    bool isForceMode() const { return forceMode_; }
    bool isFreedrive() const { return freedrive_; }
    int freedriveStatus() const;

    double damping = 0.005;    ///< 0..1
    double gainScaling = 1.0;  ///< 0..2

    /// Ends force mode and freedrive without a stop.
    void drop();
    /// Converts the program target to the commanded target. `measured`: TCP force measured by the controller.
    /// `external`: actual external force at the TCP, without load and noise. Both are in base axes about the
    /// TCP.
    const JointTarget& apply(const JointTarget& program, const Wrench& measured, const Wrench& external,
                             bool operational);
    const JointTarget& target() const { return command_; }

private:
    Eigen::Matrix3d forceFrame(const Eigen::Vector3d& tcp, const Eigen::Vector3d& tcpVelocity) const;
    void stepForceMode(const Wrench& measured);
    bool deviates(const Vector6& way) const;
    void stepFreedrive(const Wrench& external);
    void comeToRest();
    bool takeTwist(const Vector6& twist);

    const ArmGeometry& geometry_;
    MotionGenerator& generator_;
    double period_;
    bool forceMode_ = false;
    bool freedrive_ = false;
    ForceModeParameters force_;
    FreedriveParameters free_;
    Vector6 forceVelocity_ = Vector6::Zero();  // compliant axes, force frame
    JointTarget command_;
    Posture posture_;
    Posture program_;
};

}  // namespace tiller::simulator::arm
