// SPDX-License-Identifier: MIT
#pragma once

// The way from a cold controller to an arm that can move: DISCONNECTED, CONFIRM_SAFETY, BOOTING, POWER_OFF,
// POWER_ON, BOOTING, IDLE, RUNNING. Requests are accepted at once and take effect in time, as on a real
// controller. Source: dashboard guide.

#include "robot/core/modes.h"

namespace tiller::simulator {

/// How long each transition takes [s].
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

    /// The controller starts: DISCONNECTED, then BOOTING, each for half the time [s], then POWER_OFF. With
    /// an unconfirmed safety configuration it waits in CONFIRM_SAFETY in between.
    void boot(double seconds, bool safetyUnconfirmed);
    /// Actions of the operator on the pendant.
    void confirmSafety();

    /// Nothing happens in IDLE and RUNNING. While the power goes off it comes back on afterwards.
    void powerOn();
    /// Powers on first where needed.
    void releaseBrakes();
    void powerOff();
    /// Power removed without delay: stop category 0, or the end of category 1.
    void cut();
    /// Joints moved by hand, brakes overridden: only from IDLE, and back to it.
    void setBackdrive(bool active);

    void step(double dt);
    RobotMode mode() const { return mode_; }
    /// There is voltage at the joints.
    bool isPowered() const {
        return mode_ >= RobotMode::PowerOn || (mode_ == RobotMode::Booting && !starting_);
    }

private:
    void enter(RobotMode mode, double stays);
    void forgetWishes();

    PowerTimes times_;
    RobotMode mode_;
    double remaining_ = 0;
    double bootTime_ = 0;    ///< of the second half of a start
    bool starting_ = false;  ///< the controller itself boots
    bool unconfirmed_ = false;
    bool onWanted_ = false;  ///< once the power has gone
    bool releaseWanted_ = false;
    bool releasing_ = false;
    bool offWanted_ = false;
};

}  // namespace tiller::simulator
