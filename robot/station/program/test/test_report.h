// SPDX-License-Identifier: MIT
#pragma once

// Reports of program tests for people and for build servers.

#include <QByteArray>
#include <QJsonObject>

#include "robot/station/program/test/test_run.h"

namespace tiller::program {

/// The steps of one program that ran in any of the tests. Comments, disabled steps, and steps that run in
/// parallel do not count, because they do not write the step register.
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

/// The programs in the order in which the files first name them.
std::vector<ProgramCoverage> coverageOf(const std::vector<TestFile>& files,
                                        const std::vector<TestOutcome>& outcomes);
/// {"simulated", "programs": [{"project", "program", "executed", "total", "steps": [...]}]}
QJsonObject coverageJson(const std::vector<ProgramCoverage>& coverage);

/// All results as one JSON object.
QJsonObject reportJson(const std::vector<TestFile>& files, const std::vector<TestOutcome>& outcomes,
                       std::uint64_t seed);
/// JUnit XML as read by Jenkins, GitLab and others: a suite per file, a case per test. The times are those of
/// the simulated runs, so the same seed gives the same text.
QByteArray junitXml(const std::vector<TestFile>& files, const std::vector<TestOutcome>& outcomes,
                    std::uint64_t seed);
/// The results as text: a line per test and per expectation, the coverage and a summary.
QString reportText(const std::vector<TestFile>& files, const std::vector<TestOutcome>& outcomes,
                   std::uint64_t seed);

}  // namespace tiller::program
