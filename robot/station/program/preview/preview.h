// SPDX-License-Identifier: MIT
#pragma once

// Predicts the behaviour of a program by running its actual script in the simulated controller, in virtual
// time. The result contains the path, the time of each step, and problems by step. Workpieces are not
// simulated, and inputs have the values given in the options.

#include <QJsonArray>
#include <QString>
#include <array>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "robot/collision/collision_check.h"
#include "robot/core/joints.h"
#include "robot/core/spatial.h"
#include "robot/project/project_file.h"
#include "robot/station/program/program_script.h"

namespace tiller::program {

/// Number of cycles after which the preview of an endless program ends. The second cycle begins where the
/// first cycle ended.
inline constexpr int kPreviewCycles = 2;

/// A digital input that switches during the run.
struct InputChange {
    double time = 0;  ///< since the start [s]
    int channel = 0;  ///< 0-7 standard, 8-15 configurable, 16-17 tool
    bool value = true;
};

/// An input or an external stop. Takes effect in the control period after its time.
struct PreviewEvent {
    enum class Kind {
        DigitalInput,    ///< `channel` as in InputChange; on unless `value` is 0
        AnalogInput,     ///< AI0 or AI1; `value` in [A or V]
        HandForce,       ///< hand force `force` at the TCP
        ProtectiveStop,  ///< same reaction as to a collision
        OperatorStop,    ///< the stop button of the teach pendant
        EmergencyStop,   ///< the emergency stop button of the teach pendant
        PowerLoss,       ///< failure of the power supply of the arm
        LinkLoss,        ///< loss of the connection to the PC
    };
    Kind kind = Kind::DigitalInput;
    double time = 0;  ///< since the start or since the beginning of `step` [s]
    int step = 0;     ///< step number; 0: `time` is since the start
    int run = 1;      ///< number of the beginning of `step`, from 1
    int channel = 0;
    double value = 0;
    Eigen::Vector3d force = Eigen::Vector3d::Zero();  ///< [N], base frame
};

/// True for an event that ends the program.
bool isStop(PreviewEvent::Kind kind);

struct PreviewOptions {
    std::optional<JointPositions> start;  ///< [rad]; if empty, see startPosition()
    std::vector<InputChange> inputs;
    /// With a LinkLoss event, the script runs as if started from this PC and ends without a heartbeat.
    std::vector<PreviewEvent> events = {};
    /// Answers to the questions to the operator, in this order. Further questions are answered with "no",
    /// zero or an empty text.
    QJsonArray answers = {};
    std::vector<std::string> variables = {};  ///< names of the variables for Preview::variables
    bool measuresClearance = false;           ///< true: measure Preview::clearance
    std::uint64_t seed = 1;                   ///< seed of the measurement noise and random()
    /// Pairs to reuse in several previews of the same arm in one thread, see CollisionCheck.
    collision::NeverMeeting* known = nullptr;
    int maxCycles = kPreviewCycles;          ///< maximum number of cycles of an endless loop; 0: no limit
    double timeLimit = 3600;                 ///< duration [s] after which the program is stopped
    double operatorTime = 1;                 ///< time until a message is closed or a question is answered [s]
    double sampleInterval = 0.02;            ///< time between two samples of the path [s]
    std::function<bool()> isCancelled = {};  ///< polled; the preview ends when it returns true
};

struct PathSample {
    double time = 0;  ///< since the start [s]
    int step = 0;     ///< step number, see ProgramScript; 0: none
    JointPositions q;
    Pose tcp;  ///< TCP pose in the base frame
};

/// How often a step ran, and for how long.
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
        Collision,       ///< the arm was closer than the safety distance to itself or the cell
        StepFailed,      ///< a step failed and no On error section handled it
        TimeLimit,       ///< the program had not ended after `timeLimit`
        Cancelled,
    };
    Kind kind = Kind::RuntimeError;
    int step = 0;     ///< step number; 0: no step
    double time = 0;  ///< since the start [s]
    QString text;     ///< translated text, or the message from the controller
};

/// An output that changed.
struct OutputChange {
    double time = 0;   ///< time since the start [s]
    int channel = 0;   ///< number as in InputChange; 18 and 19: AO0 and AO1
    double value = 0;  ///< 0 or 1; for an analog output its level [A or V]
    friend bool operator==(const OutputChange&, const OutputChange&) = default;
};
inline constexpr int kFirstAnalogOutput = 18;  ///< channel of AO0 in OutputChange

/// The largest or smallest value of a quantity.
struct Extreme {
    double value = 0;
    double time = 0;  ///< since the start [s]
    int step = 0;     ///< step number; 0: none
};

struct Preview {
    enum class End {
        Completed,
        Failed,   ///< ended by a step or by the script
        Stopped,  ///< ended by a protective stop or an event
        Running,  ///< the program was still running at the end of the preview
    };
    bool completed = false;  ///< the program ended normally, or is endless
    bool isEndless = false;  ///< the preview ended after PreviewOptions::maxCycles cycles of an endless loop
    End end = End::Failed;
    int endStep = 0;      ///< step that failed or was running at the end; 0: none
    double duration = 0;  ///< time until the end of the preview [s]
    std::vector<PathSample> path;
    std::vector<int> order;                   ///< step numbers in the order of their start
    std::vector<double> starts;               ///< start time of each item of `order` [s]
    std::vector<StepTiming> timings;          ///< one per step; step number 1 is at index 0
    std::vector<JointPositions> startJoints;  ///< arm position at the first start of each step [rad]
    std::vector<Finding> findings;            ///< in chronological order
    JointPositions endJoints;
    Pose endPose;                           ///< TCP pose in the base frame
    std::uint64_t outputs = 0;              ///< digital outputs at the end
    std::array<double, 2> analogOutputs{};  ///< levels at the end [A or V]
    std::vector<OutputChange> outputChanges;
    Extreme force;  ///< largest TCP force as received by a client of the robot [N]
    /// Smallest distance of the arm from the floor, planes and boxes of the cell [m], at the samples of the
    /// path. Empty if it was not measured or the cell has no such objects.
    std::optional<Extreme> clearance;
    /// Last values, see simulator::ScriptRun::followedVariable().
    std::map<std::string, QJsonValue> variables;
    std::vector<std::size_t> unusedEvents;  ///< indices of the events that did not take place
    int questions = 0;                      ///< number of questions to the operator
    std::vector<int> unfitAnswers;          ///< indices of answers whose type does not match the question

    bool isGood() const { return completed && findings.empty(); }  ///< The program ended without a finding.
};

/// Text of a finding with its step and time, e.g. "Step 7 (MoveL) at 3.2 s: The arm comes too close to the
/// floor."
QString findingText(const project::Project& project, const ProgramScript& script, const Finding& finding);

/// Positions of the TCP along the path, at least `spacing` [m] apart, in the base frame [m].
std::vector<Eigen::Vector3d> tcpPath(const Preview& preview, double spacing);

/// Start position of a preview: the first waypoint of the program, otherwise the home position of the
/// project, otherwise the start position of the simulated controller.
JointPositions startPosition(const project::Project& project, const ProgramScript& script);

/// Runs the script in the simulated controller.
/// script   must be without errors, see ProgramScript::ok()
/// Threads  any. Blocks: a few seconds per ten minutes of program time
Preview previewProgram(const project::Project& project, const ProgramScript& script,
                       const ScriptOptions& scriptOptions = {}, const PreviewOptions& options = {});

}  // namespace tiller::program
