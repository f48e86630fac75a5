// SPDX-License-Identifier: MIT
#pragma once

// Executes a script in a simulated controller without sockets or threads. Each call of step() runs one
// control period without waiting. Interpreter, arm and terminals are the same as in Simulator.

#include <QJsonValue>
#include <QString>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "robot/core/joints.h"
#include "robot/core/modes.h"
#include "robot/core/robot_model.h"
#include "robot/core/spatial.h"
#include "robot/core/version.h"

namespace tiller::simulator {

struct ScriptRunOptions {
    RobotModelId model = RobotModelId::UR5e;
    SoftwareVersion software{5, 22, 1, 1214193};
    JointPositions start;       ///< [rad]
    std::optional<Pose> tcp;    ///< flange to TCP at the start [m, rad]; empty: the flange
    int followedRegister = 47;  ///< output integer register whose values takeWritten() returns
    std::uint64_t seed = 1;     ///< seed for measurement noise and the script's random()
    std::vector<std::string> followedVariables = {};  ///< global variables for followedVariable()
};

/// An event that ends the script from outside.
enum class StopEvent {
    ProtectiveStop,  ///< same stop as after a collision
    OperatorStop,    ///< the stop button of the teach pendant
    EmergencyStop,   ///< the emergency stop button of the teach pendant
    PowerLoss,       ///< the supply of the arm fails
};

/// Why a script did not compile or ended early.
struct ScriptFault {
    int line = 0;  ///< counted from 1; 0: unknown
    QString text;  ///< error message of the controller
};

/// State that the controller keeps after a script has ended.
struct ControllerState {
    std::uint64_t digitalOutputs = 0;                 ///< 0-7 standard, 8-15 configurable, 16-17 tool
    std::array<double, 2> analogOutputs{};            ///< 0..1 of the range
    std::array<bool, 128> boolRegisters{};            ///< output registers
    std::array<std::int32_t, 48> integerRegisters{};  ///< output registers; the followed register is always 0
    std::array<double, 48> floatRegisters{};          ///< output registers
    Pose tcp;                                         ///< flange to TCP [m, rad]
    double payload = 0;                               ///< [kg]
    Eigen::Vector3d payloadCentre = Eigen::Vector3d::Zero();  ///< centre of gravity in the flange frame [m]

    friend bool operator==(const ControllerState&, const ControllerState&) = default;
};

/// Threads  one at a time. No function blocks.
class ScriptRun {
public:
    explicit ScriptRun(const ScriptRunOptions& options);
    ~ScriptRun();
    ScriptRun(const ScriptRun&) = delete;
    ScriptRun& operator=(const ScriptRun&) = delete;

    /// Compiles the script without running it.
    /// Returns  the error; empty without an error
    static std::optional<ScriptFault> check(const QString& script, const SoftwareVersion& software);

    /// True if the name is a keyword or a builtin, and therefore not permitted for functions.
    static bool isReservedName(const QString& name);

    /// Compiles the script and starts it. The first step() runs its first period.
    /// Returns  the error; empty without an error
    std::optional<ScriptFault> start(const QString& script);
    /// Runs one control period.
    /// Returns  false when the script has ended, or when a stop has paused it
    bool step();

    double stepTime() const;   ///< [s]
    double time() const;       ///< time since start() [s]
    JointPositions q() const;  ///< target position: target_q [rad]
    Pose tcpPose() const;      ///< pose at this position: target_TCP_pose [m, rad], base frame
    bool isStandstill() const;
    double tcpForce() const;                      ///< force at the TCP as an RTDE client receives it [N]
    std::uint64_t digitalOutputs() const;         ///< 0-7 standard, 8-15 configurable, 16-17 tool
    std::array<double, 2> analogOutputs() const;  ///< levels at the terminals [A or V]
    /// Last value of a global variable in ScriptRunOptions::followedVariables, also after the end of the
    /// script: true or false, a number, a string, or a list of numbers for a pose or a list. Undefined if the
    /// script has not set the variable.
    QJsonValue followedVariable(const std::string& name) const;
    SafetyMode safetyMode() const;
    ControllerState controllerState() const;
    void setControllerState(const ControllerState& state);
    /// Value of a global variable of the running script, as text; empty if the variable does not exist.
    std::optional<QString> variable(const QString& name) const;
    /// Returns the values that the script has written to the followed register since the last call.
    std::vector<std::int32_t> takeWritten();
    /// Why the script failed; empty if it is running or has ended normally.
    std::optional<ScriptFault> failure() const;
    /// Text for the cause of a protective stop; empty if there was no stop.
    QString stopText() const;

    /// True while the script shows a message or a question and waits for the operator.
    bool waitsForOperator() const;
    bool waitsForAnswer() const;  ///< True while the script waits for an answer to a question.
    /// Closes the message or answers the question with true or false, a number, or a string.
    /// answer   undefined: "no", zero or an empty string
    /// Returns  false if `answer` was not used, because there is no question or it requires another type. A
    ///          question is then answered as for undefined
    bool answerOperator(const QJsonValue& answer = QJsonValue::Undefined);

    void setDigitalInput(int channel, bool value);  ///< channels as in digitalOutputs()
    void setAnalogInput(int number, double value);  ///< number 0 or 1; [A or V]
    void setInputInteger(int number,
                         std::int32_t value);         ///< integer register, as written by an RTDE client
    void setHandForce(const Eigen::Vector3d& force);  ///< hand force at the TCP [N], base frame
    void stop(StopEvent event);                       ///< Takes effect in the next step.

private:
    class Impl;
    std::unique_ptr<Impl> d_;
};

}  // namespace tiller::simulator
