// SPDX-License-Identifier: GPL-3.0-or-later

#include <QCommandLineParser>
#include <QJsonDocument>
#include <QJsonObject>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <thread>

#include "app/cli_command.h"
#include "app/cli_options.h"
#include "app/cli_program.h"
#include "app/termination.h"
#include "robot/core/atomic_file.h"
#include "robot/station/program/test/test_file.h"
#include "robot/station/program/test/test_report.h"
#include "robot/station/program/test/test_run.h"

namespace tiller::app {

namespace {

const QString kTestHelp = QStringLiteral(
    "tiller-cli test: tests programs of a project in the simulated controller\n"
    "\n"
    "Usage: tiller-cli test FILE... [options]\n"
    "\n"
    "  FILE                 file with tests, such as pick-and-place.test.json. It names a project and a\n"
    "                       program, scripted inputs and faults, and what is expected of the run. The "
    "format\n"
    "                       is described in the manual\n"
    "  --junit FILE         writes the results as JUnit XML for a build server\n"
    "  --coverage FILE      writes as JSON which steps of the programs ran\n"
    "  --json               prints one JSON object instead of text\n"
    "  --seed N             seed of the measurement noise and of random() in the programs (default 1). The "
    "same\n"
    "                       seed gives exactly the same results\n"
    "  --jobs N             number of tests that run at the same time (default: number of processors)\n"
    "  --help               shows this text\n"
    "\n"
    "Everything is simulated; no robot is needed, and none moves.\n"
    "Exit code: 0 all expectations are met, 1 at least one is not or a program has errors, 2 invalid "
    "arguments\n"
    "or test files. With exit code 2 caused by a test file, no test runs.\n");

/// Reads all files and prints the problems of each.
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

bool writeReport(const QCommandLineParser& parser, const QCommandLineOption& option,
                 const QByteArray& content) {
    if (!parser.isSet(option)) {
        return true;
    }
    const auto written = writeFileAtomically(parser.value(option), content);
    return written || complain(written.error().toString(), kFailed) == kSuccess;
}

}  // namespace

int test(const QStringList& arguments) {
    QCommandLineParser parser;
    const QCommandLineOption help(QStringList{"h", "help"});
    const QCommandLineOption junit("junit", {}, "FILE");
    const QCommandLineOption coverage("coverage", {}, "FILE");
    const QCommandLineOption json("json");
    const QCommandLineOption seed("seed", {}, "N", "1");
    const QCommandLineOption jobs("jobs", {}, "N",
                                  QString::number(std::max(1U, std::thread::hardware_concurrency())));
    parser.addOptions({help, junit, coverage, json, seed, jobs});
    if (!parser.parse(arguments)) {
        return wrongArguments(parser.errorText());
    }
    if (parser.isSet(help)) {
        out() << kTestHelp;
        out().flush();
        return kSuccess;
    }
    if (parser.positionalArguments().isEmpty()) {
        return wrongArguments(QStringLiteral("test: at least one test file is required"));
    }
    constexpr double kMaxSeed = 1e15;
    constexpr double kMaxJobs = 256;
    const auto seedNumber = numberIn(parser, seed, 0, kMaxSeed);
    const auto jobCount = numberIn(parser, jobs, 1, kMaxJobs);
    if (!seedNumber || !jobCount) {
        return kWrongArguments;
    }
    if (std::floor(*seedNumber) != *seedNumber || std::floor(*jobCount) != *jobCount) {
        return wrongArguments(QStringLiteral("--seed and --jobs must be whole numbers"));
    }
    std::vector<program::TestFile> files;
    if (!readFiles(parser.positionalArguments(), files)) {
        return kWrongArguments;
    }
    holdTerminationSignals();
    std::atomic<bool> isCancelled = false;
    program::TestRunOptions options;
    options.seed = static_cast<std::uint64_t>(*seedNumber);
    options.threads = static_cast<int>(*jobCount);
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
    if (parser.isSet(json)) {
        out() << QJsonDocument(program::reportJson(files, outcomes, options.seed)).toJson();
    } else {
        out() << program::reportText(files, outcomes, options.seed);
    }
    out().flush();
    const QByteArray covered =
        QJsonDocument(program::coverageJson(program::coverageOf(files, outcomes))).toJson();
    const bool isWritten = writeReport(parser, junit, program::junitXml(files, outcomes, options.seed)) &&
                           writeReport(parser, coverage, covered);
    const bool isPassed =
        std::all_of(outcomes.begin(), outcomes.end(), [](const auto& outcome) { return outcome.passed(); });
    return isWritten && isPassed ? kSuccess : kFailed;
}

}  // namespace tiller::app
