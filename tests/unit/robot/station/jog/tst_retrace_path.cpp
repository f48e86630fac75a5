// SPDX-License-Identifier: GPL-3.0-or-later
// The recorded path and the motion back along it, with interfaces that only record their calls.
#include <QTest>
#include <algorithm>

#include "robot/station/jog/retrace_path.h"

using namespace tiller;
using control::StopCause;

namespace {

// An arm that follows its target while the motion is held, in steps of 20 ms.
struct Arm {
    JointPositions q;
    control::JogTarget target;
    std::uint64_t running = 0;
    std::uint64_t next = 0;
    double speed = 0.35;
    QList<StopCause> ends;
    MotionPort port;
    RetracePath track{port, [this](const JointPositions&, const JointPositions&) { return speed; }};
    HoldMotion motion = track.motion();

    Arm() {
        port.beginJog = [this](const control::JogTarget& t) -> Result<RobotSession::MotionId> {
            target = t;
            return running = ++next;
        };
        port.holdWith = [this](RobotSession::MotionId id, const control::JogTarget& t) {
            target = t;
            return id == running;
        };
        port.endMotion = [this](RobotSession::MotionId, StopCause cause) {
            running = 0;
            ends << cause;
        };
    }
    void comeTo(double base, double shoulder) {
        // Moves in small steps, as a session reports them.
        const JointPositions to(base, shoulder, 0, 0, 0, 0);
        const int steps = std::max(1, static_cast<int>((to.values - q.values).cwiseAbs().maxCoeff() / 0.005));
        const JointPositions from = q;
        for (int i = 1; i <= steps; ++i) {
            q = JointPositions(Vector6(from.values + (to.values - from.values) * i / steps));
            track.record(q);
        }
    }
    /// Advances by 20 ms. Returns false when the motion has ended.
    bool go(std::uint64_t id) {
        if (!motion.hold(id)) {
            return false;
        }
        q.values += target.qd.values * 0.02;
        track.record(q);
        return true;
    }
};

}  // namespace

class TestRetracePath : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void theMotionBackEndsBeforeAnObstacle() {
        Arm arm;
        // A jog went up to a limit at 0.8 rad, closer to an obstacle than a move may come.
        arm.port.permitsPath = [](std::span<const JointPositions> way) -> Result<void> {
            const bool isFree =
                std::all_of(way.begin(), way.end(), [](const JointPositions& q) { return q[0] < 0.6; });
            return isFree ? Result<void>() : Error{ErrorCode::Rejected, QStringLiteral("too close"), {}};
        };
        arm.comeTo(0.8, 0);
        arm.comeTo(0, 0);
        arm.comeTo(0, 0.5);
        const auto id = arm.motion.begin();
        QVERIFY2(id.ok(), "the newest part of the path is obstructed");
        while (arm.go(*id)) {
            QVERIFY(arm.q[0] < 0.6);
        }
        QVERIFY2(arm.q[0] > 0.58, qPrintable(QString::number(arm.q[0])));
        // There is no path left to retrace.
        QVERIFY(!arm.motion.begin().ok());
        arm.comeTo(0.8, 0);
        QCOMPARE(arm.motion.begin().error().context, QStringLiteral("too close"));
    }

    void retracingFollowsTheSamePath_data() {
        QTest::addColumn<double>("speed");
        QTest::newRow("slow") << 0.02;
        QTest::newRow("fast") << 0.52;
    }
    void retracingFollowsTheSamePath() {
        QFETCH(double, speed);
        Arm arm;
        arm.speed = speed;
        arm.track.record(arm.q);
        arm.comeTo(0.5, 0);
        arm.comeTo(0.5, 0.5);
        const auto id = arm.motion.begin();
        QVERIFY(id.ok());
        QVERIFY2(arm.target.qd[1] < 0, "the motion does not start along the second segment");
        double corner = 1;
        int turns = 0;
        for (; turns < 5000 && arm.go(*id); ++turns) {
            QVERIFY(arm.target.qd.values.cwiseAbs().maxCoeff() <= speed + 1e-9);
            // The arm stays on the path, which consists of two straight segments.
            const double off = std::min(std::abs(arm.q[0] - 0.5), std::abs(arm.q[1]));
            QVERIFY2(off < 0.045, qPrintable(QString::number(off)));
            corner = std::min(corner, std::hypot(arm.q[0] - 0.5, arm.q[1]));
        }
        QVERIFY2(corner < 0.045, "the motion does not pass the corner");
        QVERIFY2(std::abs(arm.q[0]) < 0.003 && std::abs(arm.q[1]) < 0.003,
                 qPrintable(QString::number(arm.q[0])));
        QCOMPARE(arm.ends, QList<StopCause>{StopCause::Completed});
        QVERIFY(arm.track.isEmpty());
        QVERIFY2(!arm.motion.begin().ok(), "the motion can start again at the start of the path");
    }

    void aStopIsFinal() {
        Arm arm;
        arm.track.record(arm.q);
        arm.comeTo(0.5, 0.5);
        const auto id = arm.motion.begin();
        QVERIFY(id.ok());
        QVERIFY(arm.go(*id));
        arm.running = 0;  // STOP was pressed
        QVERIFY(!arm.go(*id));
        QVERIFY(!arm.go(*id));
        QCOMPARE(arm.next, 1U);
    }

    void releaseKeepsTheRestOfTheTrail() {
        Arm arm;
        arm.track.record(arm.q);
        arm.comeTo(0.5, 0.5);
        auto id = arm.motion.begin();
        for (int i = 0; i < 30; ++i) {
            QVERIFY(arm.go(*id));
        }
        arm.motion.end(*id, StopCause::Released);
        QCOMPARE(arm.ends, QList<StopCause>{StopCause::Released});
        QVERIFY(arm.q[0] > 0.1);
        id = arm.motion.begin();
        QVERIFY(id.ok());
        while (arm.go(*id)) {
        }
        QVERIFY(std::abs(arm.q[0]) < 0.003);
    }

    void aJumpDiscardsTheTrail() {
        Arm arm;
        arm.track.record(arm.q);
        arm.comeTo(0.5, 0.5);
        QVERIFY(!arm.track.isEmpty());
        arm.track.record({1.5, 0.5, 0, 0, 0, 0});
        QVERIFY(arm.track.isEmpty());
        QVERIFY(!arm.motion.begin().ok());
    }

    void standstillAddsNothingToTheTrail() {
        Arm arm;
        QVERIFY(arm.track.isEmpty());
        arm.track.record({0.5, 0.5, 0, 0, 0, 0});
        arm.track.record({0.501, 0.5, 0, 0, 0, 0});
        QVERIFY(arm.track.isEmpty());
        arm.track.record({0.6, 0.5, 0, 0, 0, 0});
        QVERIFY(!arm.track.isEmpty());
        arm.track.clear();
        QVERIFY(arm.track.isEmpty());
    }

    void theTrailIsBounded() {
        Arm arm;
        for (int i = 0; i < 20'000; ++i) {
            arm.track.record({0.05 * (i % 2), 0.02 * (i % 7), 0, 0, 0, 0});
        }
        QVERIFY(arm.track.size() <= RetracePath::kCapacity);
    }
};

QTEST_GUILESS_MAIN(TestRetracePath)
#include "tst_retrace_path.moc"
