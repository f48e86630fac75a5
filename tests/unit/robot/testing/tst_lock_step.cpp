// SPDX-License-Identifier: MIT
// Lock-step with a simulated robot: the same sequence of events on every machine, even with link faults, and
// no real-time waits for packets that do not arrive.
#include <QElapsedTimer>
#include <QTest>

#include "robot/receive/robot_state.h"
#include "robot/testing/robot_fixture.h"

using namespace tiller;
using namespace tiller::virtual_time;

class TestLockStep : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void everyPacketIsReceivedAndAnswered() {
        RobotFixture robot;
        const auto receiver = robot.bench.makeReceiver();
        QVERIFY(robot.bench.whileTimePasses([&] { return receiver->waitForData(RobotFixture::limit()); }));
        receive::Subscription packets = receiver->subscribe();
        const std::uint64_t inputs = robot.bench.robot().inputPackages();
        robot.bench.step(1.0);
        QCOMPARE(packets.pending(), std::uint64_t(500));
        QCOMPARE(robot.bench.robot().inputPackages() - inputs, std::uint64_t(500));
        QCOMPARE(packets.lost(), std::uint64_t(0));
    }

    void linkFaultsWorkInLockStep_data() {
        QTest::addColumn<QString>("fault");
        QTest::addColumn<bool>("keepsControl");
        QTest::newRow("lost") << "link lost" << false;
        QTest::newRow("delay") << "delay 20 5" << true;
        QTest::newRow("drop") << "drop 30" << true;
        QTest::newRow("split") << "split 10" << true;
        QTest::newRow("mute") << "silence on" << false;
        QTest::newRow("half open") << "half-open" << false;
    }
    void linkFaultsWorkInLockStep() {
        QFETCH(QString, fault);
        QFETCH(bool, keepsControl);
        RobotFixture robot;
        const auto receiver = robot.bench.makeReceiver();
        QVERIFY(robot.bench.whileTimePasses([&] { return receiver->waitForData(RobotFixture::limit()); }));
        QVERIFY(robot.bench.robot().inject(fault).ok());
        robot.bench.step(0.3);
        QCOMPARE(robot.controller->status().inControl, keepsControl);
        if (fault.startsWith("delay")) {
            // Samples with a delay of 20 to 25 ms were still received.
            const receive::Sample sample = receiver->latest();
            const double late =
                robot.bench.robot().truth().timestamp - receive::RobotState(sample).timestamp();
            QVERIFY2(late > 0.019 && late < 0.029, qPrintable(QString::number(late)));
        }
    }

    void aFaultHasTheSameEffectEachTime() {
        const auto stoppedAt = [] {
            RobotFixture robot;
            JointPositions target = robot.q();
            target[0] += 1;
            (void)robot.motions().moveJ(target).value();
            robot.bench.step(0.4);
            (void)robot.bench.robot().inject("link lost");
            robot.bench.step(1.0);
            return robot.q()[0];
        };
        QCOMPARE(stoppedAt(), stoppedAt());
    }

    void timeDoesNotAdvanceWithoutSteps() {
        RobotFixture robot;
        const double before = robot.bench.robot().truth().timestamp;
        QTest::qWait(20);
        QCOMPARE(robot.bench.robot().truth().timestamp, before);
        QVERIFY(
            robot.bench.stepUntil([&] { return robot.bench.robot().truth().timestamp > before + 0.1; }, 1.0));
        QVERIFY(!robot.bench.stepUntil([] { return false; }, 0.01));
    }
};

QTEST_GUILESS_MAIN(TestLockStep)
#include "tst_lock_step.moc"
