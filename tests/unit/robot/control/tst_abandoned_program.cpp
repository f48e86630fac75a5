// SPDX-License-Identifier: MIT
#include <QTest>
#include <cmath>
#include <limits>

#include "robot/control/abandoned_program.h"

using namespace tiller;
using namespace tiller::control;

namespace {

constexpr double kAbsent = std::numeric_limits<double>::quiet_NaN();

/// A robot whose state register counts the time without a client.
struct Robot {
    AbandonedProgram program;
    double period = 0.002;  // [s]
    double pace = 1;        // rate of the value, relative to the robot's time
    double time = 100;
    double alone = 0;
    RuntimeState runtime = RuntimeState::Playing;
    std::size_t range = 1;
    bool isUpdated = true;

    void go(double seconds) {
        for (const double end = time + seconds; time < end;) {
            time += period;
            alone += isUpdated ? pace * period : 0;
            std::array<double, 2> states{kAbsent, kAbsent};
            states[range] = -std::floor(alone * 1000);
            program.add(time, runtime, states);
        }
    }
};

}  // namespace

class TestAbandonedProgram : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void aProgramWithoutAClientIsDetected_data() {
        QTest::addColumn<double>("period");
        QTest::addColumn<int>("range");
        QTest::addColumn<double>("pace");
        QTest::newRow("e-Series, upper registers") << 0.002 << 1 << 1.0;
        QTest::newRow("e-Series, lower registers") << 0.002 << 0 << 1.0;
        QTest::newRow("CB3") << 0.008 << 0 << 1.0;
        QTest::newRow("counts 5 % too fast") << 0.002 << 1 << 1.05;
    }
    void aProgramWithoutAClientIsDetected() {
        QFETCH(double, period);
        QFETCH(int, range);
        QFETCH(double, pace);
        Robot robot;
        robot.period = period;
        robot.range = static_cast<std::size_t>(range);
        robot.pace = pace;
        robot.alone = 0.11;
        robot.go(0.3);
        QVERIFY2(!robot.program.isRunning(),
                 "a program whose client may still be in control counts as abandoned");
        robot.go(0.2);
        QVERIFY(robot.program.isRunning());
        for (int i = 0; i < 40; ++i) {
            robot.go(0.1);
            QVERIFY(robot.program.isRunning());
        }
    }

    // The register keeps its value after the program has ended.
    void anUnchangedNumberIsNotEvidence() {
        Robot robot;
        robot.alone = 0.7;
        robot.isUpdated = false;
        for (int i = 0; i < 200; ++i) {
            robot.go(0.01);
            QVERIFY(!robot.program.isRunning());
        }
        robot.isUpdated = true;
        robot.go(2);
        QVERIFY(robot.program.isRunning());
        // Another program replaces the abandoned one between two packages.
        robot.isUpdated = false;
        robot.go(0.03);
        for (int i = 0; i < 200; ++i) {
            robot.go(0.01);
            QVERIFY(!robot.program.isRunning());
        }
    }

    void aNumberOfAnotherProgramIsNotEvidence() {
        for (const double pace : {-1.0, 0.0, 0.3, 2.0, 10.0}) {
            Robot robot;
            robot.alone = 3;
            robot.pace = pace;
            for (int i = 0; i < 20; ++i) {
                robot.go(0.01);
                QVERIFY2(!robot.program.isRunning(), qPrintable(QString::number(pace)));
            }
        }
    }

    // At this pace, the delay between two packages is permitted, but the accumulated delay since the first
    // package is not.
    void aLaggingNumberIsAcceptedOnlyBriefly() {
        Robot robot;
        robot.alone = 1;
        robot.pace = 0.6;
        int running = 0;
        constexpr int kPackages = 500;
        for (int i = 0; i < kPackages; ++i) {
            robot.go(robot.period);
            running += robot.program.isRunning() ? 1 : 0;
        }
        QVERIFY2(running < kPackages / 2, qPrintable(QString::number(running)));
    }

    void aReturningClientIsDetectedImmediately() {
        Robot robot;
        robot.alone = 0.6;
        robot.go(1);
        QVERIFY(robot.program.isRunning());
        robot.program.add(robot.time + robot.period, RuntimeState::Playing, {kAbsent, 0});
        QVERIFY(!robot.program.isRunning());
    }

    void aPausedProgramIsNotAbandoned() {
        for (const RuntimeState state :
             {RuntimeState::Paused, RuntimeState::Pausing, RuntimeState::Resuming, RuntimeState::Stopped}) {
            Robot robot;
            robot.alone = 0.6;
            robot.go(1);
            robot.runtime = state;
            robot.go(0.01);
            QVERIFY(!robot.program.isRunning());
        }
    }

    void lostPackagesAreToleratedAndARestartIsDetected() {
        Robot robot;
        robot.alone = 0.6;
        robot.go(1);
        robot.time += 0.4;
        robot.alone += 0.4;
        robot.go(0.01);
        QVERIFY(robot.program.isRunning());
        robot.time = 2;
        robot.go(0.01);
        QVERIFY(!robot.program.isRunning());
    }

    void missingRegistersAreNotEvidence() {
        AbandonedProgram program;
        for (int i = 0; i < 1000; ++i) {
            program.add(i * 0.002, RuntimeState::Playing, {kAbsent, kAbsent});
        }
        QVERIFY(!program.isRunning());
    }
};

QTEST_GUILESS_MAIN(TestAbandonedProgram)
#include "tst_abandoned_program.moc"
