// SPDX-License-Identifier: MIT
#include <QTest>
#include <cmath>
#include <limits>
#include <random>

#include "robot/control/detail/velocity_limiter.h"
#include "robot/kinematics/arm_kinematics.h"

using namespace tiller;
using namespace tiller::control;

namespace {

constexpr double kDeg = 3.14159265358979323846 / 180;

// Far from all limits and singularities.
const JointPositions kGoodPose(-90 * kDeg, -100 * kDeg, -110 * kDeg, -60 * kDeg, 90 * kDeg, 0);

const RobotModel& ur5e() {
    return robotModel(RobotModelId::UR5e);
}

Pose tcpAt(const JointPositions& q) {
    return kinematics::forwardTcp(ur5e().dh, q);
}

Limiter limitAt(const JogTarget& target, const JointPositions& q, const MotionLimits& limits = {}) {
    return VelocityLimiter(ArmLimits::of(ur5e()), limits).limit(target, q, tcpAt(q));
}

JogTarget linear(double x, double y, double z) {
    JogTarget target;
    target.twist.linear = {x, y, z};
    return target;
}

JogTarget joint(int number, double speed) {
    JogTarget target;
    target.kind = JogTarget::Kind::Joint;
    target.qd[number] = speed;
    return target;
}

}  // namespace

class TestVelocityLimiter : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void slowMotionAwayFromLimitsIsNotLimited() {
        const Limiter limiter = limitAt(linear(0.05, 0, 0), kGoodPose);
        QCOMPARE(limiter.kind, LimiterKind::None);
        QCOMPARE(limiter.scale, 1.0);
    }

    // If a robot reports incomplete or implausible values, the limits of its model apply, and it can be
    // moved.
    void unreportedValuesAreTakenFromTheModel() {
        const ArmLimits model = ArmLimits::of(ur5e());
        script::RobotConfiguration reported;
        reported.dh = ur5e().dh;
        ArmLimits limits = ArmLimits::of(ur5e(), reported);  // KinematicsInfo alone
        QVERIFY(limits.minPosition == model.minPosition && limits.maxPosition == model.maxPosition);
        QVERIFY(limits.maxSpeed == model.maxSpeed && limits.maxTorque == model.maxTorque);
        QCOMPARE(VelocityLimiter(limits, {}).limit(linear(0.05, 0, 0), kGoodPose, tcpAt(kGoodPose)).scale,
                 1.0);
        for (const double nonsense : {std::nan(""), -1.0, std::numeric_limits<double>::infinity()}) {
            reported.maxSpeed.fill(nonsense);
            reported.maxPosition.fill(nonsense);
            reported.dh.a.fill(std::nan(""));
            limits = ArmLimits::of(ur5e(), reported);
            QVERIFY(limits.maxSpeed == model.maxSpeed && limits.maxPosition == model.maxPosition);
            QVERIFY(limits.dh == model.dh);
        }
        reported = {};
        reported.dh = ur5e().dh;
        reported.minPosition.fill(-1.0);
        reported.maxPosition.fill(2.0);
        reported.maxSpeed.fill(0.5);
        limits = ArmLimits::of(ur5e(), reported);
        QCOMPARE(limits.minPosition[3], -1.0);
        QCOMPARE(limits.maxPosition[3], 2.0);
        QCOMPARE(limits.maxSpeed[3], 0.5);
    }

    // If a joint position or the TCP pose is not finite, the distance to the limits is unknown, so the jog
    // must not move the arm.
    void nonFiniteValuesStopTheJog() {
        const JogTarget jogs[] = {linear(0.05, 0, 0), joint(1, 0.1)};
        for (const double nonsense : {std::nan(""), std::numeric_limits<double>::infinity()}) {
            for (const JogTarget& jog : jogs) {
                for (int i = 0; i < kJointCount; ++i) {
                    JointPositions q = kGoodPose;
                    q[i] = nonsense;
                    QCOMPARE(VelocityLimiter(ArmLimits::of(ur5e()), {}).limit(jog, q, tcpAt(kGoodPose)).scale,
                             0.0);
                }
                Pose pose = tcpAt(kGoodPose);
                pose.position.y() = nonsense;
                QCOMPARE(VelocityLimiter(ArmLimits::of(ur5e()), {}).limit(jog, kGoodPose, pose).scale, 0.0);
            }
            QCOMPARE(limitAt(linear(nonsense, 0, 0), kGoodPose).scale, 0.0);
            QCOMPARE(limitAt(joint(2, nonsense), kGoodPose).scale, 0.0);
            JogTarget turned = linear(0.05, 0, 0);
            turned.frame = JogFrame::Custom;
            turned.T_base_frame.rotation.x() = nonsense;
            QCOMPARE(limitAt(turned, kGoodPose).scale, 0.0);
            const collision::CollisionCheck check(ur5e(), {}, {});
            VelocityLimiter::Situation situation;
            situation.check = &check;
            situation.qd[3] = nonsense;
            QCOMPARE(VelocityLimiter(ArmLimits::of(ur5e()), {})
                         .limit(jogs[0], kGoodPose, tcpAt(kGoodPose), situation)
                         .scale,
                     0.0);
        }
    }

    void theTcpSpeedIsLimitedInEveryDirection() {
        for (const JogTarget& target : {linear(0.5, 0, 0), linear(0.3, -0.3, 0.3), linear(0, 0, -10)}) {
            const Limiter limiter = limitAt(target, kGoodPose);
            QVERIFY(limiter.scale > 0);
            QVERIFY(target.twist.linear.norm() * limiter.scale <= 0.25 + 1e-12);
        }
        QCOMPARE(limitAt(linear(0.5, 0, 0), kGoodPose).kind, LimiterKind::TcpSpeed);
    }

    void rotationSpeedIsLimited() {
        JogTarget target;
        target.twist.angular = {0, 0, 2};
        const Limiter limiter = limitAt(target, kGoodPose);
        QCOMPARE(limiter.kind, LimiterKind::RotationSpeed);
        QVERIFY(std::abs(2 * limiter.scale - 45 * kDeg) < 1e-9);
    }

    void aJointJogIsLimitedToItsCap() {
        const Limiter limiter = limitAt(joint(5, 2), kGoodPose);
        QCOMPARE(limiter.kind, LimiterKind::JointSpeed);
        QCOMPARE(limiter.joint, 5);
        QVERIFY(std::abs(2 * limiter.scale - 30 * kDeg) < 1e-9);
    }

    // Rotating the base of a stretched arm moves the TCP much faster than the joint speed limit suggests.
    void aJointJogMayNotExceedTheCapOnTheTcp() {
        const JointPositions stretched(0, -10 * kDeg, 15 * kDeg, 0, 90 * kDeg, 0);
        const Limiter limiter = limitAt(joint(0, 30 * kDeg), stretched);
        QCOMPARE(limiter.kind, LimiterKind::TcpSpeed);
        const double radius = tcpAt(stretched).position.head<2>().norm();
        QVERIFY(30 * kDeg * radius * limiter.scale <= 0.25 + 1e-9);
    }

    void jogRespectsItsCap() {
        const JointPositions stretched(0, -10 * kDeg, 15 * kDeg, 0, 90 * kDeg, 0);
        JogTarget target = joint(0, 10 * kDeg);
        const double radius = tcpAt(stretched).position.head<2>().norm();
        QVERIFY(10 * kDeg * radius > 0.05);
        target.speedCap = 0.05;
        Limiter limiter = limitAt(target, stretched);
        QCOMPARE(limiter.kind, LimiterKind::JogSpeed);
        QVERIFY(std::abs(10 * kDeg * radius * limiter.scale - 0.05) < 1e-9);
        // The limit also applies to the elbow, because the TCP is near the axis of the shoulder.
        const JointPositions folded(0, 0, 170 * kDeg, 0, 90 * kDeg, 0);
        target = joint(1, 10 * kDeg);
        target.speedCap = 0.02;
        limiter = limitAt(target, folded);
        QCOMPARE(limiter.kind, LimiterKind::JogSpeed);
        QVERIFY(10 * kDeg * 0.425 * limiter.scale <= 0.02 + 1e-9);
        // A cap above that of the controller has no effect.
        target = joint(0, 30 * kDeg);
        target.speedCap = 3;
        limiter = limitAt(target, stretched);
        QCOMPARE(limiter.kind, LimiterKind::TcpSpeed);
        QVERIFY(30 * kDeg * radius * limiter.scale <= 0.25 + 1e-9);
    }

    // The elbow moves outwards while the TCP is on the base axis and hardly moves.
    void theElbowSpeedIsAlsoLimited() {
        MotionLimits limits;
        limits.jointSpeed = 3;
        const JointPositions folded(0, 0, 170 * kDeg, 0, 90 * kDeg, 0);
        const Limiter limiter = limitAt(joint(0, 3), folded, limits);
        QCOMPARE(limiter.kind, LimiterKind::ElbowSpeed);
        QVERIFY(3 * 0.425 * limiter.scale <= 0.25 + 1e-3);
    }

    void toolFrameDirectionsFollowTheTool() {
        JogTarget target = linear(0, 0, 0.1);
        target.frame = JogFrame::Tool;
        const Pose tcp = tcpAt(kGoodPose);
        const Eigen::Vector3d expected = rotationMatrix(tcp.rotation) * Eigen::Vector3d(0, 0, 0.1);
        QVERIFY((twistInBase(target, tcp).linear - expected).norm() < 1e-12);
    }

    void onlyTheRotationOfACustomFrameMatters() {
        JogTarget target = linear(0.1, 0, 0);
        target.frame = JogFrame::Custom;
        target.T_base_frame = Pose(9, 9, 9, 0, 0, 90 * kDeg);
        QVERIFY((twistInBase(target, {}).linear - Eigen::Vector3d(0, 0.1, 0)).norm() < 1e-12);
    }

    // Simulates the motion with the permitted speed at each step. The joint stops before its limit, and the
    // deceleration never exceeds the maximum of the arm.
    void aJointStopsBeforeItsLimit() {
        for (const int number : {0, 3, 5}) {
            for (const double direction : {1.0, -1.0}) {
                JointPositions q = kGoodPose;
                q[number] = direction * (kJointPositionLimit - 0.4);
                const JogTarget target = joint(number, direction * 30 * kDeg);
                double speed = 30 * kDeg * limitAt(target, q).scale;
                bool blocked = false;
                Limiter limiter;
                for (int step = 0; step < 20000 && !blocked; ++step) {
                    limiter = limitAt(target, q);
                    blocked = limiter.scale == 0;
                    const double next = 30 * kDeg * limiter.scale;
                    QVERIFY2((speed - next) / 0.002 < 4.0 || blocked,
                             "the deceleration exceeds that of a stop");
                    speed = next;
                    q[number] += direction * speed * 0.002;
                }
                QVERIFY(blocked);
                QCOMPARE(limiter.kind, LimiterKind::JointLimit);
                QCOMPARE(limiter.joint, number);
                const double left = kJointPositionLimit - std::abs(q[number]);
                QVERIFY(left > 0);
                QVERIFY(left < 1 * kDeg);
                QVERIFY(std::abs(limiter.distance - left) < 1e-3);
            }
        }
    }

    void motionAwayFromALimitIsFree() {
        JointPositions q = kGoodPose;
        q[3] = kJointPositionLimit - 0.001;
        QCOMPARE(limitAt(joint(3, 0.2), q).scale, 0.0);
        QCOMPARE(limitAt(joint(3, -0.2), q).scale, 1.0);
        q[3] = kJointPositionLimit + 0.01;  // already beyond the limit
        QCOMPARE(limitAt(joint(3, 0.2), q).scale, 0.0);
        QCOMPARE(limitAt(joint(3, -0.2), q).scale, 1.0);
    }

    void cartesianMotionSlowsNearAJointLimitAndReportsIt() {
        JointPositions q = kGoodPose;
        q[0] = kJointPositionLimit - 0.012;
        // The tangential direction, which rotates the base further.
        const Pose tcp = tcpAt(q);
        const Eigen::Vector3d tangent = Eigen::Vector3d(-tcp.position.y(), tcp.position.x(), 0).normalized();
        const Eigen::Vector3d in = 0.1 * tangent;
        const Limiter inwards = limitAt(linear(in.x(), in.y(), 0), q);
        QCOMPARE(inwards.kind, LimiterKind::JointLimit);
        QCOMPARE(inwards.joint, 0);
        QVERIFY(inwards.scale < 0.8);
        QCOMPARE(limitAt(linear(-in.x(), -in.y(), 0), q).scale, 1.0);
    }

    void onlyMotionTowardsASingularitySlowsDown() {
        JointPositions q = kGoodPose;
        q[2] = -8 * kDeg;  // elbow nearly straight
        q[1] = -60 * kDeg;
        const Pose tcp = tcpAt(q);
        const Pose shoulder = Pose(kinematics::linkFrames(ur5e().dh, q)[1]);
        const Eigen::Vector3d out = (tcp.position - shoulder.position).normalized() * 0.05;
        const Limiter stretching = limitAt(linear(out.x(), out.y(), out.z()), q);
        QCOMPARE(stretching.kind, LimiterKind::Singularity);
        QCOMPARE(stretching.joint, 2);
        QVERIFY(stretching.scale < 0.6);
        const Limiter folding = limitAt(linear(-out.x(), -out.y(), -out.z()), q);
        QVERIFY(folding.kind != LimiterKind::Singularity);
        QVERIFY(folding.scale > stretching.scale);
    }

    void allValuesAreFiniteInASingularity() {
        const JointPositions up(0, -90 * kDeg, 0, -90 * kDeg, 0, 0);
        for (int axis = 0; axis < 6; ++axis) {
            for (const double sign : {1.0, -1.0}) {
                JogTarget target;
                Vector6 v = Vector6::Zero();
                v[axis] = 0.05 * sign;
                target.twist = Twist::fromVector(v);
                const Limiter limiter = limitAt(target, up);
                QVERIFY(std::isfinite(limiter.scale));
                QVERIFY(limiter.scale >= 0 && limiter.scale <= 1);
            }
        }
        QCOMPARE(limitAt(joint(2, 0.1), up).scale, 1.0);  // joint jogs can always leave a singularity
    }

    // Linear jogs cannot leave the centre of a singularity, because the robot would trigger a protective
    // stop.
    void deepInASingularityLinearJogsAreBlocked() {
        const JointPositions wristAndElbow(-0.886325, -2.81512, -0.0419052, -3.73636, 3.14351, 0.189416);
        JointPositions wrist = kGoodPose;
        wrist[4] = 0.2 * kDeg;
        for (const JointPositions& q : {wristAndElbow, wrist}) {
            for (const JogTarget& target : {linear(0.05, 0, 0), linear(0, 0.05, 0), linear(0, 0, -0.05)}) {
                const Limiter limiter = limitAt(target, q);
                QCOMPARE(limiter.scale, 0.0);
                QCOMPARE(limiter.kind, LimiterKind::Singularity);
            }
            QCOMPARE(limitAt(joint(4, 0.1), q).scale, 1.0);
        }
    }

    // Inside the zone, no permitted motion approaches the singularity, not even during its first micrometres.
    void withinTheZoneNoPermittedMotionGetsCloser() {
        std::mt19937 random(5);
        std::uniform_real_distribution<double> real(-1, 1);
        int permitted = 0;
        for (int i = 0; i < 200'000; ++i) {
            JointPositions q = kGoodPose;
            for (int j = 1; j < 5; ++j) {
                q[j] += 1.6 * real(random);
            }
            const auto here = kinematics::singularityMeasure(ur5e().dh, q);
            if (here.shoulder > 0.02 || here.wrist < 0.2 || here.elbow < 0.3) {
                continue;
            }
            JogTarget target = linear(0.01 * real(random), 0.01 * real(random), 0.01 * real(random));
            target.twist.angular = {real(random), real(random), real(random)};
            if (limitAt(target, q).scale <= 0) {
                continue;
            }
            ++permitted;
            const Pose tcp = tcpAt(q);
            constexpr double kMoment = 1e-5;  // [s]
            const Eigen::Vector3d turn = target.twist.angular * kMoment;
            const Pose soon(tcp.position + target.twist.linear * kMoment,
                            rotationVector(rotationMatrix(turn) * rotationMatrix(tcp.rotation)));
            const auto next = kinematics::inverseNearest(ur5e().dh, soon, {}, q);
            if (!next) {
                continue;
            }
            const double change = kinematics::singularityMeasure(ur5e().dh, *next).shoulder - here.shoulder;
            QVERIFY2(change > -1e-7,
                     qPrintable(QStringLiteral("%1 m at %2 m").arg(change).arg(here.shoulder)));
        }
        QVERIFY2(permitted > 50, qPrintable(QString::number(permitted)));
    }

    void zeroVelocityIsNotLimited() { QCOMPARE(limitAt(JogTarget{}, kGoodPose).scale, 1.0); }
};

QTEST_GUILESS_MAIN(TestVelocityLimiter)
#include "tst_velocity_limiter.moc"
