// SPDX-License-Identifier: MIT
#pragma once

// Runs tests of programs in the simulated controller, in virtual time, and compares the runs with the
// expectations. The same seed results in exactly the same outcome for any number of threads.

#include <cstdint>
#include <functional>
#include <vector>

#include "robot/station/program/test/program_test.h"

namespace tiller::program {

/// The result of one expectation.
struct Verdict {
    QString name;      ///< e.g. "duration"
    QString expected;  ///< e.g. "18.000 s to 25.000 s"
    QString measured;  ///< e.g. "27.104 s"
    bool passed = false;
};

struct TestOutcome {
    std::size_t file = 0;  ///< index of the test file
    std::size_t test = 0;  ///< index into TestFile::tests
    Preview preview;       ///< result without its path
    std::vector<Verdict> verdicts;
    bool hasRun = false;  ///< false if the program has errors
    bool passed() const;  ///< True if all verdicts passed.
};

struct TestRunOptions {
    std::uint64_t seed = 1;  ///< seed of the measurement noise and random()
    int threads = 1;
    std::function<bool()> isCancelled = {};  ///< polled in the threads
};

std::vector<Verdict> judge(const TestFile& file, const ProgramTest& test, const Preview& preview);

/// Runs all tests.
/// Returns  the outcomes in the order of the files and tests; incomplete if the run is cancelled
/// Threads  any. Blocks: until all tests have run, in the given number of threads
std::vector<TestOutcome> runTests(const std::vector<TestFile>& files, const TestRunOptions& options = {});

/// A verdict as one line, e.g. "duration: 27.104 s (expected 18.000 s to 25.000 s)".
QString verdictText(const Verdict& verdict);

}  // namespace tiller::program
