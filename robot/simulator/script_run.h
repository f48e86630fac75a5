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
    std::optional<Pose> tcp;    ///< flange to TCP at the start [m, rad]; nothing: the flange
    int followedRegister = 47;  ///< output integer register whose values takeWritten() returns
    std::uint64_t seed = 1;     ///< of measurement noise and of the script's random()
};

/// Why a script could not be compiled, or ended before its end.
struct ScriptFault {
    int line = 0;  ///< from 1; 0: not known
    QString text;  ///< as the controller words it
};

/// Threads  one at a time. Nothing blocks.
class ScriptRun {
public:
    explicit ScriptRun(const ScriptRunOptions& options);
    ~ScriptRun();
    ScriptRun(const ScriptRun&) = delete;
    ScriptRun& operator=(const ScriptRun&) = delete;

    /// Compiles without running.  Returns  nothing when the script is right
    static std::optional<ScriptFault> check(const QString& script, const SoftwareVersion& software);

    /// The script runs from the next step on.  Returns  why it cannot; nothing when it does
    std::optional<ScriptFault> start(const QString& script);
    /// One control period.  Returns  false when no script runs any more
    bool step();

    double stepTime() const;               ///< [s]
    double time() const;                   ///< since start() [s]
    JointPositions q() const;              ///< where the arm is to be: target_q [rad]
    Pose tcpPose() const;                  ///< the same as target_TCP_pose [m, rad], base frame
    std::uint64_t digitalOutputs() const;  ///< 0-7 standard, 8-15 configurable, 16-17 tool
    SafetyMode safetyMode() const;
    /// The values that the script has written to the followed register since the last call.
    std::vector<std::int32_t> takeWritten();
    /// Why the script failed; nothing: it runs, or came to its end.
    std::optional<ScriptFault> failure() const;
    /// The cause of a protective stop, as the controller words it; empty: there was none.
    QString stopText() const;

    /// The script shows a message or asks a question, and does not go on without an answer.
    bool waitsForOperator() const;
    /// Closes the message; answers a question with no, zero or an empty text.
    void answerOperator();

    void setDigitalInput(int channel, bool value);  ///< as digitalOutputs()
    void setAnalogInput(int number, double value);  ///< 0, 1 [A or V]

private:
    class Impl;
    std::unique_ptr<Impl> d_;
};

}  // namespace tiller::simulator
