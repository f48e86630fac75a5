// SPDX-License-Identifier: GPL-3.0-or-later
// The remaining travel in each direction, and the direction away from a limit, checked with kinematics only.
#include <QTest>
#include <memory>
#include <numbers>
#include <optional>

#include "robot/kinematics/arm_kinematics.h"
#include "robot/kinematics/speed_bounds.h"
#include "robot/station/jog/jog_motion.h"
#include "robot/station/jog/limiter_advice.h"
#include "robot/station/jog/travel.h"

using namespace tiller;

namespace {

constexpr double kDeg = std::numbers::pi / 180;
const JointPositions kMiddle{-88 * kDeg, -105 * kDeg, -110 * kDeg, -55 * kDeg, 91 * kDeg, 1 * kDeg};

const DhParameters& dh() {
    return robotModel(RobotModelId::UR5e).dh;
}

/// An arm, optionally above a floor, with the nominal model of the robot.
SessionState armAt(const JointPositions& q, const Pose& tcpOffset = {}, std::optional<double> floor = {},
                   double toolRadius = 0) {
    SessionState state;
    state.q = q;
    state.tcpOffset = tcpOffset;
    state.tcpPose = kinematics::forwardTcp(dh(), q, tcpOffset);
    collision::Surroundings around;
    if (floor) {
        around.borders.push_back({{}, Pose(0, 0, *floor, 0, 0, 0)});
    }
    state.check = std::make_shared<collision::CollisionCheck>(
        robotModel(RobotModelId::UR5e), collision::ToolBody{tcpOffset, toolRadius}, around);
    return state;
}

Vector6 along(int axis, int direction) {
    Vector6 twist = Vector6::Zero();
    twist[axis] = direction;
    return twist;
}

}  // namespace

class TestTravel : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void theReachLimitOfTheArmIsFound() {
        // Straight up, the jog ends shortly before the arm is fully extended.
        const control::JogReach up = travelLeft(armAt(kMiddle), along(2, 1));
        QCOMPARE(up.end.kind, control::LimiterKind::Singularity);
        const Pose start = kinematics::forwardTcp(dh(), kMiddle);
        Pose there = start;
        there.position.z() += up.distance;
        QVERIFY2(kinematics::inverseNearest(dh(), there, {}, kMiddle).has_value(),
                 "the predicted position is out of reach");
        Pose beyond = start;
        beyond.position.z() += up.distance + 0.1;
        QVERIFY2(!kinematics::inverseNearest(dh(), beyond, {}, kMiddle),
                 "the arm can move much further than predicted");
    }

    // Only limits end the jog. The mounting plane is not a limit, but a floor of the cell is.
    void onlyAFloorOfTheCellLimitsDownwardTravel() {
        const control::JogReach open = travelLeft(armAt(kMiddle), along(2, -1));
        QVERIFY(open.end.kind != control::LimiterKind::Border);
        const double height = kinematics::forwardTcp(dh(), kMiddle).position.z();
        QVERIFY2(open.distance > height, "the mounting plane limits the travel");

        const Pose tool(0, 0, 0.08, 0, 0, 0);
        const double radius = 0.02;
        const double tip = kinematics::forwardTcp(dh(), kMiddle, tool).position.z();
        const control::JogReach down = travelLeft(armAt(kMiddle, tool, 0, radius), along(2, -1));
        QCOMPARE(down.end.kind, control::LimiterKind::Border);
        QCOMPARE(down.end.link, collision::kToolLink);
        QVERIFY2(std::abs(down.distance - (tip - collision::kSafetyDistance)) < 0.002,
                 qPrintable(QString::number(down.distance)));
        // The upward travel is unchanged.
        QCOMPARE(travelLeft(armAt(kMiddle, tool, 0, radius), along(2, 1)).end.kind,
                 control::LimiterKind::Singularity);
    }

    void aRotationTowardsAJointLimitEndsThere() {
        JointPositions near = kMiddle;
        near[5] = kJointPositionLimit - 20 * kDeg;
        const Eigen::Matrix3d R = rotationMatrix(kinematics::forwardTcp(dh(), near).rotation);
        // A rotation about the tool's Z axis moves only wrist 3.
        Vector6 about = Vector6::Zero();
        about.tail<3>() = R.col(2);
        const control::JogReach one = travelLeft(armAt(near), about);
        const control::JogReach other = travelLeft(armAt(near), -about);
        const control::JogReach& limited = one.end.kind == control::LimiterKind::JointLimit ? one : other;
        QCOMPARE(limited.end.kind, control::LimiterKind::JointLimit);
        QCOMPARE(limited.end.joint, 5);
        // The jog ends 0.01 rad before the end of the range.
        QVERIFY2(std::abs(limited.distance - (20 * kDeg - 0.01)) < 0.1 * kDeg,
                 qPrintable(QString::number(limited.distance / kDeg)));
    }

    void theDirectionOutMovesTheJointAwayFromItsLimit() {
        JointPositions near = kMiddle;
        near[2] = -(kJointPositionLimit - 12 * kDeg);
        const int key = escapeKey(armAt(near), Eigen::Matrix3d::Identity(), 2);
        QVERIFY(key >= 0);
        // After following the advice for 20 mm (or 6 deg), the joint is further away from its limit.
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

    void theLimiterLineNamesTheKeyThatMovesAway() {
        SessionState state;
        state.q = kMiddle;
        QVERIFY(nearestLimiter(state).what.isEmpty());
        state.q[2] = -(kJointPositionLimit - 12 * kDeg);
        const LimiterAdvice limiter = nearestLimiter(state);
        QVERIFY2(limiter.what.contains("Elbow 12°"), qPrintable(limiter.what));
        QVERIFY2(limiter.advice.startsWith("jog ") && limiter.advice.contains("rotate Elbow +"),
                 qPrintable(limiter.advice));
    }

    void theLimiterLineNamesNearBodiesAndTheKeyThatMovesAway() {
        // In this pose, a floor 15 mm below the arm is also below the shoulder.
        Pose low = kinematics::forwardTcp(dh(), kMiddle);
        low.position.z() -= 0.2;
        const JointPositions q = kinematics::inverseNearest(dh(), low, {}, kMiddle).value();
        const auto heightOver = [&](double floor) {
            const SessionState above = armAt(q, {}, floor);
            double height = 1e9;
            for (const auto& pair : above.check->pairs()) {
                if (pair.with == collision::Contact::With::Border) {
                    height = std::min(height, above.check->distance(pair, above.check->place(q)));
                }
            }
            return height;
        };
        const double height = heightOver(0);
        SessionState state = armAt(q, {}, height - 0.015);
        LimiterAdvice limiter = nearestLimiter(state);
        QVERIFY2(limiter.what.contains("15 mm from the floor"), qPrintable(limiter.what));
        QCOMPARE(limiter.advice, QStringLiteral("jog Z+"));
        // While the limiter slows down a jog, the text contains the remaining fraction of the speed.
        state.motionActive = true;
        state.limiter.kind = control::LimiterKind::Border;
        state.limiter.link = 6;
        state.limiter.other = 0;
        state.limiter.distance = 0.015;
        state.limiter.scale = 0.4;
        limiter = nearestLimiter(state);
        QCOMPARE(limiter.what, QStringLiteral("Wrist 3 is 15 mm from the floor: 40 % speed"));
        QVERIFY(nearestLimiter(armAt(q, {}, height - 0.05)).what.isEmpty());
    }

    void theSpeedCapIsShownWhileItLimits() {
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
        // The tool points down, tilted by ten degrees.
        from.rotation = rotationVector(
            Eigen::AngleAxisd(std::numbers::pi - 10 * kDeg, Eigen::Vector3d::UnitX()).matrix());
        const MoveRequest request = alignMove(selection, from, {});
        QCOMPARE(request.kind, MoveRequest::Kind::MoveL);
        QVERIFY((request.pose.position - from.position).norm() < 1e-12);
        const Eigen::Vector3d z = rotationMatrix(request.pose.rotation).col(2);
        QVERIFY((z - Eigen::Vector3d(0, 0, -1)).norm() < 1e-9);
        const Eigen::AngleAxisd turn(rotationMatrix(from.rotation).transpose() *
                                     rotationMatrix(request.pose.rotation));
        QVERIFY2(std::abs(turn.angle() - 10 * kDeg) < 1e-9, "the tilt is not corrected by ten degrees");
        QVERIFY2(std::abs(request.speed - chosenSpeed(selection).rotation * 0.25) < 1e-12,
                 "the speed is not the selected rotation speed");
        // The measured position of a robot at standstill fluctuates. This must not count as a slow linear
        // path.
        const JointPositions q = kMiddle;
        const Pose at = kinematics::forwardTcp(dh(), q);
        Pose turned = at;
        turned.position.x() += 2e-5;
        turned.rotation =
            rotationVector(Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitZ()) * rotationMatrix(at.rotation));
        QVERIFY(std::abs(kinematics::lineSpeedBound(dh(), q, turned, {}, 0.25, 0.8).speed - 0.8 * 0.25) <
                1e-12);
    }

    void enteredSizesAreUsed() {
        JogSelection selection;
        selection.motion = MotionChoice::CoarseStep;
        QVERIFY(stepRunsToEnd(selection, false) && stepRunsToEnd(selection, true));
        selection.step = StepSize{0.05, 15 * kDeg};
        QVERIFY2(!stepRunsToEnd(selection, false), "a step above 10 mm continues after the release");
        QVERIFY2(!stepRunsToEnd(selection, true), "a step above 10° continues after the release");
        selection.step = StepSize{0.05, 1 * kDeg};
        QVERIFY2(stepRunsToEnd(selection, true), "a step of 1° is judged by its length");
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
