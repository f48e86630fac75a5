// SPDX-License-Identifier: MIT
#pragma once

// The sequence from a controller that is switched off to an arm that can move: DISCONNECTED, CONFIRM_SAFETY,
// BOOTING, POWER_OFF, POWER_ON, BOOTING, IDLE, RUNNING. Requests are accepted at once and take effect after a
// delay, as on a real controller. Source: dashboard guide.

#include "robot/core/modes.h"

namespace tiller::simulator {

/// Duration of each transition [s].
struct PowerTimes {
    double powerOff = 0.1;
    double powerOn = 0.3;
    double booting = 1.2;
    double brakeRelease = 0.8;
};
inline constexpr PowerTimes kFastPowerTimes{0.01, 0.01, 0.01, 0.01};

class PowerSystem {
public:
    explicit PowerSystem(bool poweredOn);
    void setTimes(const PowerTimes& times) { times_ = times; }

    /// Starts the controller: DISCONNECTED, then BOOTING, each for half of `seconds` [s], then POWER_OFF. If
    /// the safety configuration is unconfirmed, the controller waits in CONFIRM_SAFETY between the two.
    void boot(double seconds, bool safetyUnconfirmed);
    /// Confirms the safety configuration, as the operator does on the teach pendant.
    void confirmSafety();

    /// No effect in IDLE and RUNNING. If the arm is being powered off, it is powered on again afterwards.
    void powerOn();
    /// Powers on first if necessary.
    void releaseBrakes();
    void powerOff();
    /// Removes power without delay: stop category 0, or the end of category 1.
    void cut();
    /// Overrides the brakes, so that the joints can be moved by hand. Possible only from IDLE; ends in IDLE.
    void setBackdrive(bool active);

    void step(double dt);
    RobotMode mode() const { return mode_; }
    /// True if the joints are powered.
    bool isPowered() const {
        return mode_ >= RobotMode::PowerOn || (mode_ == RobotMode::Booting && !starting_);
    }

private:
    void enter(RobotMode mode, double stays);
    void forgetWishes();

    PowerTimes times_;
    RobotMode mode_;
    double remaining_ = 0;
    double bootTime_ = 0;    ///< duration of the second half of a start
    bool starting_ = false;  ///< the controller itself is booting
    bool unconfirmed_ = false;
    bool onWanted_ = false;  ///< power on again when power-off is complete
    bool releaseWanted_ = false;
    bool releasing_ = false;
    bool offWanted_ = false;
};

}  // namespace tiller::simulator
