// SPDX-License-Identifier: MIT
#include "robot/simulator/plant/plant.h"

#include <QLoggingCategory>
#include <cmath>
#include <utility>

#include "robot/kinematics/parallel_axes.h"

namespace tiller::simulator {

Q_LOGGING_CATEGORY(simulatorLog, "tiller.simulator")

namespace {

/// Maximum braking time of a category 1 stop [s]. Power is removed at standstill or after this time.
constexpr double kEmergencyStopTime = 0.5;
constexpr double kEmergencyDeceleration = 15.0;  ///< [rad/s2]
/// Maximum TCP speed of the program in reduced mode [m/s]. Installations can set other values.
constexpr double kReducedToolSpeed = 0.75;
/// Maximum TCP speed while a joint is outside its safety limits [m/s]. Source: User Manual, "Recovery mode"
constexpr double kRecoveryToolSpeed = 0.25;

arm::ArmOptions armOptions(const SimulatorOptions& options) {
    arm::ArmOptions arm;
    arm.period = options.software.controlPeriod();
    arm.seed = options.seed;
    arm.start = options.startJoints;
    return arm;
}

/// Error numbers from the vendor's error code manual. C153, C157, C158 and C159 are also in the RTDE guide.
/// The texts were written for this simulator.
struct StopMessage {
    std::int32_t code;
    const char* text;
};
StopMessage stopMessage(arm::StopReason reason) {
    switch (reason) {
        case arm::StopReason::JointPositionLimit:
            return {150, "a joint reached the end of its range"};
        case arm::StopReason::PoseUnreachable:
            return {154, "the path leaves the arm's reach"};
        case arm::StopReason::Singularity:
            return {154, "the path passes through a singularity"};
        case arm::StopReason::JointSpeedLimit:
            return {153, "the path is faster than a joint can follow"};
        case arm::StopReason::Overload:
            return {155, "the arm cannot hold its position: check the payload"};
        case arm::StopReason::WrongPayload:
            return {156, "wrong payload, or the arm was pushed when freedrive started"};
        case arm::StopReason::TcpForceLimit:
            return {158, "the tool touched a hard object"};
        case arm::StopReason::PathDeviation:
            return {159, "force mode left the programmed path by more than its limits allow"};
    }
    return {153, ""};
}

/// Simulated execution time of the robot's real-time thread [ms]. Identical in each run.
double executionTime(std::uint64_t tick, bool programActive) {
    const auto scatter = static_cast<double>(tick * 2654435761U >> 8U & 0xFFU) / 255.0;
    return (programActive ? 0.52 : 0.45) + 0.06 * scatter;
}

/// Returns an arm model with manufacturing tolerances of up to `size` mm and mrad.
RobotModel deviating(const RobotModel& model, double size) {
    RobotModel result = model;
    DhParameters& dh = result.dh;
    for (std::size_t i = 0; i < dh.a.size() && size != 0; ++i) {
        // Any fixed pattern is suitable, but the values must be the same each time, because clients hash
        // them.
        const double off = size * 1e-3 * std::sin(1.0 + 2.0 * static_cast<double>(i));
        const bool parallel = i == 1 || i == 2;
        dh.theta[i] += off;
        dh.a[i] += off;
        dh.d[i] -= parallel ? 0 : off;
        dh.alpha[i] -= off;
        dh.beta[i] += parallel ? off : 0;
    }
    return result;
}

arm::DriveState driveState(const PowerSystem& power) {
    if (power.mode() == RobotMode::Running || power.mode() == RobotMode::Backdrive) {
        return arm::DriveState::Running;
    }
    return power.isPowered() ? arm::DriveState::Braked : arm::DriveState::Off;
}

JointMode jointMode(const PowerSystem& power) {
    if (!power.isPowered()) {
        return JointMode::PowerOff;
    }
    switch (power.mode()) {
        case RobotMode::Running:
            return JointMode::Running;
        case RobotMode::Idle:
            return JointMode::Idle;
        case RobotMode::Backdrive:
            return JointMode::Backdrive;
        case RobotMode::PowerOn:
        case RobotMode::Booting:
            return JointMode::Booting;
        default:
            return JointMode::PowerOff;
    }
}

}  // namespace

Plant::Plant(const SimulatorOptions& options)
    : options_(options)
    , model_(deviating(robotModel(options.model), options.calibration))
    , arm_(model_, armOptions(options))
    , reported_(model_)
    , power_(options.poweredOn)
    , startTime_(options.startTime)
    , remoteControl_(options.remoteControl) {
    if (options.fastTransitions) {
        power_.setTimes(kFastPowerTimes);
    }
    if (options.bootTime > 0 || options.safetyUnconfirmed) {
        power_.boot(options.bootTime, options.safetyUnconfirmed);
        startTime_ = 0;
    }
    setCalibrationError(options.calibrationError);
    arm_.setDriveState(driveState(power_));
}

double Plant::timestamp() const {
    return startTime_ + static_cast<double>(tick_ - startTick_) * stepTime();
}

void Plant::beginPeriod() {
    const double dt = stepTime();
    safety_.step(dt);
    reactToSafety();
    stepPower();
    stepWatchdogs();
}

void Plant::endPeriod() {
    stepArm();
    ++tick_;
    reactToArm();
    refreshTelemetry();
}

void Plant::stepArm() {
    arm_.setExternalForce(externalSensor_ ? std::optional(externalForce_) : std::nullopt);
    arm_.setToolSpeedLimit(safety_.mode() == SafetyMode::Recovery ? std::optional(kRecoveryToolSpeed)
                           : safety_.isReduced()                  ? std::optional(kReducedToolSpeed)
                                                                  : std::nullopt);
    arm_.setSpeedFraction(speedSlider_);
    const BehaviourOptions& a = options_.assumptions;
    arm_.setReadings({a.stops == BehaviourOptions::Time::Scaled,
                      a.programStops == BehaviourOptions::Time::Scaled,
                      a.speedCommands == BehaviourOptions::SpeedCommands::Scaled,
                      a.pause == BehaviourOptions::Pause::Frees});
    arm_.step();
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
    followBoot();
    if (driveState(power_) != arm_.driveState()) {
        const bool pauses = safety_.isEmergencyStopped() &&
                            options_.assumptions.emergencyStop == BehaviourOptions::EmergencyStop::Pauses;
        if (arm_.driveState() == arm::DriveState::Running && !pauses) {
            programs().stopNow();
        }
        arm_.setDriveState(driveState(power_));
    }
}

void Plant::stepWatchdogs() {
    const auto action = watchdogs_.step(stepTime());
    if (!action) {
        return;
    }
    if (*action == urscript::WatchdogAction::Stop) {
        programs().requestStop();
    } else if (*action == urscript::WatchdogAction::Pause) {
        programs().pause();
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
            programs().haltForProtectiveStop();
            pausedBySafeguard_ = false;
            break;
        case SafetyMode::SafeguardStop:
            if (options_.assumptions.safeguard == BehaviourOptions::Safeguard::Runs) {
                heldBySafeguard_ = true;
                arm_.hold();
                break;
            }
            pausedBySafeguard_ = programs().state() == RuntimeState::Playing;
            programs().pause();
            break;
        case SafetyMode::RobotEmergencyStop:
        case SafetyMode::SystemEmergencyStop:
            if (options_.assumptions.emergencyStop == BehaviourOptions::EmergencyStop::Pauses) {
                emergencyTime_ = 0;
                pausedBySafeguard_ = false;
                programs().pause();
                break;
            }
            [[fallthrough]];
        case SafetyMode::Violation:
        case SafetyMode::Fault:
            emergencyTime_ = 0;
            programs().stopNow();
            arm_.abort(kEmergencyDeceleration);
            pausedBySafeguard_ = false;
            break;
        default:
            break;
    }
    if (before == SafetyMode::ProtectiveStop && !safety_.isProtectiveStopped()) {
        arm_.clearProtectiveStop();
        if (options_.assumptions.protectiveStop == BehaviourOptions::ProtectiveStop::Resumes &&
            allowsMotion(now)) {
            programs().resume();
        }
    }
    if (before == SafetyMode::SafeguardStop && std::exchange(heldBySafeguard_, false)) {
        arm_.resume();
    }
    if (before == SafetyMode::SafeguardStop && allowsMotion(now) &&
        std::exchange(pausedBySafeguard_, false) &&
        options_.assumptions.safeguardReset == BehaviourOptions::Reset::Resumes) {
        programs().resume();
    }
}

void Plant::reactToArm() {
    while (arm_.takeWarning()) {
        // Warnings are only shown on the teach pendant. No client waits for them.
    }
    if (arm_.protectiveStop() && !safety_.isProtectiveStopped()) {
        const arm::ProtectiveStop& stop = *arm_.protectiveStop();
        const StopMessage message = stopMessage(stop.reason);
        protectiveStop({message.code, stop.joint + 1, primary::ReportLevel::Warning, message.text});
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

void Plant::losePower() {
    programs().stopNow();
    power_.cut();
}

void Plant::restart(double seconds, bool safetyUnconfirmed) {
    losePower();
    safety_.restart();
    arm_.clearProtectiveStop();
    power_.boot(seconds, safetyUnconfirmed);
    startTick_ = tick_;
    startTime_ = 0;
    disconnected_ = true;
}

void Plant::followBoot() {
    // During a start, the RTDE service restarts and time begins at 0. Source: urcl, which waits for this.
    const bool was = std::exchange(disconnected_, power_.mode() == RobotMode::Disconnected);
    if (was && !disconnected_) {
        startTick_ = tick_;
        startTime_ = 0;
        ++boots_;
    }
}

void Plant::setBackdrive(bool active) {
    power_.setBackdrive(active);
    if (power_.mode() == RobotMode::Backdrive) {
        arm_.setDriveState(driveState(power_));
        arm_.compliance().startFreedrive();
    } else {
        arm_.compliance().endFreedrive();
    }
}

void Plant::failProgram(const std::string& why) {
    publish(primary::runtimeException(timestampNs(), static_cast<std::int32_t>(programs().currentLine()), 1,
                                      why));
    programs().stopNow();
}

void Plant::setRemoteControl(bool remote) {
    controlEpoch_ += remote == remoteControl_ ? 0 : 1;
    remoteControl_ = remote;
}

void Plant::setCalibrationError(double size) {
    reported_ = deviating(model_, size);
    reported_.dh = kinematics::asDenavitHartenberg(reported_.dh);
    ++identity_;
}

void Plant::restartSafety() {
    programs().stopNow();
    safety_.restart();
    power_.cut();
    arm_.clearProtectiveStop();
}

void Plant::protectiveStop(const primary::ErrorCode& cause) {
    if (safety_.isProtectiveStopped()) {
        return;
    }
    publish(primary::errorCode(timestampNs(), cause));
    stopText_ = cause.text;
    safety_.protectiveStop();
    constexpr std::size_t kMaxStops = 50;
    constexpr double kWithin = 8 * 3600.0;
    if (cause.argument < 1 || cause.argument > kJointCount) {
        return;
    }
    std::deque<double>& stops = jointStops_[static_cast<std::size_t>(cause.argument - 1)];
    stops.push_back(elapsed());
    while (stops.front() < elapsed() - kWithin) {
        stops.pop_front();
    }
    if (stops.size() >= kMaxStops) {
        stops.clear();
        constexpr std::int32_t kTooManyStops = 163;
        publish(primary::errorCode(timestampNs(),
                                   {kTooManyStops, cause.argument, primary::ReportLevel::Fault, ""}));
        safety_.fault();
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
    } else if (!programs().isActive() && allowsMotion(safety_.mode())) {
        arm_.compliance().startFreedrive();
    }
}

int Plant::showPopup(const std::string& text, bool blocking) {
    const int id = popups_.open(blocking);
    publish(primary::popup(timestampNs(), {static_cast<std::uint32_t>(id), false, false, blocking, "", text},
                           options_.software));
    return id;
}

void Plant::appendToLog(const std::string& text) {
    qCWarning(simulatorLog).noquote() << QString::fromStdString(text);
    publish(primary::text(timestampNs(), text));
}

std::vector<primary::Bytes> Plant::takeOutbox() {
    return std::exchange(outbox_, {});
}

void Plant::refreshTelemetry() {
    Telemetry& t = telemetry_;
    t.arm = &arm_.state();
    t.registers = &registers_;
    if (options_.assumptions.outputs == BehaviourOptions::Outputs::NextPeriod) {
        shown_ = registers_;
        shown_.output = std::exchange(lastOutput_, registers_.output);
        t.registers = &shown_;
    }
    t.pins = &pins_;
    t.model = &reported_;
    t.identity = identity_;
    t.boots = boots_;
    t.software = options_.software;
    t.bitsAsIntegers = assumptions().realtimeBits == BehaviourOptions::RealtimeBits::Integer;
    t.tick = tick_;
    t.timestamp = timestamp();
    t.executionTime = executionTime(tick_, programs().isActive());
    t.robotMode = power_.mode();
    t.safetyMode = safety_.mode();
    t.safetyStatus = safety_.status();
    t.operationalMode = safety_.operationalMode();
    t.safetyStatusBits = safety_.statusBits();
    t.runtimeState = programs().state();
    t.programPaused = programs().isPaused();
    t.powered = power_.isPowered();
    t.protectiveStopped = safety_.isProtectiveStopped();
    t.emergencyStopped = safety_.isEmergencyStopped();
    t.reduced = safety_.isReduced();
    t.freedriveButton = freedriveButton_;
    t.freedrive = arm_.compliance().isFreedrive();
    t.forceMode = arm_.compliance().isForceMode();
    t.jointMode = jointMode(power_);
    t.speedSlider = speedSlider_;
    t.speedScaling = programs().isActive() ? t.arm->speedScaling : 0.0;
    t.timeScaleSource = programs().isActive() ? t.arm->scaledBy : arm::TimeScaleSource::NoProgram;
    t.scriptLine = programs().currentLine();
    t.encoders = {encoders_.raw(0), encoders_.raw(1)};
    t.tcpOffset = arm_.tcp();
    t.payload = arm_.payload();
    t.gravity = arm_.gravity();
    t.tcpForce = externalSensor_ ? externalForce_ : t.arm->tcpForce;
}

}  // namespace tiller::simulator
