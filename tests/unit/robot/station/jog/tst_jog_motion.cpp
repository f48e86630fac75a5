// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <numbers>

#include "robot/kinematics/arm_kinematics.h"
#include "robot/station/jog/jog_motion.h"
#include "robot/station/jog/limiter_advice.h"

using namespace tiller;
using control::JogFrame;
using control::JogTarget;

namespace {
constexpr double kDeg = std::numbers::pi / 180.0;
bool close(double a, double b) {
    return std::abs(a - b) < 1e-9;
}
}  // namespace

class TestJogMotion : public QObject {
    Q_OBJECT

    const control::MotionLimits limits_;

private Q_SLOTS:
    void startSpeedIsFiftyMillimetresPerSecond() {
        const JogTarget target = cartesianJog({}, {0, 1}, 1, limits_);
        QCOMPARE(target.kind, JogTarget::Kind::Cartesian);
        QCOMPARE(target.frame, JogFrame::Base);
        QVERIFY(target.twist.linear.isApprox(Eigen::Vector3d(0.050, 0, 0)));
        QVERIFY(target.twist.angular.isZero());
    }
    void startSpeedOfRotationIsFifteenDegreesPerSecond() {
        const JogTarget target = cartesianJog({}, {5, -1}, 1, limits_);
        QVERIFY(target.twist.linear.isZero());
        QVERIFY(target.twist.angular.isApprox(Eigen::Vector3d(0, 0, -15 * kDeg)));
        QVERIFY(close(jointJog({}, 3, -1, 1, limits_).qd[3], -10 * kDeg));
    }
    void everyClassStaysWithinTheCaps() {
        for (int speed = 0; speed < kSpeedClassCount; ++speed) {
            for (const double factor : {0.1, 1.0, 3.0}) {
                JogSelection selection;
                selection.speedClass = speed;
                for (int axis = 0; axis < 6; ++axis) {
                    const JogTarget target = cartesianJog(selection, {axis, 1}, factor, limits_);
                    QVERIFY(target.twist.linear.norm() <= limits_.tcpSpeed + 1e-12);
                    QVERIFY(target.twist.angular.norm() <= limits_.tcpRotationSpeed + 1e-12);
                }
                QVERIFY(jointJog(selection, 0, 1, factor, limits_).qd[0] <= limits_.jointSpeed + 1e-12);
            }
        }
    }
    void controlKeySlowsTenfoldAndShiftTriples() {
        QCOMPARE(modifierFactor(Qt::NoModifier), 1.0);
        QCOMPARE(modifierFactor(Qt::ControlModifier), 0.1);
        QCOMPARE(modifierFactor(Qt::ShiftModifier), 3.0);
        QVERIFY(close(cartesianJog({}, {2, 1}, 0.1, limits_).twist.linear.z(), 0.005));
        QVERIFY(close(cartesianJog({}, {2, 1}, 3, limits_).twist.linear.z(), 0.150));
    }
    void viewFrameJogsUseItsRotation() {
        JogSelection selection;
        selection.frame = FrameChoice::View;
        selection.R_base_view = rotationMatrix({0, 0, 90 * kDeg});
        const JogTarget target = cartesianJog(selection, {0, 1}, 1, limits_);
        QCOMPARE(target.frame, JogFrame::Custom);
        QVERIFY(rotationMatrix(target.T_base_frame.rotation).isApprox(selection.R_base_view, 1e-9));
        QVERIFY(target.twist.linear.isApprox(Eigen::Vector3d(0.05, 0, 0)));  // in the axes of the view
    }
    void taughtFrameIsSent() {
        JogSelection selection;
        selection.frame = FrameChoice::Taught;
        selection.taught = TaughtFrame{QStringLiteral("Tray A"), Pose(1, 2, 3, 0, 0, 1)};
        const JogTarget target = cartesianJog(selection, {1, 1}, 1, limits_);
        QCOMPARE(target.frame, JogFrame::Custom);
        QCOMPARE(target.T_base_frame, selection.taught->T_base_frame);
    }
    void stepMovesTheTcpByItsLengthInTheChosenFrame() {
        const Pose from(0.1, 0.2, 0.3, 0, 0, 90 * kDeg);
        JogSelection selection;
        selection.motion = MotionChoice::CoarseStep;
        MoveRequest step = cartesianStep(selection, {0, -1}, 1, from, limits_);
        QCOMPARE(step.kind, MoveRequest::Kind::MoveL);
        QVERIFY(step.pose.position.isApprox(Eigen::Vector3d(0.09, 0.2, 0.3)));
        QVERIFY(step.pose.rotation.isApprox(from.rotation));
        selection.frame = FrameChoice::Tool;  // x of the tool points along y of the base
        step = cartesianStep(selection, {0, 1}, 1, from, limits_);
        QVERIFY(step.pose.position.isApprox(Eigen::Vector3d(0.1, 0.21, 0.3)));
    }
    void stepsHaveTheConfiguredSizes() {
        QVERIFY(close(stepSize(MotionChoice::FineStep).length, 0.0001));
        QVERIFY(close(stepSize(MotionChoice::Step).length, 0.001));
        QVERIFY(close(stepSize(MotionChoice::CoarseStep).length, 0.010));
        QVERIFY(close(stepSize(MotionChoice::Step).angle, 1 * kDeg));
        QVERIFY(stepSize(MotionChoice::CoarseStep).angle <= 10 * kDeg);  // larger steps need a held key
    }
    void aRotationStepKeepsTheTcpInPlace() {
        const Pose from(0.1, 0.2, 0.3, 0.4, -0.2, 0.9);
        JogSelection selection;
        selection.motion = MotionChoice::Step;
        const MoveRequest step = cartesianStep(selection, {5, 1}, 1, from, limits_);
        QCOMPARE(step.pose.position, from.position);
        const Eigen::Matrix3d turned =
            rotationMatrix(step.pose.rotation) * rotationMatrix(from.rotation).transpose();
        QVERIFY(turned.isApprox(rotationMatrix({0, 0, 1 * kDeg}), 1e-9));
    }
    void aJointStepEndsAtTheJointLimit() {
        const RobotModel& model = robotModel(RobotModelId::UR5e);
        JogSelection selection;
        selection.motion = MotionChoice::CoarseStep;
        JointPositions q;
        q[2] = kJointPositionLimit - 0.01;
        const MoveRequest step = jointStep(selection, 2, 1, 1, q, model, {}, limits_);
        QCOMPARE(step.kind, MoveRequest::Kind::MoveJ);
        QVERIFY(close(step.q[2], kJointPositionLimit));
        QVERIFY(close(jointStep(selection, 2, -1, 1, q, model, {}, limits_).q[2], q[2] - 5 * kDeg));
    }
    void aJointJogSendsTheChosenTcpSpeed() {
        JogSelection selection;
        for (int speedClass = 0; speedClass < kSpeedClassCount; ++speedClass) {
            selection.speedClass = speedClass;
            const double chosen = speedClasses()[static_cast<std::size_t>(speedClass)].tcp;
            QVERIFY(close(jointJog(selection, 1, 1, 1, limits_).speedCap, chosen));
            QVERIFY(close(jointJog(selection, 1, 1, 0.1, limits_).speedCap, 0.1 * chosen));
            QVERIFY(jointJog(selection, 1, 1, 3, limits_).speedCap <= limits_.tcpSpeed);
        }
    }
    void aJointKeyUsesTheFullTcpSpeed() {
        const RobotModel& model = robotModel(RobotModelId::UR5e);
        JogSelection selection;
        selection.speedClass = 0;
        const JointPositions stretched(0.3, -0.1, 0.1, 0, 1.5, 0);
        const double radius = kinematics::forwardTcp(model.dh, stretched).position.head<2>().norm();
        const double base = jointKeySpeed(selection, 0, 1, stretched, model, {}, limits_);
        QVERIFY(close(base * radius, 0.005));
        QVERIFY(close(jointStep(selection, 0, -1, 1, stretched, model, {}, limits_).speed, base));
        QVERIFY2(
            close(jointKeySpeed(selection, 5, 1, stretched, model, {}, limits_), speedClasses()[0].joint),
            "wrong speed with the TCP on the axis of wrist 3");
    }
    void homeKeepsTheTcpBelowTheCap() {
        const RobotModel& model = robotModel(RobotModelId::UR5e);
        JogSelection selection;
        selection.speedClass = kSpeedClassCount - 1;
        const JointPositions stretched(2.0, 0, 0, 0, 0, 0);
        const MoveRequest move = homeMove(selection, stretched, defaultHome(), model, {}, limits_);
        QCOMPARE(move.q, defaultHome());
        QVERIFY(move.speed > 0.01);
        const Vector6 way = defaultHome().values - stretched.values;
        const Vector6 qd = way / way.cwiseAbs().maxCoeff() * move.speed;
        for (int i = 0; i <= 100; ++i) {
            const JointPositions q(Vector6(stretched.values + way * (i / 100.0)));
            QVERIFY((kinematics::jacobian(model.dh, q).topRows<3>() * qd).norm() <= limits_.tcpSpeed);
        }
    }
    void limiterReportsTheJointAndTheDirectionOut() {
        SessionState state;
        state.q = JointPositions(0, -1.5, 1.5, 0, 1.5, 0);
        QVERIFY(nearestLimiter(state).what.isEmpty());
        state.q[3] = -kJointPositionLimit + 12 * kDeg;
        QCOMPARE(nearestLimiter(state).what, QStringLiteral("Wrist 1 12° from its limit"));
        QVERIFY(nearestLimiter(state).advice.contains(QStringLiteral("Wrist 1 +")));
    }
    void limiterNamesSingularities() {
        SessionState state;
        state.q = JointPositions(0, -1.5, 1.5, 0, 0.02, 0);
        QVERIFY(nearestLimiter(state).what.contains(QStringLiteral("Wrist 2")));
        state.q = JointPositions(0, -1.0, 0.02, -1.0, 1.5, 0);
        QVERIFY(nearestLimiter(state).what.contains(QStringLiteral("Elbow")));
    }
};

QTEST_GUILESS_MAIN(TestJogMotion)
#include "tst_jog_motion.moc"
