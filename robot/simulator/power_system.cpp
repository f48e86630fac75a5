// SPDX-License-Identifier: MIT
#include "robot/simulator/power_system.h"

namespace tiller::simulator {

PowerSystem::PowerSystem(bool poweredOn) : mode_(poweredOn ? RobotMode::Running : RobotMode::PowerOff) {}

void PowerSystem::enter(RobotMode mode, double stays) {
    mode_ = mode;
    remaining_ = stays;
}

void PowerSystem::powerOn() {
    if (mode_ == RobotMode::PowerOff) {
        offWanted_ = false;
        enter(RobotMode::PowerOn, times_.powerOn);
    }
}

void PowerSystem::releaseBrakes() {
    if (mode_ != RobotMode::Running) {
        powerOn();
        releaseWanted_ = true;
    }
}

void PowerSystem::powerOff() {
    if (mode_ != RobotMode::PowerOff && !offWanted_) {
        offWanted_ = true;
        releaseWanted_ = false;
        releasing_ = false;
        remaining_ = times_.powerOff;
    }
}

void PowerSystem::cut() {
    offWanted_ = false;
    releaseWanted_ = false;
    releasing_ = false;
    enter(RobotMode::PowerOff, 0);
}

void PowerSystem::step(double dt) {
    remaining_ = remaining_ > dt ? remaining_ - dt : 0;
    if (remaining_ > 0) {
        return;
    }
    if (offWanted_) {
        cut();
    } else if (mode_ == RobotMode::PowerOn) {
        enter(RobotMode::Booting, times_.booting);
    } else if (mode_ == RobotMode::Booting) {
        enter(RobotMode::Idle, 0);
    } else if (mode_ == RobotMode::Idle && releasing_) {
        releasing_ = false;
        enter(RobotMode::Running, 0);
    } else if (mode_ == RobotMode::Idle && releaseWanted_) {
        releaseWanted_ = false;
        releasing_ = true;
        remaining_ = times_.brakeRelease;
    }
}

}  // namespace tiller::simulator
