// SPDX-License-Identifier: MIT
#pragma once

// Drives and sensors of the simulated arm without its motion generator. The caller sets one target per
// control period, for example from a recording. The simulation is deterministic, without noise or threads.
// step() does not allocate memory.
//
//     DrivenArm arm(robotModel(RobotModelId::UR5e), 0.002);
//     arm.place(q);
//     arm.step(q, qd);
//     arm.state().actualCurrent;

#include <memory>

#include "robot/core/joints.h"
#include "robot/core/robot_model.h"
#include "robot/simulator/arm/arm_state.h"

namespace tiller::simulator::arm {

class DrivenArm {
public:
    /// period  control period [s], above 0
    DrivenArm(const RobotModel& model, double period);
    ~DrivenArm();
    DrivenArm(const DrivenArm&) = delete;
    DrivenArm& operator=(const DrivenArm&) = delete;

    double period() const;  ///< [s]
    const RobotModel& model() const;

    /// Sets the configured payload, which is also the actual load.
    void setPayload(const Payload& payload);
    /// Sets gravity as measured by an accelerometer at the base [m/s2]; [0, 0, 9.82] when upright.
    void setGravity(const Eigen::Vector3d& gravity);
    /// Places the arm at q at rest. The next target may be at any distance from the previous target.
    void place(const JointPositions& q);
    void step(const JointPositions& q, const JointVelocities& qd);
    /// Measured state after the last step, without contact.
    const ArmState& state() const;

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace tiller::simulator::arm
