// SPDX-License-Identifier: MIT
#include "robot/simulator/plant.h"

#include <cmath>
#include <utility>

#include "robot/simulator/program_runner.h"
#include "robot/simulator/script_host.h"

namespace tiller::simulator {

namespace {

/// Stop category 1: power goes when the arm stands, at the latest after this time [s].
constexpr double kEmergencyStopTime = 0.5;
constexpr double kEmergencyDeceleration = 15.0;  ///< [rad/s2]

arm::ArmOptions armOptions(const ControllerOptions& options) {
    arm::ArmOptions arm;
    arm.period = options.software.controlPeriod();
    arm.seed = options.seed;
    arm.start = options.startJoints;
    return arm;
}

/// Numbers as the vendor's error code manual gives them; C153 and C157 are named in the RTDE guide too.
std::int32_t errorNumber(arm::StopReason reason) {
    switch (reason) {
        case arm::StopReason::JointPositionLimit:
            return 150;
        case arm::StopReason::PoseUnreachable:
        case arm::StopReason::Singularity:
            return 154;
        case arm::StopReason::JointSpeedLimit:
            return 153;
        case arm::StopReason::TcpForceLimit:
            return 157;
    }
    return 153;
}

arm::DriveState driveState(RobotMode mode) {
    switch (mode) {
        case RobotMode::Running:
            return arm::DriveState::Running;
        case RobotMode::PowerOff:
            return arm::DriveState::Off;
        default:
            return arm::DriveState::Braked;
    }
}

JointMode jointMode(RobotMode mode) {
    switch (mode) {
        case RobotMode::Running:
            return JointMode::Running;
        case RobotMode::Idle:
            return JointMode::Idle;
        case RobotMode::PowerOn:
        case RobotMode::Booting:
            return JointMode::Booting;
        default:
            return JointMode::PowerOff;
    }
}

}  // namespace

Plant::Plant(const ControllerOptions& options)
    : options_(options)
    , arm_(robotModel(options.model), armOptions(options))
    , power_(options.poweredOn)
    , host_(std::make_unique<ScriptHost>(*this))
    , programs_(std::make_unique<ProgramRunner>(*this, *host_))
    , remoteControl_(options.remoteControl) {
    if (options.fastTransitions) {
        power_.setTimes(kFastPowerTimes);
    }
    arm_.setDriveState(driveState(power_.mode()));
    refreshTelemetry();
}

Plant::~Plant() {
    programs_->endAll();  // they still speak to the host, which asks this object
}

double Plant::timestamp() const {
    return options_.startTime + static_cast<double>(tick_) * stepTime();
}

void Plant::step() {
    const double dt = stepTime();
    safety_.step(dt);
    reactToSafety();
    stepPower();
    stepWatchdogs();
    host_->beginPeriod();
    programs_->step();
    reactToSafety();  // a script may have asked for a protective stop
    arm_.setSpeedFraction(speedSlider_);
    arm_.step();
    ++tick_;
    reactToArm();
    refreshTelemetry();
}

void Plant::stepPower() {
    if (safety_.mode() == SafetyMode::Violation || safety_.mode() == SafetyMode::Fault) {
        power_.cut();
    } else if (safety_.isEmergencyStopped() && power_.isPowered()) {
        emergencyTime_ += stepTime();
        const bool standing = arm_.state().isStandstill();
        if ((standing && emergencyTime_ > 2 * stepTime()) || emergencyTime_ >= kEmergencyStopTime) {
            power_.cut();
        }
    }
    power_.step(stepTime());
    if (driveState(power_.mode()) != arm_.driveState()) {
        if (arm_.driveState() == arm::DriveState::Running) {
            programs_->stopNow();
        }
        arm_.setDriveState(driveState(power_.mode()));
    }
}

void Plant::stepWatchdogs() {
    const auto action = watchdogs_.step(stepTime());
    if (!action) {
        return;
    }
    if (*action == urscript::WatchdogAction::Stop) {
        programs_->requestStop();
    } else if (*action == urscript::WatchdogAction::Pause) {
        programs_->pause();
    }
}

void Plant::reactToSafety() {
    const SafetyMode now = safety_.mode();
    if (now == lastSafetyMode_) {
        return;
    }
    const SafetyMode before = std::exchange(lastSafetyMode_, now);
    publish(primary::safetyMode(timestampNs(), now));
    switch (now) {
        case SafetyMode::ProtectiveStop:
            arm_.compliance().endForceMode();
            arm_.compliance().endFreedrive();
            programs_->pause();
            pausedBySafeguard_ = false;
            break;
        case SafetyMode::SafeguardStop:
            pausedBySafeguard_ = programs_->state() == RuntimeState::Playing;
            programs_->pause();
            break;
        case SafetyMode::RobotEmergencyStop:
        case SafetyMode::SystemEmergencyStop:
        case SafetyMode::Violation:
        case SafetyMode::Fault:
            emergencyTime_ = 0;
            programs_->stopNow();
            arm_.abort(kEmergencyDeceleration);
            pausedBySafeguard_ = false;
            break;
        default:
            break;
    }
    if (before == SafetyMode::ProtectiveStop && !safety_.isProtectiveStopped()) {
        arm_.clearProtectiveStop();
    }
    if (before == SafetyMode::SafeguardStop && allowsMotion(now) &&
        std::exchange(pausedBySafeguard_, false)) {
        programs_->resume();
    }
}

void Plant::reactToArm() {
    while (arm_.takeWarning()) {
        // Shown on a pendant; no client waits for it.
    }
    if (arm_.protectiveStop() && !safety_.isProtectiveStopped()) {
        const arm::ProtectiveStop& stop = *arm_.protectiveStop();
        protectiveStop({errorNumber(stop.reason), stop.joint + 1, primary::ReportLevel::Warning,
                        arm::stopReasonName(stop.reason)});
    }
    reactToSafety();
    if (arm_.protectiveStop() && safety_.mode() == SafetyMode::Normal) {
        arm_.clearProtectiveStop();
    }
}

void Plant::powerOn() {
    if (!safety_.blocksPower()) {
        power_.powerOn();
    }
}

void Plant::releaseBrakes() {
    if (!safety_.blocksPower()) {
        power_.releaseBrakes();
    }
}

void Plant::restartSafety() {
    programs_->stopNow();
    safety_.restart();
    power_.cut();
    arm_.clearProtectiveStop();
}

void Plant::protectiveStop(const primary::ErrorCode& cause) {
    if (!safety_.isProtectiveStopped()) {
        publish(primary::errorCode(timestampNs(), cause));
        safety_.protectiveStop();
    }
}

void Plant::setSpeedSlider(double fraction) {
    if (!std::isnan(fraction)) {
        speedSlider_ = std::clamp(fraction, 0.0, 1.0);
    }
}

void Plant::setFreedriveButton(bool pressed) {
    freedriveButton_ = pressed;
    if (!pressed) {
        arm_.compliance().endFreedrive();
    } else if (!programs_->isActive() && allowsMotion(safety_.mode())) {
        arm_.compliance().startFreedrive();
    }
}

std::vector<primary::Bytes> Plant::takeOutbox() {
    return std::exchange(outbox_, {});
}

void Plant::refreshTelemetry() {
    Telemetry& t = telemetry_;
    t.arm = &arm_.state();
    t.registers = &registers_;
    t.pins = &pins_;
    t.model = &arm_.model();
    t.software = options_.software;
    t.tick = tick_;
    t.timestamp = timestamp();
    t.robotMode = power_.mode();
    t.safetyMode = safety_.mode();
    t.safetyStatusBits = safety_.statusBits();
    t.runtimeState = programs_->state();
    t.programPaused = programs_->isPaused();
    t.powered = power_.isPowered();
    t.protectiveStopped = safety_.isProtectiveStopped();
    t.emergencyStopped = safety_.isEmergencyStopped();
    t.reduced = safety_.isReduced();
    t.freedriveButton = freedriveButton_;
    t.freedrive = arm_.compliance().isFreedrive();
    t.forceMode = arm_.compliance().isForceMode();
    t.jointMode = jointMode(t.robotMode);
    t.speedSlider = speedSlider_;
    t.speedScaling = programs_->isActive() ? t.arm->speedScaling : 0.0;
    t.timeScaleSource = programs_->isActive() ? 1 : 0;
    t.scriptLine = programs_->currentLine();
    t.tcpOffset = arm_.tcp();
    t.payload = arm_.payload();
    t.gravity = arm_.gravity();
    t.tcpForce = externalSensor_ ? externalForce_ : t.arm->tcpForce;
}

}  // namespace tiller::simulator
