// SPDX-License-Identifier: GPL-3.0-or-later
// The trail and the way back along it, against doors that only write down what they are asked.
#include <QTest>

#include "widgets/jog/back_track.h"

using namespace tiller;
using control::StopCause;

namespace {

struct Arm {
    QList<JointPositions> targets;
    std::uint64_t running = 0;
    std::uint64_t next = 0;
    bool arrived = false;
    QList<StopCause> ends;
    JogPort port;
    BackTrack track{port, [](const JointPositions& q) {
                        MoveRequest request;
                        request.q = q;
                        return request;
                    }};
    HoldMotion motion = track.motion();

    Arm() {
        port.beginMove = [this](const MoveRequest& request) -> Result<RobotSession::MotionId> {
            targets << request.q;
            arrived = false;
            return running = ++next;
        };
        port.hold = [this](RobotSession::MotionId id) { return id == running; };
        port.endMotion = [this](RobotSession::MotionId, StopCause cause) {
            running = 0;
            ends << cause;
        };
        port.completed = [this](RobotSession::MotionId) { return arrived; };
    }
    void comeTo(double base, double shoulder) { track.record({base, shoulder, 0, 0, 0, 0}); }
    void arrive() {
        arrived = true;
        running = 0;
    }
    void loseIt() {
        arrived = false;
        running = 0;
    }
};

}  // namespace

class TestBackTrack : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void aStraightWayIsOneLegAndACornerIsKept() {
        Arm arm;
        for (int i = 0; i <= 100; ++i) {
            arm.comeTo(0.01 * i, 0);
        }
        for (int i = 0; i <= 100; ++i) {
            arm.comeTo(1.0, 0.01 * i);
        }
        QVERIFY2(arm.track.size() <= 4, qPrintable(QString::number(arm.track.size())));
        const auto id = arm.motion.begin();
        QVERIFY(id.ok());
        // The first leg leads to the corner, the second to the beginning.
        QVERIFY(std::abs(arm.targets.last()[0] - 1.0) < 0.02 && std::abs(arm.targets.last()[1]) < 0.02);
        QVERIFY(arm.motion.hold(*id));
        arm.arrive();
        QVERIFY(arm.motion.hold(*id));
        QVERIFY(std::abs(arm.targets.last()[0]) < 0.02 && std::abs(arm.targets.last()[1]) < 0.02);
        arm.arrive();
        QVERIFY2(!arm.motion.hold(*id), "the beginning is the end");
        QVERIFY(arm.track.isEmpty());
        QVERIFY(!arm.motion.begin().ok());
    }

    void aStopIsFinal() {
        Arm arm;
        arm.comeTo(0, 0);
        arm.comeTo(1, 0);
        arm.comeTo(1, 1);
        const auto id = arm.motion.begin();
        QVERIFY(id.ok());
        // Somebody pressed STOP: the leg ended, but not at its target. Nothing new is begun.
        arm.loseIt();
        QVERIFY(!arm.motion.hold(*id));
        QCOMPARE(arm.targets.size(), 1);
        QVERIFY(!arm.motion.hold(*id));
        QCOMPARE(arm.targets.size(), 1);
    }

    void lettingGoKeepsTheRestOfTheTrail() {
        Arm arm;
        arm.comeTo(0, 0);
        arm.comeTo(1, 0);
        arm.comeTo(1, 1);
        auto id = arm.motion.begin();
        arm.track.record({1, 0.5, 0, 0, 0, 0});  // half way
        arm.motion.end(*id, StopCause::Released);
        QCOMPARE(arm.ends, QList<StopCause>{StopCause::Released});
        arm.track.record({1, 0.5, 0, 0, 0, 0});
        id = arm.motion.begin();
        QVERIFY(id.ok());
        QVERIFY(std::abs(arm.targets.last()[1]) < 0.02);
    }

    void standingStillLeavesNothingToUndo() {
        Arm arm;
        QVERIFY(arm.track.isEmpty());
        arm.comeTo(0.5, 0.5);
        arm.comeTo(0.501, 0.5);
        QVERIFY(arm.track.isEmpty());
        arm.comeTo(0.6, 0.5);
        QVERIFY(!arm.track.isEmpty());
        arm.track.clear();
        QVERIFY(arm.track.isEmpty());
    }

    void theTrailIsBounded() {
        Arm arm;
        for (int i = 0; i < 5000; ++i) {
            arm.comeTo(i % 2 == 0 ? 0 : 0.5, 0.02 * (i % 7));
        }
        QVERIFY(arm.track.size() <= BackTrack::kCapacity);
    }
};

QTEST_GUILESS_MAIN(TestBackTrack)
#include "tst_back_track.moc"
