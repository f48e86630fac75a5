// SPDX-License-Identifier: MIT
#include "robot/simulator/plant/safety_system.h"

namespace tiller::simulator {

namespace {
// Tolerance for rounding errors in sums of periods.
constexpr double kTimeTolerance = 1e-6;
}  // namespace

void SafetySystem::protectiveStop() {
    protective_ = true;
    unlocking_ = false;
    protectiveTime_ = 0;
}

bool SafetySystem::unlockProtectiveStop(bool enforceDelay) {
    if (!protective_) {
        return true;
    }
    if (enforceDelay && protectiveTime_ + kTimeTolerance < kUnlockDelay) {
        return false;
    }
    unlocking_ = true;
    unlockTime_ = 0;
    return true;
}

void SafetySystem::restart() {
    violation_ = false;
    fault_ = false;
    protective_ = false;
    unlocking_ = false;
}

void SafetySystem::step(double dt) {
    if (!protective_) {
        return;
    }
    protectiveTime_ += dt;
    if (unlocking_) {
        unlockTime_ += dt;
        if (unlockTime_ + kTimeTolerance >= kUnlockTime) {
            protective_ = false;
            unlocking_ = false;
        }
    }
}

SafetyMode SafetySystem::status() const {
    if (fault_) {
        return SafetyMode::Fault;
    }
    if (violation_) {
        return SafetyMode::Violation;
    }
    if (isSet(Input::RobotEmergencyStop)) {
        return SafetyMode::RobotEmergencyStop;
    }
    if (isSet(Input::SystemEmergencyStop)) {
        return SafetyMode::SystemEmergencyStop;
    }
    if (protective_) {
        return SafetyMode::ProtectiveStop;
    }
    if (isSet(Input::Safeguard)) {
        return SafetyMode::SafeguardStop;
    }
    if (automaticStop()) {
        return SafetyMode::AutomaticModeSafeguardStop;
    }
    if (enablingStop()) {
        return SafetyMode::SystemThreePositionEnablingStop;
    }
    if (isSet(Input::Recovery)) {
        return SafetyMode::Recovery;
    }
    return isReduced() ? SafetyMode::Reduced : SafetyMode::Normal;
}

SafetyMode SafetySystem::mode() const {
    const SafetyMode now = status();
    return now == SafetyMode::AutomaticModeSafeguardStop || now == SafetyMode::SystemThreePositionEnablingStop
               ? SafetyMode::SafeguardStop
               : now;
}

std::uint32_t SafetySystem::statusBits() const {
    const SafetyMode now = mode();
    const auto bit = [](int n, bool on) { return on ? 1U << n : 0U; };
    return bit(0, now == SafetyMode::Normal) | bit(1, isReduced()) | bit(2, protective_) |
           bit(3, isSet(Input::Recovery)) |
           bit(4, isSet(Input::Safeguard) || automaticStop() || enablingStop()) |
           bit(5, isSet(Input::SystemEmergencyStop)) | bit(6, isSet(Input::RobotEmergencyStop)) |
           bit(7, isEmergencyStopped()) | bit(8, violation_) | bit(9, fault_) |
           bit(10, !allowsMotion(now) && now != SafetyMode::Recovery) | bit(11, enablingStop());
}

}  // namespace tiller::simulator
