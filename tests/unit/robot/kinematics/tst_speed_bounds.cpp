// SPDX-License-Identifier: MIT
#include "robot/kinematics/speed_bounds.h"

#include <QTest>
#include <cmath>

#include "robot/kinematics/arm_kinematics.h"

using namespace tiller;
using namespace tiller::kinematics;

namespace {

const JointPositions kStart(-1.6007, -1.7271, -2.2030, -0.8080, 1.5951, -0.0310);

const DhParameters& dh() {
    return robotModel(RobotModelId::UR5e).dh;
}

}  // namespace

class TestSpeedBounds : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void shortAndLongMovesHaveTheExpectedDuration() {
        QCOMPARE(moveDuration(0, 1, 1), 0.0);
        QCOMPARE(moveDuration(0.25, 1, 1), 1.0);  // never reaches the requested speed
        QCOMPARE(moveDuration(1, 1, 1), 2.0);
        QCOMPARE(moveDuration(3, 1, 1), 4.0);
        QCOMPARE(moveDuration(1, 0, 1), 0.0);
    }

    void aPureRotationHasALength() {
        const Pose here(0.3, 0.2, 0.4, 0, 3.0, 0);
        Pose there = here;
        there.position.z() += 0.1;
        QCOMPARE(lineLength(here, there), 0.1);
        const Pose turned(0.3, 0.2, 0.4, 0, 2.0, 0);
        QVERIFY(std::abs(lineLength(here, turned) - kTurnRadius) < 1e-12);
    }

    void reportsTheLimitingSpeed() {
        JointPositions wrist = kStart;
        wrist[5] += 1;
        const Pose farTool(0.2, 0, 0.1, 0, 0, 0);
        QCOMPARE(jointSpeedBound(dh(), kStart, wrist, farTool, 0.25).by, SpeedLimit::Tcp);
        // The forearm points back, so the elbow is further out than the TCP.
        const JointPositions folded(0, -0.8, 2.7, 0, 0, 0);
        JointPositions raised = folded;
        raised[1] -= 0.5;
        QCOMPARE(jointSpeedBound(dh(), folded, raised, {}, 0.25).by, SpeedLimit::Elbow);
        QCOMPARE(jointSpeedBound(dh(), kStart, kStart, {}, 0.25).by, SpeedLimit::None);
        QVERIFY(std::isinf(jointSpeedBound(dh(), kStart, kStart, {}, 0.25).speed));
    }

    // Computes the TCP and elbow speeds along the whole path from the differences between successive
    // positions.
    void jointMovesStayBelowTheCap_data() {
        QTest::addColumn<JointPositions>("to");
        for (int joint = 0; joint < kJointCount; ++joint) {
            JointPositions to = kStart;
            to[joint] += joint % 2 == 0 ? 1.3 : -0.9;
            QTest::addRow("joint %d", joint + 1) << to;
        }
        QTest::newRow("all joints") << JointPositions(-0.9, -1.1, -1.6, -1.4, 0.8, 1.0);
    }
    void jointMovesStayBelowTheCap() {
        QFETCH(JointPositions, to);
        constexpr double kCap = 0.25;
        const Pose tool(0.2, 0.05, 0.1, 0, 0, 0);
        const double speed = jointSpeedBound(dh(), kStart, to, tool, kCap).speed;
        const double duration = (to.values - kStart.values).cwiseAbs().maxCoeff() / speed;
        constexpr int kSteps = 2000;
        const auto at = [&](int i) {
            return JointPositions(Vector6(kStart.values + (to.values - kStart.values) * i / kSteps));
        };
        double fastest = 0;
        for (int i = 0; i < kSteps; ++i) {
            const double dt = duration / kSteps;
            const double tcp =
                (forwardTcp(dh(), at(i + 1), tool).position - forwardTcp(dh(), at(i), tool).position).norm();
            const double elbow =
                (linkFrames(dh(), at(i + 1))[2].translation() - linkFrames(dh(), at(i))[2].translation())
                    .norm();
            fastest = std::max({fastest, tcp / dt, elbow / dt});
        }
        QVERIFY2(fastest < 1.001 * kCap && fastest > 0.999 * kCap, qPrintable(QString::number(fastest)));
    }

    // A rotation about the tip of a long tool swings the arm while the TCP stays in place.
    void aPureRotationIsLimitedByTheElbow() {
        const Pose longTool(0, 0, 0.6, 0, 0, 0);
        const Pose here = forwardTcp(dh(), kStart, longTool);
        Pose there = here;
        there.rotation = rotationVector(rotationMatrix(here.rotation) * rotationMatrix({0.4, 0, 0}));
        constexpr double kCap = 0.05;
        const SpeedBound bound = lineSpeedBound(dh(), kStart, there, longTool, kCap, 0.8);
        QCOMPARE(bound.by, SpeedLimit::Elbow);
        // At this speed, the elbow stays below the limit along the whole path but comes close to it.
        const double turnSpeed = bound.speed / kTurnRadius;
        double fastest = 0;
        JointPositions q = kStart;
        constexpr int kSteps = 200;
        for (int i = 1; i <= kSteps; ++i) {
            Pose pose = here;
            pose.rotation =
                rotationVector(rotationMatrix(here.rotation) * rotationMatrix({0.4 * i / kSteps, 0, 0}));
            const auto next = inverseNearest(dh(), pose, longTool, q);
            QVERIFY(next.has_value());
            const double way =
                (linkFrames(dh(), *next)[2].translation() - linkFrames(dh(), q)[2].translation()).norm();
            fastest = std::max(fastest, way / (0.4 / kSteps / turnSpeed));
            q = *next;
        }
        QVERIFY2(fastest < 1.02 * kCap && fastest > 0.9 * kCap, qPrintable(QString::number(fastest)));
    }

    void aLineIsLimitedByItsRotation() {
        const Pose here = forwardTcp(dh(), kStart);
        Pose there = here;
        there.position.z() += 0.02;
        const SpeedBound straight = lineSpeedBound(dh(), kStart, there, {}, 0.25, 0.8);
        QCOMPARE(straight.by, SpeedLimit::Tcp);
        QCOMPARE(straight.speed, 0.25);
        there.rotation = rotationVector(rotationMatrix(here.rotation) * rotationMatrix({0, 0, 0.5}));
        const SpeedBound turning = lineSpeedBound(dh(), kStart, there, {}, 0.25, 0.8);
        QCOMPARE(turning.by, SpeedLimit::Rotation);
        QVERIFY(std::abs(turning.speed - 0.8 * 0.02 / 0.5) < 1e-9);
    }
};

QTEST_GUILESS_MAIN(TestSpeedBounds)
#include "tst_speed_bounds.moc"
