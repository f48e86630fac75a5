// SPDX-License-Identifier: MIT
#pragma once

// Tests of programs: the events during a simulated run, and the expectations of the run. See test_file.h for
// the file format. Texts in this folder are not translated, because build servers compare them.

#include <QJsonValue>
#include <QString>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "robot/project/project_file.h"
#include "robot/station/program/preview/preview.h"
#include "robot/station/program/program_script.h"

namespace tiller::program {

struct ExpectedRange {
    double minimum = -std::numeric_limits<double>::infinity();
    double maximum = std::numeric_limits<double>::infinity();
    bool contains(double value) const { return value >= minimum && value <= maximum; }
};

struct ExpectedPose {
    Pose pose;               ///< TCP pose in the base frame
    double position = 1e-3;  ///< tolerance [m]
    double rotation = 1e-2;  ///< tolerance [rad]
};

struct ExpectedOutput {
    QString name;     ///< e.g. "DO2"
    int channel = 0;  ///< number as in OutputChange
    double value = 0;
    double tolerance = 0;  ///< tolerance of analog outputs [A or V]
    ExpectedRange time;    ///< time of the change since the start [s]
};

struct ExpectedVariable {
    QString name;
    QJsonValue value;
    double tolerance = 1e-6;  ///< tolerance of numbers
};

struct ExpectedRuns {
    int step = 0;
    int count = 0;
};

struct ExpectedCycle {
    int step = 0;
    ExpectedRange time;  ///< time between two beginnings of the step [s]
};

/// Expectations of a test. Empty members are not checked. The end, collisions and protective stops are always
/// checked.
struct TestExpectations {
    Preview::End end = Preview::End::Completed;
    int endStep = 0;  ///< 0: any
    bool allowsCollisions = false;
    bool allowsProtectiveStop = false;
    std::optional<ExpectedPose> pose;       ///< pose at the end
    std::optional<double> clearance;        ///< minimum clearance [m]
    std::optional<double> force;            ///< maximum force [N]
    std::optional<ExpectedRange> duration;  ///< [s]
    std::optional<ExpectedCycle> cycle;
    std::vector<ExpectedOutput> outputs;       ///< all changes of these outputs, in this order
    std::vector<ExpectedOutput> finalOutputs;  ///< levels at the end
    std::vector<ExpectedVariable> variables;   ///< values at the end
    std::vector<ExpectedRuns> runs;
};

/// A program and its script for the simulated run.
struct TestedProgram {
    QUuid id;
    QString name;
    ProgramScript script;  ///< contains the problems if the program cannot run
};

struct ProgramTest {
    QString name;
    std::size_t program = 0;  ///< index into TestFile::programs
    PreviewOptions options;
    std::vector<QString> eventPlaces;  ///< e.g. "faults[0]", for each event of the options
    TestExpectations expected;
};

struct TestFile {
    QString path;
    QString projectPath;
    std::shared_ptr<const project::Project> project;
    std::vector<TestedProgram> programs;
    std::vector<ProgramTest> tests;
};

}  // namespace tiller::program
