// SPDX-License-Identifier: MIT
#pragma once

// Force mode and freedrive: compliant motion that is superposed on the programmed motion.
// Source: URScript force_mode, freedrive_mode.

#include "robot/core/spatial.h"
#include "robot/simulator/arm/motion_types.h"

namespace tiller::simulator::arm {

class ComplianceController;

class Compliance {
public:
    explicit Compliance(ComplianceController& controller) : controller_(controller) {}

    /// Starts force mode, or changes it if it is active. May be called every period.
    /// Errors    InvalidArgument, NotOperational
    MotionError startForceMode(const ForceModeParameters& parameters);
    /// Returns to position control. No effect if force mode is not active.
    void endForceMode();
    bool isForceMode() const;
    void setDamping(double damping);      ///< 0..1 (clamped); remains set until changed
    double damping() const;               ///< initially 0.005
    void setGainScaling(double scaling);  ///< 0..2 (clamped); remains set until changed
    double gainScaling() const;

    /// Makes the arm movable by hand. Motion commands return without moving the arm. May be called
    /// repeatedly.
    MotionError startFreedrive(const FreedriveParameters& parameters = {});
    void endFreedrive();
    bool isFreedrive() const;
    /// get_freedrive_status(): 0 normal, 1 near a singularity, 2 too close to a singularity.
    int freedriveStatus() const;

private:
    ComplianceController& controller_;
};

}  // namespace tiller::simulator::arm
