// SPDX-License-Identifier: MIT
//
// The steps of a run, from samples of the step register.

#include <QTest>

#include "robot/station/program/execution/step_log.h"

using namespace tiller;
using namespace tiller::program;

namespace {

constexpr double kPeriod = 0.002;

/// Adds samples of one value for a time [s].
class Samples {
public:
    explicit Samples(StepLog& log) : log_(log) {}
    void add(RuntimeState runtime, int value, double seconds, int gate = 0) {
        for (int i = 0; i < qRound(seconds / kPeriod); ++i, time_ += kPeriod) {
            log_.add(time_, runtime, value, gate);
        }
    }

private:
    StepLog& log_;
    double time_ = 100;
};

}  // namespace

class TestStepLog : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void waitingIsNotPartOfAStep() {
        StepLog log(3);
        Samples samples(log);
        samples.add(RuntimeState::Stopped, 0, 0.1, -5);  // left by an earlier program
        QVERIFY(!log.isWaiting());
        samples.add(RuntimeState::Playing, 1, 0.2, 1);
        QVERIFY(!log.isWaiting());
        QCOMPARE(log.begun(), 1);
        samples.add(RuntimeState::Playing, 2, 0.5, -2);
        QVERIFY(log.isWaiting());
        QCOMPARE(log.step(), 2);
        QCOMPARE(log.begun(), 1);
        samples.add(RuntimeState::Playing, 2, 0.3, 2);
        QVERIFY(!log.isWaiting());
        QCOMPARE(log.begun(), 2);
        QCOMPARE(log.timings()[1].count, 1);
        QVERIFY(qAbs(log.timings()[1].total - 0.3) < 4 * kPeriod);
        samples.add(RuntimeState::Stopped, 0, 0.1, -4);
        QVERIFY(!log.isWaiting() && log.hasEnded());
    }

    void timesAndRunsAreCounted() {
        StepLog log(3);
        Samples samples(log);
        samples.add(RuntimeState::Playing, 0, 0.1);  // the control program
        samples.add(RuntimeState::Stopped, 0, 0.1);
        QVERIFY(!log.hasBegun());
        for (int i = 0; i < 2; ++i) {
            samples.add(RuntimeState::Playing, 1, 0.2);
            samples.add(RuntimeState::Playing, 2, 0.4);
        }
        QCOMPARE(log.step(), 2);
        QVERIFY(log.hasBegun() && !log.hasEnded());
        samples.add(RuntimeState::Playing, 0, kPeriod);
        samples.add(RuntimeState::Stopped, 0, 0.1);
        samples.add(RuntimeState::Playing, 0, 1);  // the control program again
        QVERIFY(log.hasEnded() && !log.isCutShort());
        QCOMPARE(log.step(), 0);
        QCOMPARE(log.lastStep(), 2);
        QCOMPARE(log.failedStep(), 0);
        QVERIFY(qAbs(log.seconds() - 1.202) < 2 * kPeriod);
        QCOMPARE(log.timings()[0].count, 2);
        QCOMPARE(log.timings()[1].count, 2);
        QCOMPARE(log.timings()[2].count, 0);
        QVERIFY(qAbs(log.timings()[0].total - 0.4) < 4 * kPeriod);
        QVERIFY(qAbs(log.timings()[1].total - 0.8) < 4 * kPeriod);
        QVERIFY(qAbs(log.timings()[1].first - 0.2) < 2 * kPeriod);
    }

    void aValueFromAnEarlierRunIsNotAStep() {
        StepLog log(3);
        Samples samples(log);
        samples.add(RuntimeState::Playing, 3, 0.1);
        samples.add(RuntimeState::Stopped, 3, 0.1);
        samples.add(RuntimeState::Playing, 3, kPeriod);
        samples.add(RuntimeState::Playing, 1, 0.1);
        QCOMPARE(log.step(), 1);
        QCOMPARE(log.timings()[2].count, 0);
    }

    void aFailedStepIsReported() {
        StepLog log(3);
        Samples samples(log);
        samples.add(RuntimeState::Stopped, 0, 0.1);
        samples.add(RuntimeState::Playing, 2, 0.1);
        samples.add(RuntimeState::Playing, -2, kPeriod);
        samples.add(RuntimeState::Stopped, -2, 0.1);
        QCOMPARE(log.failedStep(), 2);
        QCOMPARE(log.lastStep(), 2);
    }

    void aPauseCountsAsTimeOfItsStep() {
        StepLog log(1);
        Samples samples(log);
        samples.add(RuntimeState::Stopped, 0, 0.1);
        samples.add(RuntimeState::Playing, 1, 0.1);
        samples.add(RuntimeState::Paused, 1, 0.5);
        samples.add(RuntimeState::Playing, 1, 0.1);
        QCOMPARE(log.timings()[0].count, 1);
        QVERIFY(qAbs(log.timings()[0].total - 0.7) < 6 * kPeriod);
    }

    void aProgramThatIsStoppedInAStepIsCutShort() {
        StepLog log(2);
        Samples samples(log);
        samples.add(RuntimeState::Stopped, 0, 0.1);
        samples.add(RuntimeState::Playing, 1, 0.1);
        QVERIFY(!log.isCutShort());
        samples.add(RuntimeState::Stopped, 1, 0.1);
        QVERIFY(log.hasEnded() && log.isCutShort());
        QCOMPARE(log.lastStep(), 1);
    }

    void aPauseOnTheRobotIsNoticed() {
        StepLog log(1);
        Samples samples(log);
        samples.add(RuntimeState::Stopped, 0, 0.1);
        samples.add(RuntimeState::Playing, 1, 0.1);
        QVERIFY(!log.isPausedOnRobot());
        samples.add(RuntimeState::Paused, 1, 0.1);
        QVERIFY(log.isPausedOnRobot());
        samples.add(RuntimeState::Playing, 1, 0.1);
        QVERIFY(!log.isPausedOnRobot());
    }

    void invalidValuesAreIgnored() {
        StepLog log(1);
        Samples samples(log);
        samples.add(RuntimeState::Stopped, 0, 0.1);
        samples.add(RuntimeState::Playing, 2, 0.1);
        samples.add(RuntimeState::Playing, -7, 0.1);
        QCOMPARE(log.step(), 0);
        QCOMPARE(log.failedStep(), 0);
    }
};

QTEST_GUILESS_MAIN(TestStepLog)
#include "tst_step_log.moc"
