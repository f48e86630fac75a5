// SPDX-License-Identifier: MIT
#pragma once

// The robot behind the sockets: arm, power, safety, terminals, registers and programs, stepped one control
// period at a time. It knows no clients; what it has to say to them it leaves in outbox(), and what it is
// asked to do arrives through its methods. The order within a period is that of a controller: safety, power,
// watchdogs, script frame, arm.

#include <array>
#include <cstdint>
#include <deque>
#include <memory>
#include <string>
#include <vector>

#include "robot/simulator/arm/arm.h"
#include "robot/simulator/box/pins.h"
#include "robot/simulator/box/popups.h"
#include "robot/simulator/box/power_system.h"
#include "robot/simulator/box/registers.h"
#include "robot/simulator/box/safety_system.h"
#include "robot/simulator/box/telemetry.h"
#include "robot/simulator/box/watchdogs.h"
#include "robot/simulator/servers/primary/primary_messages.h"
#include "robot/simulator/simulator.h"

namespace tiller::simulator {

class ProgramRunner;
class ScriptHost;

/// Threads  the simulator's.
class Plant {
public:
    explicit Plant(const SimulatorOptions& options);
    ~Plant();
    Plant(const Plant&) = delete;
    Plant& operator=(const Plant&) = delete;

    /// One control period.
    void step();

    const SimulatorOptions& options() const { return options_; }
    Assumptions& assumptions() { return options_.assumptions; }
    const Assumptions& assumptions() const { return options_.assumptions; }
    double stepTime() const { return arm_.period(); }
    std::uint64_t tick() const { return tick_; }
    /// As clients see it: restarts with the controller [s].
    double timestamp() const;
    /// Since this object was made; never goes back [s].
    double elapsed() const { return static_cast<double>(tick_) * stepTime(); }
    std::uint64_t timestampNs() const { return static_cast<std::uint64_t>(timestamp() * 1e9); }
    /// As of the last step; refers to this object.
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
    ProgramRunner& programs() { return *programs_; }
    const ProgramRunner& programs() const { return *programs_; }
    Watchdogs& watchdogs() { return watchdogs_; }
    Popups& popups() { return popups_; }
    ScriptHost& scriptHost() { return *host_; }

    // Requests that touch more than one part.
    void powerOn();
    void releaseBrakes();
    /// Clears violations and faults; the arm is off afterwards.
    void restartSafety();
    /// Stops at once, with the message that says why. The fiftieth of one joint within eight hours is a fault
    /// (C163); the joint is the cause's argument, from 1.
    void protectiveStop(const primary::ErrorCode& cause);
    /// Words for the cause of the last protective stop; empty: there was none, or it has none.
    const std::string& stopText() const { return stopText_; }
    /// fraction  held to 0..1; not a number is ignored
    void setSpeedSlider(double fraction);
    double speedSlider() const { return speedSlider_; }
    void setFreedriveButton(bool pressed);
    /// What an external sensor measures, from RTDE [N, Nm].
    void setExternalForceTorque(const Wrench& wrench) { externalForce_ = wrench; }
    void setExternalSensorInUse(bool inUse) { externalSensor_ = inUse; }
    /// The pendant's switch; leaving Remote ends the script connections.
    void setRemoteControl(bool remote);
    bool isRemoteControl() const { return remoteControl_; }
    /// Whether a connection made now may send scripts. CB3 knows no local control.
    bool takesScripts() const {
        return remoteControl_ || !options_.gateLocalControl || options_.software.isCb3();
    }
    /// Counts the changes of that switch: what a connection may do is settled by the one it was made under.
    std::uint64_t controlEpoch() const { return controlEpoch_; }
    /// Power of the arm lost without a word, as when its supply fails.
    void losePower();
    /// The controller starts anew; timestamp begins at 0.  seconds  until POWER_OFF
    void restart(double seconds, bool safetyUnconfirmed);
    /// Moves joints by hand, brakes overridden.
    void setBackdrive(bool active);
    /// Ends the running program with a runtime exception.
    void failProgram(const std::string& why);
    /// What the controller reports as its kinematics differs from the arm's by so much: 0 not at all, 1 up to
    /// 1 mm and 1 mrad. Primary clients are told anew.
    void setCalibrationError(double size);
    /// The controller goes off: nothing answers any more.
    void shutDown() { shutDown_ = true; }
    bool isShutDown() const { return shutDown_; }

    /// Shows a popup and tells primary clients. Returns its id.
    int showPopup(const std::string& text, bool blocking);
    /// What the pendant's log would show and whoever started this program should know: to primary clients as
    /// a text message, and to the error output.
    void tellLog(const std::string& text);
    /// A message for primary clients.
    void publish(primary::Bytes message) { outbox_.push_back(std::move(message)); }
    std::vector<primary::Bytes> takeOutbox();

private:
    void reactToSafety();
    void stepPower();
    void stepWatchdogs();
    void stepArm();
    void reactToArm();
    void followBoot();
    void refreshTelemetry();

    SimulatorOptions options_;
    RobotModel model_;  ///< with the arm's own calibration
    arm::Arm arm_;
    RobotModel reported_;  ///< the model as told to clients
    Registers registers_;
    Registers shown_;          ///< as clients see them, where that is a period later
    RegisterBank lastOutput_;  ///< as the period before left them
    Pins pins_;
    SafetySystem safety_;
    PowerSystem power_;
    Watchdogs watchdogs_;
    Popups popups_;
    std::unique_ptr<ScriptHost> host_;
    std::unique_ptr<ProgramRunner> programs_;
    Telemetry telemetry_;
    std::vector<primary::Bytes> outbox_;

    std::uint64_t tick_ = 0;
    std::uint64_t startTick_ = 0;  ///< when the controller started
    double startTime_ = 0;         ///< timestamp then [s]
    std::uint64_t controlEpoch_ = 0;
    std::uint64_t identity_ = 0;  ///< counts changes of what primary clients are told once
    bool disconnected_ = false;
    std::string stopText_;
    std::array<std::deque<double>, kJointCount> jointStops_;  ///< when each joint was stopped [s]
    std::uint64_t boots_ = 0;                                 ///< how often the services came up anew
    double speedSlider_ = 1;
    SafetyMode lastSafetyMode_ = SafetyMode::Normal;
    double emergencyTime_ = 0;  ///< [s] since an emergency stop began, while the arm still has power
    bool freedriveButton_ = false;
    bool externalSensor_ = false;
    bool pausedBySafeguard_ = false;
    bool heldBySafeguard_ = false;  ///< the arm alone, while the program runs on
    Wrench externalForce_;
    bool remoteControl_ = true;
    bool shutDown_ = false;
};

}  // namespace tiller::simulator
