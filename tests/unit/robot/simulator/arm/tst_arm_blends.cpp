// SPDX-License-Identifier: MIT
// Blended moves: when the first move returns, how close the path passes to the corner, and which quantities
// stay continuous.
#include <QTest>
#include <cmath>

#include "tests/unit/robot/simulator/arm/arm_fixture.h"

using namespace tiller;
using namespace tiller::simulator::arm;

namespace {
const Pose kA(-0.140, -0.400, 0.300, 0, 3.14, 0);
const Pose kB(-0.140, -0.600, 0.300, 0, 3.14, 0);
const Pose kC(0.100, -0.600, 0.300, 0, 3.14, 0);
const Pose kD(0.100, -0.400, 0.300, 0, 3.14, 0);
constexpr double kTick = 0.002;

enum class Move { J, L, P };

MotionStart go(WatchedArm& arm, Move kind, const MoveTarget& target, const MoveParameters& p) {
    switch (kind) {
        case Move::J:
            return arm->motion().moveJ(target, p);
        case Move::L:
            return arm->motion().moveL(target, p);
        case Move::P:
            break;
    }
    return arm->motion().moveP(target, p);
}

MoveParameters with(Move kind, double r) {
    return kind == Move::J ? MoveParameters{.a = 3, .v = 1.5, .r = r}
                           : MoveParameters{.a = 1.2, .v = 0.25, .r = r};
}
}  // namespace

class TestArmBlends : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void cornerIsPassedWithinTheRadius_data();
    void cornerIsPassedWithinTheRadius();
    void firstMoveReturnsAtTheStartOfTheBlend();
    void commonOrientationIsKeptThroughTheCorner();
    void straightContinuationKeepsItsSpeed();
    void processMoveKeepsItsSpeedThroughCorners();
    void withoutANextMoveTheArmStopsAtTheTarget();
    void aLateNextMoveStillJoinsSmoothly();
    void overlappingBlendSkipsTheWaypoint();
    void recordedPathRunsWithoutStopping();
    void aPauseInTheCornerResumes();
};

void TestArmBlends::cornerIsPassedWithinTheRadius_data() {
    QTest::addColumn<int>("first");
    QTest::addColumn<int>("second");
    QTest::addColumn<double>("r");
    const char* names[] = {"J", "L", "P"};
    for (int i = 0; i < 3; ++i) {
        for (int k = 0; k < 3; ++k) {
            for (const double r : {0.01, 0.05, 0.1}) {
                QTest::addRow("%s to %s, %g m", names[i], names[k], r) << i << k << r;
            }
        }
    }
}

void TestArmBlends::cornerIsPassedWithinTheRadius() {
    QFETCH(int, first);
    QFETCH(int, second);
    QFETCH(double, r);
    WatchedArm arm;
    arm.finish(go(arm, Move::J, kA, with(Move::J, 0)));
    const auto kind = static_cast<Move>(first);
    const MotionStart one = go(arm, kind, kB, with(kind, r));
    arm.finish(one);
    const auto next = static_cast<Move>(second);
    const MotionStart two = go(arm, next, kC, with(next, 0));
    double nearest = 1;
    double slowest = 1;
    while (arm->motion().progress(two.id) == MotionProgress::Running) {
        arm.step();
        nearest = std::min(nearest, (arm.tcp() - kB.position).norm());
        if ((arm.tcp() - kB.position).norm() < r) {
            slowest = std::min(slowest, arm.state().targetTcpSpeed.linear.norm());
        }
    }
    QVERIFY(!arm->protectiveStop());
    QVERIFY2(nearest < r, qPrintable(QString::number(nearest)));
    QVERIFY2(nearest > 0.05 * r, "the corner was not blended");
    QVERIFY2(slowest > 0.02, qPrintable(QString::number(slowest)));
    QVERIFY((arm.tcp() - kC.position).norm() < 1e-7);
    QVERIFY2(arm.withinBounds(), arm.worst().c_str());
    QVERIFY2(arm.worstAcceleration < 20, arm.worst().c_str());
}

void TestArmBlends::firstMoveReturnsAtTheStartOfTheBlend() {
    WatchedArm arm;
    arm.finish(go(arm, Move::J, kA, with(Move::J, 0)));
    const MotionStart one = go(arm, Move::L, kB, with(Move::L, 0.05));
    arm.finish(one);
    const double left = (arm.tcp() - kB.position).norm();
    // The move returns one or two periods before the blend zone, so that the next move is available when the
    // zone begins.
    QVERIFY2(left >= 0.05 && left < 0.05 + 3 * 0.25 * kTick, qPrintable(QString::number(left)));
}

void TestArmBlends::commonOrientationIsKeptThroughTheCorner() {
    WatchedArm arm;
    arm.finish(go(arm, Move::J, kA, with(Move::J, 0)));
    const Eigen::Matrix3d R = rotationMatrix(kA.rotation);
    arm.finish(go(arm, Move::L, kB, with(Move::L, 0.1)));
    const MotionStart two = go(arm, Move::L, kC, with(Move::L, 0));
    double worst = 0;
    double height = 0;
    while (arm->motion().progress(two.id) == MotionProgress::Running) {
        arm.step();
        worst =
            std::max(worst, (rotationMatrix(arm.state().targetTcpPose.rotation) - R).cwiseAbs().maxCoeff());
        height = std::max(height, std::abs(arm.tcp().z() - 0.3));
    }
    QVERIFY2(worst < 1e-6, qPrintable(QString::number(worst)));
    QVERIFY2(height < 1e-7, qPrintable(QString::number(height)));
}

void TestArmBlends::straightContinuationKeepsItsSpeed() {
    WatchedArm arm;
    arm.finish(go(arm, Move::J, kA, with(Move::J, 0)));
    Pose middle = kA;
    middle.position = 0.5 * (kA.position + kB.position);
    arm.finish(go(arm, Move::L, middle, {.a = 1.2, .v = 0.1, .r = 0.03}));
    const MotionStart two = go(arm, Move::L, kB, {.a = 1.2, .v = 0.1});
    while ((arm.tcp() - middle.position).norm() < 0.035) {
        arm.step();
        QVERIFY2(std::abs(arm.state().targetTcpSpeed.linear.norm() - 0.1) < 1e-3,
                 qPrintable(QString::number(arm.state().targetTcpSpeed.linear.norm())));
    }
    arm.finish(two);
    QVERIFY(!arm->protectiveStop());
}

void TestArmBlends::processMoveKeepsItsSpeedThroughCorners() {
    WatchedArm arm;
    arm.finish(go(arm, Move::J, kA, with(Move::J, 0)));
    const MoveParameters p{.a = 1.2, .v = 0.1, .r = 0.03};
    double lowest = 1;
    double highest = 0;
    const auto run = [&](const MotionStart& move) {
        while (arm->motion().progress(move.id) == MotionProgress::Running) {
            arm.step();
            const double v = arm.state().targetTcpSpeed.linear.norm();
            lowest = std::min(lowest, v);
            highest = std::max(highest, v);
        }
    };
    const MotionStart one = go(arm, Move::P, kB, p);
    arm.run(0.3);
    run(one);
    // The circle is inside the corner, at the distance r / cos(45 deg) - r tan(45 deg).
    const MotionStart two = go(arm, Move::P, kC, p);
    double nearest = 1;
    while (arm->motion().progress(two.id) == MotionProgress::Running) {
        arm.step();
        nearest = std::min(nearest, (arm.tcp() - kB.position).norm());
        lowest = std::min(lowest, arm.state().targetTcpSpeed.linear.norm());
        highest = std::max(highest, arm.state().targetTcpSpeed.linear.norm());
    }
    run(go(arm, Move::P, kD, p));
    QVERIFY(!arm->protectiveStop());
    QVERIFY2(std::abs(nearest - 0.03 * (std::sqrt(2.0) - 1)) < 1e-4, qPrintable(QString::number(nearest)));
    QVERIFY2(lowest > 0.0999 && highest < 0.1001, qPrintable(QString("%1 .. %2").arg(lowest).arg(highest)));
    QVERIFY2(arm.withinBounds(), arm.worst().c_str());
}

void TestArmBlends::withoutANextMoveTheArmStopsAtTheTarget() {
    for (const Move kind : {Move::J, Move::L, Move::P}) {
        WatchedArm arm;
        arm.finish(go(arm, Move::J, kA, with(Move::J, 0)));
        arm.finish(go(arm, kind, kB, with(kind, 0.08)));
        QVERIFY(arm->motion().isActive());
        arm.rest();
        QVERIFY((arm.tcp() - kB.position).norm() < 1e-7);
        QVERIFY(!arm->motion().isActive());
        QVERIFY2(arm.withinBounds(), arm.worst().c_str());
    }
}

void TestArmBlends::aLateNextMoveStillJoinsSmoothly() {
    for (const Move kind : {Move::J, Move::L, Move::P}) {
        WatchedArm arm;
        arm.finish(go(arm, Move::J, kA, with(Move::J, 0)));
        arm.finish(go(arm, kind, kB, with(kind, 0.08)));
        arm.run(0.15);
        const MotionStart two = go(arm, kind, kC, with(kind, 0));
        QVERIFY(two.ok());
        arm.finish(two);
        QVERIFY((arm.tcp() - kC.position).norm() < 1e-7);
        QVERIFY2(arm.worstAcceleration < 20, arm.worst().c_str());
        QVERIFY2(arm.withinBounds(), arm.worst().c_str());
    }
}

void TestArmBlends::overlappingBlendSkipsTheWaypoint() {
    WatchedArm arm;
    arm.finish(go(arm, Move::J, kA, with(Move::J, 0)));
    arm.finish(go(arm, Move::L, kB, with(Move::L, 0.05)));
    Pose close = kB;
    close.position.x() += 0.06;
    close.position.z() += 0.02;
    const MotionStart skipped = go(arm, Move::L, close, with(Move::L, 0.05));
    QCOMPARE(arm->motion().progress(skipped.id), MotionProgress::Returned);
    const auto warning = arm->takeWarning();
    QVERIFY(warning.has_value());
    QCOMPARE(*warning, MotionWarning::OverlappingBlends);
    QVERIFY(!arm->takeWarning().has_value());
    const MotionStart last = go(arm, Move::L, kC, with(Move::L, 0));
    QVERIFY(last.ok());
    double height = 0;
    while (arm->motion().progress(last.id) == MotionProgress::Running) {
        arm.step();
        height = std::max(height, arm.tcp().z() - 0.3);
    }
    QVERIFY(height < 1e-6);
    QVERIFY((arm.tcp() - kC.position).norm() < 1e-7);
}

void TestArmBlends::recordedPathRunsWithoutStopping() {
    WatchedArm arm;
    arm.finish(go(arm, Move::J, Pose(-0.140, -0.400, 0.100, 0, 3.14, 0), with(Move::J, 0)));
    const MoveParameters blend{.a = 0.8, .v = 0.5, .r = 0.099};
    arm.finish(go(arm, Move::L, Pose(-0.140, -0.400, 0.300, 0, 3.14, 0), blend));
    arm.finish(go(arm, Move::L, Pose(-0.140, -0.600, 0.300, 0, 3.14, 0), blend));
    arm.finish(go(arm, Move::L, Pose(0.140, -0.600, 0.100, 0, 3.14, 0), blend));
    arm.finish(go(arm, Move::L, Pose(0.280, -0.400, 0.100, 0, 3.14, 0), {.a = 0.8, .v = 0.5}));
    QVERIFY(!arm->protectiveStop());
    QVERIFY(!arm->takeWarning());
    QVERIFY((arm.tcp() - Eigen::Vector3d(0.280, -0.400, 0.100)).norm() < 1e-7);
    QVERIFY2(arm.withinBounds(), arm.worst().c_str());
}

void TestArmBlends::aPauseInTheCornerResumes() {
    WatchedArm free;
    WatchedArm held;
    Eigen::Vector3d corner = Eigen::Vector3d::Zero();
    for (WatchedArm* arm : {&free, &held}) {
        arm->finish(go(*arm, Move::J, kA, with(Move::J, 0)));
        arm->finish(go(*arm, Move::L, kB, with(Move::L, 0.08)));
        const MotionStart two = go(*arm, Move::J, kC, with(Move::J, 0));
        double nearest = 1;
        int n = 0;
        while (arm->arm.motion().progress(two.id) == MotionProgress::Running) {
            if (arm == &held && n == 100) {
                arm->arm.hold();
                arm->run(1.0);
                QVERIFY(arm->state().isStandstill());
                arm->arm.resume();
            }
            arm->step();
            ++n;
            const Eigen::Vector3d p = arm->tcp();
            if ((p - kB.position).norm() < nearest) {
                nearest = (p - kB.position).norm();
                if (arm == &free) {
                    corner = p;
                }
            }
        }
        if (arm == &held) {
            QVERIFY2(std::abs(nearest - (corner - kB.position).norm()) < 1e-4,
                     "the path after the pause is different");
        }
        QVERIFY2(arm->withinBounds(), arm->worst().c_str());
    }
}

QTEST_GUILESS_MAIN(TestArmBlends)
#include "tst_arm_blends.moc"
