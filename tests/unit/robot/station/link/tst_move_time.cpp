// SPDX-License-Identifier: GPL-3.0-or-later
// During a move, no part of the arm exceeds the selected speed.
#include <QTest>
#include <cmath>
#include <limits>

#include "robot/kinematics/arm_kinematics.h"
#include "robot/kinematics/speed_bounds.h"
#include "robot/station/link/move_time.h"
#include "tests/support/live_state.h"

using namespace tiller;
using test::liveState;

namespace {

constexpr double kFast = 0.25;  // [m/s]
constexpr double kChosen = 0.05;

/// The forearm points back, so the wrist is near the axis of the shoulder.
const JointPositions kFolded(0, -0.8, 2.7, -1.9, 1.57, 0);

const DhParameters& dh() {
    return robotModel(RobotModelId::UR5e).dh;
}

/// TCP velocity while the shoulder rotates at 1 rad/s and wrist 1 rotates back, so that the orientation of
/// the tool is constant [m/s].
Eigen::Vector3d aroundTheShoulder(const JointPositions& q) {
    const auto J = kinematics::jacobian(dh(), q);
    return (J.col(1) - J.col(3)).head<3>();
}

MoveRequest line(const SessionState& state, const Eigen::Vector3d& way) {
    MoveRequest request;
    request.kind = MoveRequest::Kind::MoveL;
    request.pose = state.tcpPose;
    request.pose.position += way;
    request.speed = kFast;
    return request;
}

HeldSpeed chosen() {
    HeldSpeed speed;
    speed.tcp = kChosen;
    return speed;
}

}  // namespace

class TestMoveTime : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void aLineUsesTheFullTcpSpeed() {
        const SessionState state = liveState();
        QCOMPARE(slowedTo(chosen(), line(state, {0, 0, 0.02}), state).speed, kChosen);
    }

    void aLineNearTheShoulderIsLimitedByTheElbow() {
        const SessionState state = liveState(kFolded);
        const Eigen::Vector3d around = aroundTheShoulder(kFolded);
        const MoveRequest asked = line(state, 0.03 * around.normalized());
        const double speed = slowedTo(chosen(), asked, state).speed;
        QVERIFY2(speed > 0 && speed < 0.6 * kChosen, qPrintable(QString::number(speed)));
        // At the start, the elbow rotates about the shoulder together with the upper arm.
        const double elbow = std::abs(dh().a[1]) * speed / around.norm();
        QVERIFY2(elbow < 1.05 * kChosen && elbow > 0.8 * kChosen, qPrintable(QString::number(elbow)));
    }

    void aLineWithRotationIsAlsoLimitedByTheElbow() {
        const SessionState state = liveState(kFolded);
        MoveRequest turning = line(state, 0.03 * aroundTheShoulder(kFolded).normalized());
        turning.pose.rotation =
            rotationVector(rotationMatrix(state.tcpPose.rotation) * rotationMatrix({0, 0, 0.4}));
        // The rotation dominates, so the speed refers to the path length that corresponds to the rotation.
        // The elbow limits the speed.
        const double length = kinematics::lineLength(state.tcpPose, turning.pose);
        QVERIFY(std::abs(length - 0.4 * kinematics::kTurnRadius) < 1e-6);
        const double tcp = slowedTo(chosen(), turning, state).speed * 0.03 / length;
        const double bound = kinematics::lineSpeedBound(dh(), state.q, turning.pose, state.tcpOffset, kChosen,
                                                        std::numeric_limits<double>::infinity())
                                 .speed;
        QVERIFY(bound < 0.9 * kChosen);
        QVERIFY2(std::abs(tcp - bound) < 1e-6, qPrintable(QString::number(tcp)));
    }

    void withoutAChosenSpeedNothingIsSlowed() {
        const SessionState state = liveState(kFolded);
        MoveRequest asked = line(state, 0.03 * aroundTheShoulder(kFolded).normalized());
        QCOMPARE(slowedTo({}, asked, state).speed, kFast);
        asked.speed = std::numeric_limits<double>::infinity();
        QVERIFY(std::isinf(slowedTo({}, asked, state).speed));
    }
};

QTEST_GUILESS_MAIN(TestMoveTime)
#include "tst_move_time.moc"
