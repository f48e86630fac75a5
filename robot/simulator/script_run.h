// SPDX-License-Identifier: MIT
#pragma once

// A script executed in a simulated controller without sockets or threads: each call of step() is one control period, as
// fast as the machine computes it. The same interpreter, arm and terminals as in Simulator.

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
    std::uint64_t seed = 1;     ///< for measurement noise and the script's random()
};

/// The reason why a script could not be compiled, or why it ended early.
struct ScriptFault {
    int line = 0;  ///< from 1; 0: unknown
    QString text;  ///< the message of the controller
};

/// Threads  one at a time. Nothing blocks.
class ScriptRun {
public:
    explicit ScriptRun(const ScriptRunOptions& options);
    ~ScriptRun();
    ScriptRun(const ScriptRun&) = delete;
    ScriptRun& operator=(const ScriptRun&) = delete;

    /// Compiles without running.  Returns  the error; nothing if there is none
    static std::optional<ScriptFault> check(const QString& script, const SoftwareVersion& software);

    /// The script starts with the next step.  Returns  the error; nothing if there is none
    std::optional<ScriptFault> start(const QString& script);
    /// Runs one control period.  Returns  false when no script is running any more
    bool step();

    double stepTime() const;               ///< [s]
    double time() const;                   ///< since start() [s]
    JointPositions q() const;              ///< target position: target_q [rad]
    Pose tcpPose() const;                  ///< the same as target_TCP_pose [m, rad], base frame
    std::uint64_t digitalOutputs() const;  ///< 0-7 standard, 8-15 configurable, 16-17 tool
    SafetyMode safetyMode() const;
    /// The values that the script has written to the followed register since the last call.
    std::vector<std::int32_t> takeWritten();
    /// Why the script failed; nothing if it is running or ended by itself.
    std::optional<ScriptFault> failure() const;
    /// The cause of a protective stop in the words of the controller; empty if there was none.
    QString stopText() const;

    /// The script shows a message or asks a question, and waits for an answer.
    bool waitsForOperator() const;
    /// Closes the message; answers a question with "no", zero or an empty text.
    void answerOperator();

    void setDigitalInput(int channel, bool value);  ///< as digitalOutputs()
    void setAnalogInput(int number, double value);  ///< 0, 1 [A or V]

private:
    class Impl;
    std::unique_ptr<Impl> d_;
};

}  // namespace tiller::simulator
