// SPDX-License-Identifier: MIT
#pragma once

// Safety states of a controller and their transitions. This class handles causes and times, but not the
// reaction of the arm or the program. Plant reads mode() after each step and reacts to changes.
// Source: UR manual (stop categories), RTDE guide (names), dashboard guide (unlock, restart).

#include <cstdint>

#include "robot/core/modes.h"

namespace tiller::simulator {

/// Operational mode set on the teach pendant or through the Dashboard Server. None: not set.
enum class OperationalMode { None, Manual, Automatic };

class SafetySystem {
public:
    /// Minimum time before a protective stop can be unlocked through the dashboard [s].
    static constexpr double kUnlockDelay = 5.0;
    /// Time from an accepted unlock request to normal operation [s].
    static constexpr double kUnlockTime = 0.05;

    /// Conditions that remain active as long as their cause exists.
    enum class Input {
        RobotEmergencyStop,
        SystemEmergencyStop,
        Safeguard,
        AutomaticModeSafeguard,  ///< active in AUTOMATIC only
        ThreePositionEnabling,   ///< the enabling device is not in its middle position; MANUAL only
        Reduced,
        Recovery,  ///< a joint is outside its safety limits
        Count
    };
    void set(Input input, bool active) { inputs_[static_cast<int>(input)] = active; }
    bool isSet(Input input) const { return inputs_[static_cast<int>(input)]; }
    void setOperationalMode(OperationalMode mode) { operationalMode_ = mode; }
    OperationalMode operationalMode() const { return operationalMode_; }

    void violation() { violation_ = true; }
    void fault() { fault_ = true; }
    void protectiveStop();

    /// Starts to unlock a protective stop. With `enforceDelay`, returns false within kUnlockDelay after the stop.
    /// Returns true without effect if there is no protective stop.
    bool unlockProtectiveStop(bool enforceDelay);
    /// Clears violation, fault and protective stop.
    void restart();

    void step(double dt);

    /// Value of safety_mode. The automatic mode safeguard stop and the three-position enabling stop are
    /// reported as SAFEGUARD_STOP.
    SafetyMode mode() const;
    /// Value of safety_status, which distinguishes all causes.
    SafetyMode status() const;
    bool isProtectiveStopped() const { return protective_; }
    bool isEmergencyStopped() const {
        return isSet(Input::RobotEmergencyStop) || isSet(Input::SystemEmergencyStop);
    }
    bool isReduced() const { return isSet(Input::Reduced); }
    /// True if the power must stay off.
    bool blocksPower() const { return isEmergencyStopped() || violation_ || fault_; }
    /// Value of safety_status_bits. Source: RTDE guide.
    std::uint32_t statusBits() const;

private:
    bool automaticStop() const {
        return isSet(Input::AutomaticModeSafeguard) && operationalMode_ == OperationalMode::Automatic;
    }
    bool enablingStop() const {
        return isSet(Input::ThreePositionEnabling) && operationalMode_ == OperationalMode::Manual;
    }

    bool inputs_[static_cast<int>(Input::Count)] = {};
    OperationalMode operationalMode_ = OperationalMode::None;
    bool violation_ = false;
    bool fault_ = false;
    bool protective_ = false;
    bool unlocking_ = false;
    double protectiveTime_ = 0;
    double unlockTime_ = 0;
};

}  // namespace tiller::simulator
