// SPDX-License-Identifier: GPL-3.0-or-later
// What is left in each direction, and the way out of a limit, checked with the kinematics alone.
#include <QTest>
#include <numbers>

#include "robot/kinematics/arm_kinematics.h"
#include "robot/kinematics/speed_bounds.h"
#include "widgets/jog/jog_motion.h"
#include "widgets/jog/limiter_line.h"
#include "widgets/jog/travel.h"

using namespace tiller;

namespace {

constexpr double kDeg = std::numbers::pi / 180;
const JointPositions kMiddle{-88 * kDeg, -105 * kDeg, -110 * kDeg, -55 * kDeg, 91 * kDeg, 1 * kDeg};

const DhParameters& dh() {
    return robotModel(RobotModelId::UR5e).dh;
}

Eigen::Matrix<double, 6, 1> along(int axis, int direction) {
    Eigen::Matrix<double, 6, 1> twist = Eigen::Matrix<double, 6, 1>::Zero();
    twist[axis] = direction;
    return twist;
}

}  // namespace

class TestTravel : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void theEndOfTheArmsReachIsFound() {
        // Straight up: the arm is stretched when the wrist centre is as far from the shoulder as the two
        // links are long.
        const Travel up = travelLeft(dh(), kMiddle, {}, along(2, 1));
        QCOMPARE(up.end, Travel::End::Singularity);
        const Pose start = kinematics::forwardTcp(dh(), kMiddle);
        Pose there = start;
        there.position.z() += up.left;
        QVERIFY2(kinematics::inverseNearest(dh(), there, {}, kMiddle).has_value(),
                 "what is promised can be reached");
        Pose beyond = start;
        beyond.position.z() += up.left + 0.1;
        QVERIFY2(!kinematics::inverseNearest(dh(), beyond, {}, kMiddle), "and not much more");
    }

    // The plane the base stands on is nearer than the end of the reach below it.
    void goingDownEndsAtThePlaneOfTheBase() {
        const Pose tool(0, 0, 0.08, 0, 0, 0);
        for (const Pose& tcp : {Pose(), tool}) {
            const double height = kinematics::forwardTcp(dh(), kMiddle, tcp).position.z();
            QVERIFY(height > 0.05);
            const Travel down = travelLeft(dh(), kMiddle, tcp, along(2, -1));
            QCOMPARE(down.end, Travel::End::Floor);
            QVERIFY2(std::abs(down.left - height) < 1e-6, qPrintable(QString::number(down.left)));
        }
        // Upwards and level it is as far as it was.
        QCOMPARE(travelLeft(dh(), kMiddle, {}, along(2, 1)).end, Travel::End::Singularity);
        QVERIFY(travelLeft(dh(), kMiddle, {}, along(0, 1)).end != Travel::End::Floor);
    }

    // On a pedestal the tool may be below the base, where its plane is no floor.
    void aToolBelowTheBaseHasItsReach() {
        const Pose start = kinematics::forwardTcp(dh(), kMiddle);
        const Pose longTool(0, 0, start.position.z() + 0.02, 0, 0, 0);
        QVERIFY(kinematics::forwardTcp(dh(), kMiddle, longTool).position.z() < 0);
        const Travel down = travelLeft(dh(), kMiddle, longTool, along(2, -1));
        // The flange is above the plane still, and comes down to it.
        QCOMPARE(down.end, Travel::End::Floor);
        QVERIFY2(std::abs(down.left - start.position.z()) < 1e-6, qPrintable(QString::number(down.left)));
    }

    void aTurningTowardsAJointLimitEndsThere() {
        JointPositions near = kMiddle;
        near[5] = kJointPositionLimit - 20 * kDeg;
        const Eigen::Matrix3d R = rotationMatrix(kinematics::forwardTcp(dh(), near).rotation);
        // About the tool's own Z only wrist 3 turns.
        Eigen::Matrix<double, 6, 1> about = Eigen::Matrix<double, 6, 1>::Zero();
        about.tail<3>() = R.col(2);
        const Travel one = travelLeft(dh(), near, {}, about);
        const Travel other = travelLeft(dh(), near, {}, -about);
        const Travel& limited = one.end == Travel::End::JointLimit ? one : other;
        QCOMPARE(limited.end, Travel::End::JointLimit);
        QCOMPARE(limited.joint, 5);
        QVERIFY2(std::abs(limited.left - 20 * kDeg) < 0.5 * kDeg,
                 qPrintable(QString::number(limited.left / kDeg)));
    }

    void everyKeyIsFollowedAlongItsOwnAxis() {
        const auto base = travelPerKey(dh(), kMiddle, {}, Eigen::Matrix3d::Identity());
        QCOMPARE(base[5].left, travelLeft(dh(), kMiddle, {}, along(2, 1)).left);   // Z+
        QCOMPARE(base[0].left, travelLeft(dh(), kMiddle, {}, along(0, -1)).left);  // X-
        // Turned by 90 deg about Z, the frame's X is the base's Y.
        const Eigen::Matrix3d turned =
            Eigen::AngleAxisd(std::numbers::pi / 2, Eigen::Vector3d::UnitZ()).matrix();
        const auto other = travelPerKey(dh(), kMiddle, {}, turned);
        QVERIFY(std::abs(other[1].left - base[3].left) < 1e-6);
    }

    void theWayOutTakesTheJointAway() {
        JointPositions near = kMiddle;
        near[2] = -(kJointPositionLimit - 12 * kDeg);
        const int key = wayOut(dh(), near, {}, Eigen::Matrix3d::Identity(), 2);
        QVERIFY(key >= 0);
        // Followed for 20 mm (or 6 deg), the joint is further from its limit than before.
        const int axis = key / 2;
        const double sign = key % 2 == 0 ? -1 : 1;
        Pose pose = kinematics::forwardTcp(dh(), near);
        if (axis < 3) {
            pose.position[axis] += sign * 0.02;
        } else {
            Eigen::Vector3d about = Eigen::Vector3d::Zero();
            about[axis - 3] = sign;
            pose.rotation = rotationVector(Eigen::AngleAxisd(0.1, about) * rotationMatrix(pose.rotation));
        }
        const auto after = kinematics::inverseNearest(dh(), pose, {}, near);
        QVERIFY(after.has_value());
        QVERIFY(std::abs((*after)[2]) < std::abs(near[2]));
    }

    void theLimiterLineNamesTheKeyThatLeadsOut() {
        SessionState state;
        state.q = kMiddle;
        QVERIFY(nearestLimiter(state).what.isEmpty());
        state.q[2] = -(kJointPositionLimit - 12 * kDeg);
        const LimiterAdvice limiter = nearestLimiter(state);
        QVERIFY2(limiter.what.contains("Elbow 12°"), qPrintable(limiter.what));
        QVERIFY2(limiter.advice.startsWith("jog ") && limiter.advice.contains("turn Elbow +"),
                 qPrintable(limiter.advice));
    }

    void theSpeedCapIsNamedWhileItHolds() {
        SessionState state;
        state.q = kMiddle;
        state.motionActive = true;
        state.limiter.kind = control::LimiterKind::ElbowSpeed;
        state.limiter.scale = 0.6;
        QVERIFY(nearestLimiter(state).what.contains("60 %"));
        state.motionActive = false;
        QVERIFY(nearestLimiter(state).what.isEmpty());
    }

    void alignmentTurnsTheToolToTheNearestAxisAndStaysInPlace() {
        JogSelection selection;
        Pose from(0.1, -0.4, 0.3, 0, 0, 0);
        // The tool points down, ten degrees off.
        from.rotation = rotationVector(
            Eigen::AngleAxisd(std::numbers::pi - 10 * kDeg, Eigen::Vector3d::UnitX()).matrix());
        const MoveRequest request = alignMove(selection, from, {});
        QCOMPARE(request.kind, MoveRequest::Kind::MoveL);
        QVERIFY((request.pose.position - from.position).norm() < 1e-12);
        const Eigen::Vector3d z = rotationMatrix(request.pose.rotation).col(2);
        QVERIFY((z - Eigen::Vector3d(0, 0, -1)).norm() < 1e-9);
        const Eigen::AngleAxisd turn(rotationMatrix(from.rotation).transpose() *
                                     rotationMatrix(request.pose.rotation));
        QVERIFY2(std::abs(turn.angle() - 10 * kDeg) < 1e-9, "no more than the ten degrees");
        QVERIFY2(std::abs(request.speed - chosenSpeed(selection).rotation * 0.25) < 1e-12,
                 "as fast as a turn is chosen");
        // A robot at rest trembles: that is no line to go along slowly.
        const JointPositions q = kMiddle;
        const Pose at = kinematics::forwardTcp(dh(), q);
        Pose turned = at;
        turned.position.x() += 2e-5;
        turned.rotation =
            rotationVector(Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitZ()) * rotationMatrix(at.rotation));
        QVERIFY(std::abs(kinematics::lineSpeedBound(dh(), q, turned, {}, 0.25, 0.8).speed - 0.8 * 0.25) <
                1e-12);
    }

    void sizesEnteredByHandCount() {
        JogSelection selection;
        selection.motion = MotionChoice::CoarseStep;
        QVERIFY(stepRunsToEnd(selection, false) && stepRunsToEnd(selection, true));
        selection.step = StepSize{0.05, 15 * kDeg};
        QVERIFY2(!stepRunsToEnd(selection, false), "above 10 mm only while held");
        QVERIFY2(!stepRunsToEnd(selection, true), "above 10° too");
        selection.step = StepSize{0.05, 1 * kDeg};
        QVERIFY2(stepRunsToEnd(selection, true), "a turn is judged by its angle");
        QCOMPARE(chosenStep(selection).length, 0.05);
        selection.motion = MotionChoice::FineStep;
        QCOMPARE(chosenStep(selection).length, 0.0001);
        selection.speed = speedFor(0.075);
        QCOMPARE(chosenSpeed(selection).tcp, 0.075);
        QVERIFY(chosenSpeed(selection).rotation > speedClasses()[2].rotation);
        QVERIFY(chosenSpeed(selection).rotation < speedClasses()[3].rotation);
        QCOMPARE(speedFor(0.001).joint, speedClasses()[0].joint / 5);
    }
};

QTEST_GUILESS_MAIN(TestTravel)
#include "tst_travel.moc"
