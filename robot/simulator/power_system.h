// SPDX-License-Identifier: MIT
#pragma once

// The way from a cold arm to one that can move: POWER_OFF, POWER_ON, BOOTING, IDLE, RUNNING. Requests are
// accepted at once and take effect in time, as on a real controller. Source: dashboard guide.

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

    /// Nothing happens in IDLE and RUNNING.
    void powerOn();
    /// Powers on first where needed.
    void releaseBrakes();
    void powerOff();
    /// Power removed without delay: stop category 0, or the end of category 1.
    void cut();

    void step(double dt);
    RobotMode mode() const { return mode_; }
    /// There is voltage at the joints.
    bool isPowered() const { return mode_ != RobotMode::PowerOff; }

private:
    void enter(RobotMode mode, double stays);

    PowerTimes times_;
    RobotMode mode_;
    double remaining_ = 0;
    bool releaseWanted_ = false;
    bool releasing_ = false;
    bool offWanted_ = false;
};

}  // namespace tiller::simulator
