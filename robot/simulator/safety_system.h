// SPDX-License-Identifier: MIT
#pragma once

// The safety states of a controller and how they end. It knows causes and time, not what the arm or the
// program make of them: the plant looks at mode() after each step and reacts to a change.
// Source: UR manual (stop categories), RTDE guide (names), dashboard guide (unlock, restart).

#include <cstdint>

#include "robot/core/modes.h"

namespace tiller::simulator {

class SafetySystem {
public:
    /// A protective stop cannot be unlocked from the dashboard earlier [s].
    static constexpr double kUnlockDelay = 5.0;
    /// From an accepted unlock to normal operation [s].
    static constexpr double kUnlockTime = 0.05;

    void setRobotEmergencyStop(bool pressed) { robotEmergency_ = pressed; }
    void setSystemEmergencyStop(bool active) { systemEmergency_ = active; }
    void setSafeguard(bool open) { safeguard_ = open; }
    void setReduced(bool active) { reduced_ = active; }
    void violation() { violation_ = true; }
    void fault() { fault_ = true; }
    void protectiveStop();

    /// False when it is too early, which only matters if `enforceDelay`. True, without effect, when there is
    /// no protective stop.
    bool unlockProtectiveStop(bool enforceDelay);
    /// Clears violation, fault and protective stop.
    void restart();

    void step(double dt);

    SafetyMode mode() const;
    bool isProtectiveStopped() const { return protective_; }
    bool isEmergencyStopped() const { return robotEmergency_ || systemEmergency_; }
    bool isReduced() const { return reduced_; }
    /// No power may be applied.
    bool blocksPower() const { return isEmergencyStopped() || violation_ || fault_; }
    /// safety_status_bits. Source: RTDE guide.
    std::uint32_t statusBits() const;

private:
    bool robotEmergency_ = false;
    bool systemEmergency_ = false;
    bool safeguard_ = false;
    bool reduced_ = false;
    bool violation_ = false;
    bool fault_ = false;
    bool protective_ = false;
    bool unlocking_ = false;
    double protectiveTime_ = 0;
    double unlockTime_ = 0;
};

}  // namespace tiller::simulator
