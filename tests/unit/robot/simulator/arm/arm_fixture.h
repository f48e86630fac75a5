// SPDX-License-Identifier: MIT
#pragma once

// An arm that is ready to move, and a step function that checks the limits for every motion.

#include <algorithm>
#include <cmath>
#include <string>

#include "robot/core/robot_model.h"
#include "robot/simulator/arm/arm.h"

namespace tiller::simulator::arm {

class WatchedArm {
public:
    explicit WatchedArm(bool ideal = true, RobotModelId id = RobotModelId::UR5e,
                        const JointPositions& start = JointPositions(-1.6007, -1.7271, -2.2030, -0.8080,
                                                                     1.5951, -0.0310))
        : arm(robotModel(id), ArmOptions{.seed = 7, .ideal = ideal, .start = start}) {
        arm.setDriveState(DriveState::Running);
        q_ = arm.state().targetQ.values;
    }

    Arm* operator->() { return &arm; }
    const ArmState& state() const { return arm.state(); }

    /// Advances by one control period and records the worst values observed.
    void step() {
        arm.step();
        const ArmState& s = arm.state();
        const double dt = arm.period();
        const Vector6 qd = s.targetQd.values;
        const Vector6 moved = (s.targetQ.values - q_) / dt;
        worstAcceleration = std::max(worstAcceleration, (qd - qd_).cwiseAbs().maxCoeff() / dt);
        const auto limit = Eigen::Map<const Vector6>(arm.model().maxJointSpeed.data());
        worstSpeed = std::max(worstSpeed, (qd.cwiseAbs().array() / limit.array()).maxCoeff());
        worstPosition = std::max(worstPosition, s.targetQ.values.cwiseAbs().maxCoeff());
        // The position change must match the mean velocity.
        worstMismatch = std::max(worstMismatch, (moved - 0.5 * (qd + qd_)).cwiseAbs().maxCoeff());
        q_ = s.targetQ.values;
        qd_ = qd;
        ++steps;
    }

    void run(double seconds) {
        for (int n = static_cast<int>(std::lround(seconds / arm.period())); n > 0; --n) {
            step();
        }
    }

    /// Steps until the command has finished. Returns the time taken [s].
    double finish(const MotionStart& start, double timeout = 60) {
        const int before = steps;
        while (arm.motion().progress(start.id) == MotionProgress::Running &&
               (steps - before) * arm.period() < timeout) {
            step();
        }
        return (steps - before) * arm.period();
    }

    double rest(double timeout = 20) {
        const int before = steps;
        do {
            step();
        } while (!arm.state().isStandstill() && (steps - before) * arm.period() < timeout);
        return (steps - before) * arm.period();
    }

    Eigen::Vector3d tcp() const { return arm.state().targetTcpPose.position; }

    std::string worst() const {
        return "acceleration " + std::to_string(worstAcceleration) + " speed " + std::to_string(worstSpeed) +
               " position " + std::to_string(worstPosition) + " mismatch " + std::to_string(worstMismatch);
    }
    bool withinBounds() const {
        return worstAcceleration <= 40.1 && worstSpeed <= 1.001 &&
               worstPosition <= kJointPositionLimit + 1e-6 && worstMismatch < 2 * 40 * 0.002;
    }

    Arm arm;
    double worstAcceleration = 0;
    double worstSpeed = 0;
    double worstPosition = 0;
    double worstMismatch = 0;
    int steps = 0;

private:
    Vector6 q_ = Vector6::Zero();
    Vector6 qd_ = Vector6::Zero();
};

inline constexpr double kDegree = 3.14159265358979323846 / 180.0;

}  // namespace tiller::simulator::arm
