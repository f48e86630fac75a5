// SPDX-License-Identifier: GPL-3.0-or-later

#include <QJsonDocument>
#include <QJsonObject>
#include <algorithm>
#include <atomic>
#include <thread>

#include "app/cli_command.h"
#include "app/termination.h"
#include "robot/core/atomic_file.h"
#include "robot/station/program/test/test_file.h"
#include "robot/station/program/test/test_report.h"
#include "robot/station/program/test/test_run.h"

namespace tiller::app {

namespace {

/// Reads all files and prints their problems.
/// Returns  false if there is a problem
bool readFiles(const QStringList& paths, std::vector<program::TestFile>& files) {
    bool isGood = true;
    for (const QString& path : paths) {
        program::ReadTestFile read = program::readTestFile(path);
        for (const project::FileProblem& problem : read.problems) {
            complain(QStringLiteral("%1: %2").arg(path, problem.toString()), kWrongArguments);
            isGood = false;
        }
        files.push_back(std::move(read.file));
    }
    return isGood;
}

bool writeReport(const CommandArguments& arguments, const char* option, const QByteArray& content) {
    if (!arguments.isSet(option)) {
        return true;
    }
    const auto written = writeFileAtomically(arguments.value(option), content);
    return written || complain(written.error().toString(), kFailed) == kSuccess;
}

int test(const CommandArguments& arguments) {
    if (arguments.operands().isEmpty()) {
        return wrongArguments(QStringLiteral("test: at least one test file is required"));
    }
    std::vector<program::TestFile> files;
    if (!readFiles(arguments.operands(), files)) {
        return kWrongArguments;
    }
    holdTerminationSignals();
    std::atomic<bool> isCancelled = false;
    program::TestRunOptions options;
    options.seed = static_cast<std::uint64_t>(arguments.number("seed"));
    options.threads = static_cast<int>(arguments.number("jobs"));
    options.isCancelled = [&isCancelled] {
        if (waitForTermination(std::chrono::milliseconds(0))) {
            isCancelled = true;
        }
        return isCancelled.load();
    };
    const std::vector<program::TestOutcome> outcomes = program::runTests(files, options);
    if (isCancelled) {
        return complain(QStringLiteral("the tests were cancelled"), kFailed);
    }
    if (arguments.isSet("json")) {
        out() << QJsonDocument(program::reportJson(files, outcomes, options.seed)).toJson();
    } else {
        out() << program::reportText(files, outcomes, options.seed);
    }
    out().flush();
    const QByteArray covered =
        QJsonDocument(program::coverageJson(program::coverageOf(files, outcomes))).toJson();
    const bool isWritten =
        writeReport(arguments, "junit", program::junitXml(files, outcomes, options.seed)) &&
        writeReport(arguments, "coverage", covered);
    const bool isPassed =
        std::all_of(outcomes.begin(), outcomes.end(), [](const auto& outcome) { return outcome.passed(); });
    return isWritten && isPassed ? kSuccess : kFailed;
}

}  // namespace

const Command& testCommand() {
    static const Command kCommand{
        .name = "test",
        .operands = "FILE...",
        .summary = "tests programs of a project in the simulated controller",
        .title = "tests programs of a project in the simulated controller",
        .usage = {"FILE... [options]"},
        .operandRows =
            {{"FILE",
              "file with tests, such as pick-and-place.test.json. The file names a project and a program, "
              "scripted inputs and faults, and the expected results. The manual describes the format"}},
        .options =
            {{"junit", "FILE", "writes the results as JUnit XML for a build server"},
             {"coverage", "FILE", "writes a JSON file that lists the program steps that ran"},
             {"json", {}, "prints one JSON object instead of text"},
             {"seed",
              "N",
              "seed of the measurement noise and of random() in the programs (default %1). The same seed "
              "gives exactly the same results",
              "1",
              {0, 1e15, true}},
             {"jobs",
              "N",
              "number of tests that run at the same time (default: number of processors)",
              QString::number(std::max(1U, std::thread::hardware_concurrency())),
              {1, 256, true}}},
        .notes =
            "All tests are simulated. No robot is required, and no robot moves. Exit code: 0 all "
            "expectations are met, 1 at least one expectation is not met or a program has errors, 2 invalid "
            "arguments or test files. If a test file is invalid, no test runs.",
        .run = test};
    return kCommand;
}

}  // namespace tiller::app
