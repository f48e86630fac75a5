// SPDX-License-Identifier: MIT
#pragma once

// Reads files with tests of programs, such as "pick-and-place.test.json". Units are the same as in project
// files: metres, radians, seconds, newtons.
//
//   { "format": "tiller-test", "version": 1, "project": "cell.tiller", "program": name, "tests": [ a test ] }
//
// "project" is relative to the folder of the test file. "program" may be omitted if the project has one
// program.
// A test:
//
//   { "name", "program"?, "start"?: { "waypoint": name } or { "joints": [6] }, "timeLimit"?: 600,
//     "operatorTime"?: 1, "answers"?: [true | number | text],
//     "inputs"?: [ { "input": "DI0", "value": true, when }, { "input": "AI0", "value": 2.5, when },
//                  { "hand": [fx, fy, fz], when } ],
//     "faults"?: [ { "fault": "protectiveStop" | "operatorStop" | "emergencyStop" | "powerLoss" | "linkLoss", when } ],
//     "expect"?: { "end"?: "completed" | "failed" | "stopped" | "running", "step"?: a step,
//                  "collisions"?: "none" | "allowed", "protectiveStop"?: "none" | "allowed",
//                  "pose"?: { "waypoint": name or "pose": [6], "position"?: 0.001, "rotation"?: 0.01 },
//                  "clearance"?: minimum, "force"?: maximum, "duration"?: range,
//                  "cycleTime"?: { "step": a step, and a range },
//                  "outputs"?: [ { "output": "DO2", "value": true, "tolerance"?, and a range } ],
//                  "finalOutputs"?: { "DO2": true }, "variables"?: { name: value },
//                  "runs"?: { a step: number } } }
//
// `when` is "at": seconds since the start, or "step": a step, with "run"?: 1 for its first beginning and
// "after"?: seconds since this beginning. Without `when`, the event is at the start. A range is
// { "min"?, "max"? }. A step is its number or its ID. Unknown fields are errors, because a misspelt
// expectation would never fail.

#include <QVector>

#include "robot/project/project_file.h"
#include "robot/station/program/test/program_test.h"

namespace tiller::program {

inline constexpr int kTestFileVersion = 1;
inline constexpr qint64 kMaxTestFileBytes = 16LL * 1024 * 1024;

struct ReadTestFile {
    TestFile file;
    QVector<project::FileProblem> problems;  ///< empty for a valid file
};

/// Reads the test file and its project.
/// Threads  any. Blocks: for the file system
ReadTestFile readTestFile(const QString& path);

/// Name of an output in test files, e.g. "DO2" or "AO1".
/// channel  number as in OutputChange
QString outputName(int channel);

}  // namespace tiller::program
