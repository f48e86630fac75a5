// SPDX-License-Identifier: MIT
#pragma once

// Reports of program tests for people and for build servers.

#include <QByteArray>
#include <QJsonObject>

#include "robot/station/program/test/test_run.h"

namespace tiller::program {

/// The steps of one program that ran in at least one test. Comments, disabled steps, and steps that run in
/// parallel are excluded, because they do not write the step register.
struct ProgramCoverage {
    QString projectPath;
    QUuid program;
    QString name;
    struct Step {
        int number = 0;
        QUuid id;
        QString name;   ///< name of its kind
        int count = 0;  ///< number of runs in all tests
    };
    std::vector<Step> steps;
    int executed() const;  ///< Number of steps that ran.
};

/// The programs in the order of their first use in the files.
std::vector<ProgramCoverage> coverageOf(const std::vector<TestFile>& files,
                                        const std::vector<TestOutcome>& outcomes);
/// {"simulated", "programs": [{"project", "program", "executed", "total", "steps": [...]}]}
QJsonObject coverageJson(const std::vector<ProgramCoverage>& coverage);

/// All results as one JSON object.
QJsonObject reportJson(const std::vector<TestFile>& files, const std::vector<TestOutcome>& outcomes,
                       std::uint64_t seed);
/// JUnit XML for Jenkins, GitLab and others: one suite per file, one case per test. The times are simulated,
/// so the same seed results in the same text.
QByteArray junitXml(const std::vector<TestFile>& files, const std::vector<TestOutcome>& outcomes,
                    std::uint64_t seed);
/// The results as text: one line per test and per expectation, the coverage, and a summary.
QString reportText(const std::vector<TestFile>& files, const std::vector<TestOutcome>& outcomes,
                   std::uint64_t seed);

}  // namespace tiller::program
