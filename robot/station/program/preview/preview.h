// SPDX-License-Identifier: MIT
#pragma once

// What a program does, found by running its very script in the simulated controller, in virtual time: the path, when each
// step runs, and what goes wrong at which step. Everything in it is simulated: parts are not there, inputs have the values
// that the options give them.

#include <QString>
#include <functional>
#include <vector>

#include "robot/core/joints.h"
#include "robot/core/spatial.h"
#include "robot/project/project_file.h"
#include "robot/station/program/program_script.h"

namespace tiller::program {

/// A digital input that switches during the run.
struct InputChange {
    double time = 0;  ///< since the start [s]
    int channel = 0;  ///< 0-7 standard, 8-15 configurable, 16-17 tool
    bool value = true;
};

struct PreviewOptions {
    std::optional<JointPositions> start;  ///< [rad]; nothing: see startPosition()
    std::vector<InputChange> inputs;
    double timeLimit = 3600;                 ///< of the program [s]; one without end is followed for so long
    double operatorTime = 1;                 ///< until a message is closed, or a question answered [s]
    double sampleInterval = 0.02;            ///< between two samples of the path [s]
    std::function<bool()> isCancelled = {};  ///< asked now and then; true ends the preview
};

struct PathSample {
    double time = 0;  ///< since the start [s]
    int step = 0;     ///< its number, see ProgramScript; 0: none
    JointPositions q;
    Pose tcp;  ///< base frame
};

/// How often and how long a step ran.
struct StepTiming {
    int count = 0;
    double first = 0;  ///< when it began for the first time [s]
    double total = 0;  ///< of all runs [s]
};

struct Finding {
    enum class Kind {
        ScriptError,     ///< the controller does not compile the script
        RuntimeError,    ///< it ended the program
        ProtectiveStop,  ///< the arm stopped: reach, joint limits, speed, force
        Collision,       ///< nearer to itself or the cell than the safety distance
        StepFailed,      ///< a step failed, and no On error section took over
        TimeLimit,       ///< the program had not ended after `timeLimit`
        Cancelled,
    };
    Kind kind = Kind::RuntimeError;
    int step = 0;     ///< its number; 0: none
    double time = 0;  ///< since the start [s]
    QString text;     ///< translated, or the controller's words
};

struct Preview {
    bool completed = false;  ///< the program came to its end
    double duration = 0;     ///< [s]
    std::vector<PathSample> path;
    std::vector<int> order;           ///< numbers of the steps as they began
    std::vector<StepTiming> timings;  ///< by number, from 1 at index 0
    std::vector<Finding> findings;    ///< in the order of time
    JointPositions endJoints;
    Pose endPose;               ///< of the TCP, base frame
    std::uint64_t outputs = 0;  ///< digital outputs at the end

    bool isGood() const { return completed && findings.empty(); }  ///< It ran to its end without a finding.
};

/// Where a preview begins: at the joints of the first waypoint that the program moves to, else at the project's home
/// position, else at the start position of the simulated controller.
JointPositions startPosition(const project::Project& project, const ProgramScript& script);

/// script  without errors, see ProgramScript::ok()
/// Threads  any. Blocks: for some seconds per ten minutes of the program
Preview previewProgram(const project::Project& project, const ProgramScript& script,
                       const ScriptOptions& scriptOptions = {}, const PreviewOptions& options = {});

}  // namespace tiller::program
