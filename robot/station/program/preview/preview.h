// SPDX-License-Identifier: MIT
#pragma once

// Predicts the behaviour of a program by running its actual script in the simulated controller, in virtual
// time. The result contains the path, the time of each step, and problems by step. Everything is simulated:
// there are no parts, and inputs have the values given in the options.

#include <QString>
#include <functional>
#include <vector>

#include "robot/core/joints.h"
#include "robot/core/spatial.h"
#include "robot/project/project_file.h"
#include "robot/station/program/program_script.h"

namespace tiller::program {

/// The preview of an endless program ends after this number of cycles. The second one begins where the first ended.
inline constexpr int kPreviewCycles = 2;

/// A digital input that switches during the run.
struct InputChange {
    double time = 0;  ///< since the start [s]
    int channel = 0;  ///< 0-7 standard, 8-15 configurable, 16-17 tool
    bool value = true;
};

struct PreviewOptions {
    std::optional<JointPositions> start;  ///< [rad]; if empty, see startPosition()
    std::vector<InputChange> inputs;
    double timeLimit = 3600;                 ///< duration [s] after which the program is stopped
    double operatorTime = 1;                 ///< time until a message is closed or a question is answered [s]
    double sampleInterval = 0.02;            ///< time between two samples of the path [s]
    std::function<bool()> isCancelled = {};  ///< polled; if it returns true, the preview ends
};

struct PathSample {
    double time = 0;  ///< since the start [s]
    int step = 0;     ///< step number, see ProgramScript; 0: none
    JointPositions q;
    Pose tcp;  ///< in the base frame
};

/// Number and duration of the runs of a step.
struct StepTiming {
    int count = 0;
    double first = 0;  ///< first start time [s]
    double total = 0;  ///< sum over all runs [s]
};

struct Finding {
    enum class Kind {
        ScriptError,     ///< the controller cannot compile the script
        RuntimeError,    ///< runtime error that ended the program
        ProtectiveStop,  ///< the arm stopped: reach, joint limits, speed, force
        Collision,       ///< the arm violated the safety distance from itself or the cell
        StepFailed,      ///< a step failed and no On error section handled it
        TimeLimit,       ///< the program had not ended after `timeLimit`
        Cancelled,
    };
    Kind kind = Kind::RuntimeError;
    int step = 0;     ///< step number; 0: no step
    double time = 0;  ///< since the start [s]
    QString text;     ///< translated text, or the message from the controller
};

struct Preview {
    bool completed = false;  ///< the program ended normally, or is endless
    bool isEndless = false;  ///< the preview ended after kPreviewCycles cycles of an endless loop
    double duration = 0;     ///< until the end of the preview [s]
    std::vector<PathSample> path;
    std::vector<int> order;           ///< step numbers in the order of their start
    std::vector<StepTiming> timings;  ///< one per step; step number 1 is at index 0
    std::vector<Finding> findings;    ///< in chronological order
    JointPositions endJoints;
    Pose endPose;               ///< TCP pose in the base frame
    std::uint64_t outputs = 0;  ///< digital outputs at the end

    bool isGood() const { return completed && findings.empty(); }  ///< The program ended without a finding.
};

/// Text of a finding with its step and time, e.g. "Step 7 (MoveL) at 3.2 s: The arm comes too close to the
/// floor."
QString findingText(const project::Project& project, const ProgramScript& script, const Finding& finding);

/// Positions of the TCP along the path, at least `spacing` [m] apart, in the base frame [m].
std::vector<Eigen::Vector3d> tcpPath(const Preview& preview, double spacing);

/// Start position of a preview: the joints of the first waypoint of the program, otherwise the project's home
/// position, otherwise the start position of the simulated controller.
JointPositions startPosition(const project::Project& project, const ProgramScript& script);

/// script  without errors, see ProgramScript::ok()
/// Threads  any. Blocks: a few seconds per ten minutes of program time
Preview previewProgram(const project::Project& project, const ProgramScript& script,
                       const ScriptOptions& scriptOptions = {}, const PreviewOptions& options = {});

}  // namespace tiller::program
