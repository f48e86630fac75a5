// SPDX-License-Identifier: MIT
#pragma once

// Executes a script in a simulated controller without sockets or threads. Each call of step() is one control
// period, executed as fast as possible. Interpreter, arm and terminals are the same as in Simulator.

#include <QString>
#include <cstdint>
#include <memory>
#include <optional>
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
};

/// The reason why a script could not be compiled or why it ended early.
struct ScriptFault {
    int line = 0;  ///< counted from 1; 0: unknown
    QString text;  ///< message of the controller
};

/// Threads  one at a time. No function blocks.
class ScriptRun {
public:
    explicit ScriptRun(const ScriptRunOptions& options);
    ~ScriptRun();
    ScriptRun(const ScriptRun&) = delete;
    ScriptRun& operator=(const ScriptRun&) = delete;

    /// Compiles the script without running it.
    /// Returns  the error; empty if there is none
    static std::optional<ScriptFault> check(const QString& script, const SoftwareVersion& software);

    /// Compiles and starts the script, which runs from the next step on.
    /// Returns  the error; empty if there is none
    std::optional<ScriptFault> start(const QString& script);
    /// Runs one control period.
    /// Returns  false when no script is running any more
    bool step();

    double stepTime() const;               ///< [s]
    double time() const;                   ///< time since start() [s]
    JointPositions q() const;              ///< target position: target_q [rad]
    Pose tcpPose() const;                  ///< pose at this position: target_TCP_pose [m, rad], base frame
    std::uint64_t digitalOutputs() const;  ///< 0-7 standard, 8-15 configurable, 16-17 tool
    SafetyMode safetyMode() const;
    /// Returns the values that the script has written to the followed register since the last call.
    std::vector<std::int32_t> takeWritten();
    /// The reason why the script failed; empty if it is running or ended normally.
    std::optional<ScriptFault> failure() const;
    /// The cause of a protective stop as described by the controller; empty if there was none.
    QString stopText() const;

    /// True while the script shows a message or asks a question and waits for an answer.
    bool waitsForOperator() const;
    /// Closes the message, or answers a question with "no", zero or an empty text.
    void answerOperator();

    void setDigitalInput(int channel, bool value);  ///< channels as in digitalOutputs()
    void setAnalogInput(int number, double value);  ///< 0 or 1 [A or V]

private:
    class Impl;
    std::unique_ptr<Impl> d_;
};

}  // namespace tiller::simulator
