// SPDX-License-Identifier: MIT
#include "robot/simulator/plant/power_system.h"

namespace tiller::simulator {

PowerSystem::PowerSystem(bool poweredOn) : mode_(poweredOn ? RobotMode::Running : RobotMode::PowerOff) {}

void PowerSystem::enter(RobotMode mode, double stays) {
    mode_ = mode;
    remaining_ = stays;
}

void PowerSystem::forgetWishes() {
    onWanted_ = false;
    releaseWanted_ = false;
    releasing_ = false;
    offWanted_ = false;
}

void PowerSystem::boot(double seconds, bool safetyUnconfirmed) {
    forgetWishes();
    starting_ = true;
    unconfirmed_ = safetyUnconfirmed;
    bootTime_ = seconds / 2;
    enter(RobotMode::Disconnected, bootTime_);
}

void PowerSystem::confirmSafety() {
    unconfirmed_ = false;
}

void PowerSystem::powerOn() {
    if (offWanted_) {
        onWanted_ = true;
    } else if (mode_ == RobotMode::PowerOff) {
        enter(RobotMode::PowerOn, times_.powerOn);
    }
}

void PowerSystem::releaseBrakes() {
    const bool canPower = isPowered() || mode_ == RobotMode::PowerOff;
    if (canPower && (mode_ != RobotMode::Running || offWanted_)) {
        powerOn();
        releaseWanted_ = true;
    }
}

void PowerSystem::powerOff() {
    if (!isPowered()) {
        return;
    }
    onWanted_ = false;
    releaseWanted_ = false;
    if (!offWanted_) {
        offWanted_ = true;
        releasing_ = false;
        remaining_ = times_.powerOff;
    }
}

void PowerSystem::cut() {
    if (!starting_) {
        forgetWishes();
        enter(RobotMode::PowerOff, 0);
    }
}

void PowerSystem::setBackdrive(bool active) {
    if (active && mode_ == RobotMode::Idle && !offWanted_) {
        forgetWishes();
        enter(RobotMode::Backdrive, 0);
    } else if (!active && mode_ == RobotMode::Backdrive) {
        enter(RobotMode::Idle, offWanted_ ? remaining_ : 0);
    }
}

void PowerSystem::step(double dt) {
    remaining_ = remaining_ > dt ? remaining_ - dt : 0;
    if (remaining_ > 0) {
        return;
    }
    if (starting_) {
        if (mode_ == RobotMode::Disconnected && unconfirmed_) {
            enter(RobotMode::ConfirmSafety, 0);
        } else if (mode_ == RobotMode::Disconnected || (mode_ == RobotMode::ConfirmSafety && !unconfirmed_)) {
            enter(RobotMode::Booting, bootTime_);
        } else if (mode_ == RobotMode::Booting) {
            starting_ = false;
            enter(RobotMode::PowerOff, 0);
        }
    } else if (offWanted_) {
        const bool on = onWanted_;
        const bool release = releaseWanted_;
        cut();
        onWanted_ = on;
        releaseWanted_ = release;
    } else if (mode_ == RobotMode::PowerOff && onWanted_) {
        onWanted_ = false;
        powerOn();
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
