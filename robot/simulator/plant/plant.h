// SPDX-License-Identifier: MIT
#pragma once

// The robot without its programs and network services: arm, power, safety, terminals and registers. The model
// is independent of clients: it queues messages to clients, and requests arrive through its methods.
// ControllerModel adds the programs and advances the robot.

#include <array>
#include <cstdint>
#include <deque>
#include <string>
#include <vector>

#include "robot/simulator/arm/arm.h"
#include "robot/simulator/options/simulator_options.h"
#include "robot/simulator/plant/encoders.h"
#include "robot/simulator/plant/pins.h"
#include "robot/simulator/plant/popups.h"
#include "robot/simulator/plant/power_system.h"
#include "robot/simulator/plant/primary_messages.h"
#include "robot/simulator/plant/registers.h"
#include "robot/simulator/plant/running_programs.h"
#include "robot/simulator/plant/safety_system.h"
#include "robot/simulator/plant/telemetry.h"
#include "robot/simulator/plant/watchdogs.h"

namespace tiller::simulator {

/// Threads  the simulator thread
class Plant {
public:
    Plant(const Plant&) = delete;
    Plant& operator=(const Plant&) = delete;

    const SimulatorOptions& options() const { return options_; }
    BehaviourOptions& assumptions() { return options_.assumptions; }
    const BehaviourOptions& assumptions() const { return options_.assumptions; }
    double stepTime() const { return arm_.period(); }
    std::uint64_t tick() const { return tick_; }
    /// Controller time as reported to clients [s]. Starts at 0 when the controller restarts.
    double timestamp() const;
    /// Time since construction [s]. Never decreases.
    double elapsed() const { return static_cast<double>(tick_) * stepTime(); }
    std::uint64_t timestampNs() const { return static_cast<std::uint64_t>(timestamp() * 1e9); }
    /// State after the last step. Refers to data of this object.
    const Telemetry& telemetry() const { return telemetry_; }

    arm::Arm& arm() { return arm_; }
    const arm::Arm& arm() const { return arm_; }
    Registers& registers() { return registers_; }
    const Registers& registers() const { return registers_; }
    Pins& pins() { return pins_; }
    const Pins& pins() const { return pins_; }
    SafetySystem& safety() { return safety_; }
    const SafetySystem& safety() const { return safety_; }
    PowerSystem& power() { return power_; }
    const PowerSystem& power() const { return power_; }
    Encoders& encoders() { return encoders_; }
    const Encoders& encoders() const { return encoders_; }
    virtual RunningPrograms& programs() = 0;
    virtual const RunningPrograms& programs() const = 0;
    Watchdogs& watchdogs() { return watchdogs_; }
    Popups& popups() { return popups_; }

    // Requests that affect several parts of the robot.
    void powerOn();
    void releaseBrakes();
    /// Clears violations and faults. The arm is then powered off.
    void restartSafety();
    /// Stops at once with the message for the cause. The fiftieth stop of one joint within eight hours is a
    /// fault (C163). The argument of the cause is the joint, counted from 1.
    void protectiveStop(const primary::ErrorCode& cause);
    /// Text for the cause of the last protective stop; empty if there was no stop or no text.
    const std::string& stopText() const { return stopText_; }
    /// fraction  clamped to 0..1; NaN is ignored
    void setSpeedSlider(double fraction);
    double speedSlider() const { return speedSlider_; }
    void setFreedriveButton(bool pressed);
    /// Sets the reading of an external sensor, received through RTDE [N, Nm].
    void setExternalForceTorque(const Wrench& wrench) { externalForce_ = wrench; }
    void setExternalSensorInUse(bool inUse) { externalSensor_ = inUse; }
    /// Sets the Local/Remote switch of the teach pendant. Use ControllerServices::setRemoteControl(), which
    /// also closes the script connections and stops the program, depending on the options.
    void setRemoteControl(bool remote);
    bool isRemoteControl() const { return remoteControl_; }
    /// True if a connection opened now may send scripts. CB3 has no local control.
    bool takesScripts() const {
        return remoteControl_ || !options_.gateLocalControl || options_.software.isCb3();
    }
    /// Number of changes of the Local/Remote switch. A connection keeps the rights of the time at which it
    /// was opened.
    std::uint64_t controlEpoch() const { return controlEpoch_; }
    /// Removes the power of the arm without a message, like a power supply failure.
    void losePower();
    /// Restarts the controller; its time begins at 0.
    /// seconds  duration until POWER_OFF
    void restart(double seconds, bool safetyUnconfirmed);
    /// Overrides the brakes, so that the joints can be moved by hand.
    void setBackdrive(bool active);
    /// Ends the running program with a runtime exception.
    void failProgram(const std::string& why);
    /// Sets the deviation of the reported kinematics from the actual arm. 0: no deviation; 1: up to 1 mm and
    /// 1 mrad. Sends the kinematics to primary clients again.
    void setCalibrationError(double size);
    /// Shuts the controller down. All services stop responding.
    void shutDown() { shutDown_ = true; }
    bool isShutDown() const { return shutDown_; }

    /// Shows a popup, reports it to primary clients, and returns its ID.
    int showPopup(const std::string& text, bool blocking);
    /// Reports a message that a real controller shows only in the log of the teach pendant: sends it to
    /// primary clients as a text message and writes it to stderr.
    void appendToLog(const std::string& text);
    /// Queues a message for primary clients.
    void publish(primary::Bytes message) { outbox_.push_back(std::move(message)); }
    std::vector<primary::Bytes> takeOutbox();

protected:
    explicit Plant(const SimulatorOptions& options);
    ~Plant() = default;

    /// Runs the part of a period before the programs: safety, power, watchdogs.
    void beginPeriod();
    /// Applies a change of the safety mode to the programs and the arm.
    void reactToSafety();
    /// Runs the part of a period after the programs: the arm and the values reported to clients.
    void endPeriod();
    void refreshTelemetry();

private:
    void stepPower();
    void stepWatchdogs();
    void stepArm();
    void reactToArm();
    void followBoot();

    SimulatorOptions options_;
    RobotModel model_;  ///< actual arm, with its calibration
    arm::Arm arm_;
    RobotModel reported_;  ///< the model reported to clients
    Registers registers_;
    Registers shown_;          ///< registers as reported to clients if the report is delayed by one period
    RegisterBank lastOutput_;  ///< output registers at the end of the previous period
    Pins pins_;
    SafetySystem safety_;
    PowerSystem power_;
    Watchdogs watchdogs_;
    Popups popups_;
    Encoders encoders_;
    Telemetry telemetry_;
    std::vector<primary::Bytes> outbox_;

    std::uint64_t tick_ = 0;
    std::uint64_t startTick_ = 0;  ///< start time of the controller
    double startTime_ = 0;         ///< timestamp at startTick_ [s]
    std::uint64_t controlEpoch_ = 0;
    std::uint64_t identity_ = 0;  ///< incremented when values change that primary clients receive only once
    bool disconnected_ = false;
    std::string stopText_;
    std::array<std::deque<double>, kJointCount> jointStops_;  ///< protective stops of each joint [s]
    std::uint64_t boots_ = 0;                                 ///< number of times the services have started
    double speedSlider_ = 1;
    SafetyMode lastSafetyMode_ = SafetyMode::Normal;
    double emergencyTime_ = 0;  ///< time since an emergency stop began while the arm has power [s]
    bool freedriveButton_ = false;
    bool externalSensor_ = false;
    bool pausedBySafeguard_ = false;
    bool heldBySafeguard_ = false;  ///< only the arm is stopped; the program continues
    Wrench externalForce_;
    bool remoteControl_ = true;
    bool shutDown_ = false;
};

}  // namespace tiller::simulator
