// SPDX-License-Identifier: MIT
//
// The checks of the practice tasks. Each check passes only for the required result.

#include <QTest>
#include <numbers>

#include "robot/core/angles.h"
#include "robot/station/practice/practice_check.h"
#include "tests/support/live_state.h"

using namespace tiller;
using namespace tiller::test;

namespace {

SessionState stoppedState() {
    SessionState state = liveState();
    state.safetyMode = SafetyMode::ProtectiveStop;
    state.control = ControlState::None;
    return state;
}

/// A frame rotated about the Z axis of the base and tilted about its X axis.
project::Frame frameAt(const Eigen::Vector3d& origin, double yawDegrees, double tipDegrees = 0) {
    project::Frame frame;
    frame.id = QUuid::createUuid();
    frame.name = QStringLiteral("bench");
    const Eigen::Matrix3d R = (Eigen::AngleAxisd(toRadians(tipDegrees), Eigen::Vector3d::UnitX()) *
                               Eigen::AngleAxisd(toRadians(yawDegrees), Eigen::Vector3d::UnitZ()))
                                  .toRotationMatrix();
    frame.T_base_frame = Pose(origin, rotationVector(R));
    return frame;
}

SessionState jogging(const Eigen::Vector3d& at, control::LimiterKind limiter, double scale) {
    SessionState state = liveState();
    state.tcpPose.position = at;
    state.motionActive = state.jogActive = state.moving = true;
    state.limiter = {limiter, 2, 0, scale};
    return state;
}

SessionState pressed(double newtons, bool recording, double seconds) {
    SessionState state = liveState();
    state.tcpForce.force = Eigen::Vector3d(1, -2, newtons);
    state.recording.active = recording;
    state.recording.rows = recording ? static_cast<std::uint64_t>(seconds * 500) : 0;
    state.recording.seconds = seconds;
    return state;
}

}  // namespace

class TestPracticeChecks : public QObject {
    Q_OBJECT

private:
    project::Project project_;

    /// Simulates a recording of this duration [s] with this contact force [N].
    void record(PracticeCheck& check, double newtons, double seconds) {
        for (int i = 0; i <= 10; ++i) {
            check.follow(pressed(newtons + (i % 2 == 0 ? 0.3 : -0.3), true, seconds * i / 10), project_);
        }
        check.follow(pressed(newtons, false, 0), project_);
    }

private Q_SLOTS:
    void init() { project_ = {}; }

    void everyTaskHasItsTexts() {
        QSet<QString> names;
        for (const PracticeTask task : kPracticeTasks) {
            names.insert(practiceName(task));
            QVERIFY(!practiceTitle(task).isEmpty());
            const auto sentences = practiceText(task).count(". ") + 1;
            QVERIFY2(sentences >= 2 && sentences <= 3, qPrintable(practiceText(task)));
        }
        QCOMPARE(names.size(), kPracticeTasks.size());
    }

    // ---- recover

    void recoverNeedsTheStopRecoveryAndControl() {
        const auto check = practiceCheck(PracticeTask::Recover, project_);
        check->follow(liveState(), project_);
        QVERIFY2(!check->passed(), "the check passed without a stop");
        check->follow(stoppedState(), project_);
        QVERIFY(check->text().contains("protective stop"));
        SessionState state = liveState();
        state.robotMode = RobotMode::Idle;
        state.control = ControlState::None;
        check->follow(state, project_);
        QVERIFY(!check->passed());
        state.robotMode = RobotMode::Running;
        check->follow(state, project_);
        QVERIFY2(!check->passed() && check->text().contains("control"), qPrintable(check->text()));
        check->follow(liveState(), project_);
        QVERIFY(check->passed());
        check->follow(stoppedState(), project_);
        QVERIFY2(check->passed(), "the check failed after it had passed");
    }

    void lostDataDoNotCountAsRecovery() {
        const auto check = practiceCheck(PracticeTask::Recover, project_);
        check->follow(stoppedState(), project_);
        SessionState lost = liveState();
        lost.link = LinkState::Lost;
        check->follow(lost, project_);
        QVERIFY(!check->passed());
    }

    // ---- teach a frame

    void aFrameAlongYWithZUpPasses() {
        const Eigen::Vector3d origin = liveState().tcpPose.position;
        const auto check = practiceCheck(PracticeTask::TeachFrame, project_);
        check->follow(liveState(), project_);
        QVERIFY(!check->passed());
        // In the meantime, the arm has moved to the other points.
        SessionState on = liveState();
        on.tcpPose.position += Eigen::Vector3d(-0.04, 0.06, 0);
        check->follow(on, project_);
        project_.frames.append(frameAt(origin, 93));
        check->follow(on, project_);
        QVERIFY2(check->passed(), qPrintable(check->text()));
    }

    void otherFramesFail_data() {
        QTest::addColumn<double>("yaw");
        QTest::addColumn<double>("tip");
        QTest::addColumn<double>("away");
        QTest::addColumn<QString>("word");
        QTest::newRow("along X") << 0.0 << 0.0 << 0.0 << "X";
        QTest::newRow("backwards") << -90.0 << 0.0 << 0.0 << "X";
        QTest::newRow("a little too slanted") << 105.0 << 0.0 << 0.0 << "X";
        QTest::newRow("upside down") << 90.0 << 180.0 << 0.0 << "Z";
        QTest::newRow("typed, not taken") << 90.0 << 0.0 << 0.05 << "not taught with the arm";
    }
    void otherFramesFail() {
        QFETCH(double, yaw);
        QFETCH(double, tip);
        QFETCH(double, away);
        QFETCH(QString, word);
        const auto check = practiceCheck(PracticeTask::TeachFrame, project_);
        check->follow(liveState(), project_);
        project_.frames.append(frameAt(liveState().tcpPose.position + Eigen::Vector3d(away, 0, 0), yaw, tip));
        check->follow(liveState(), project_);
        QVERIFY(!check->passed());
        QVERIFY2(check->text().contains(word), qPrintable(check->text()));
    }

    void aFrameFromBeforeDoesNotCount() {
        project_.frames.append(frameAt(liveState().tcpPose.position, 90));
        const auto check = practiceCheck(PracticeTask::TeachFrame, project_);
        check->follow(liveState(), project_);
        QVERIFY(!check->passed());
    }

    // ---- touch up

    void touchingUpAtThePartPasses() {
        project_.waypoints.append(practiceWaypoint(liveState(), project_));
        const QUuid id = project_.waypoints.at(0).id;
        const auto check = practiceCheck(PracticeTask::TouchUp, project_, id);
        check->follow(liveState(), project_);
        QVERIFY(!check->passed());
        SessionState there = liveState();
        there.tcpPose.position.x() += kPartMoved + 0.0005;
        check->follow(there, project_);
        QVERIFY2(!check->passed(), "the check passed without a change of the waypoint");
        project::Waypoint point = project_.waypoints.at(0);
        point.pose = there.tcpPose;
        project_.waypoints.replace(0, point);
        check->follow(there, project_);
        QVERIFY2(check->passed(), qPrintable(check->text()));
    }

    void otherPositionsFail_data() {
        QTest::addColumn<double>("x");
        QTest::addColumn<double>("y");
        QTest::addColumn<double>("turned");
        QTest::addColumn<bool>("armThere");
        QTest::newRow("half the way") << 0.010 << 0.0 << 0.0 << true;
        QTest::newRow("the other way") << -0.020 << 0.0 << 0.0 << true;
        QTest::newRow("beside it") << 0.020 << 0.004 << 0.0 << true;
        QTest::newRow("turned") << 0.020 << 0.0 << 0.1 << true;
        QTest::newRow("typed in figures") << 0.020 << 0.0 << 0.0 << false;
    }
    void otherPositionsFail() {
        QFETCH(double, x);
        QFETCH(double, y);
        QFETCH(double, turned);
        QFETCH(bool, armThere);
        project_.waypoints.append(practiceWaypoint(liveState(), project_));
        project::Waypoint point = project_.waypoints.at(0);
        const auto check = practiceCheck(PracticeTask::TouchUp, project_, point.id);
        point.pose.position += Eigen::Vector3d(x, y, 0);
        point.pose.rotation =
            rotationVector(Eigen::AngleAxisd(turned, Eigen::Vector3d::UnitZ()).toRotationMatrix() *
                           rotationMatrix(point.pose.rotation));
        project_.waypoints.replace(0, point);
        check->follow(armThere ? liveAt(point.pose) : liveState(), project_);
        QVERIFY(!check->passed());
        QVERIFY(!check->text().isEmpty());
    }

    void deletedWaypointIsReported() {
        project_.waypoints.append(practiceWaypoint(liveState(), project_));
        const auto check = practiceCheck(PracticeTask::TouchUp, project_, project_.waypoints.at(0).id);
        project_.waypoints.clear();
        check->follow(liveState(), project_);
        QVERIFY(!check->passed() && check->text().contains("Start"));
    }

    // ---- find the limit

    void theLimitIsFoundAndLeft_data() {
        QTest::addColumn<int>("kind");
        QTest::newRow("stretched") << static_cast<int>(control::LimiterKind::Singularity);
        QTest::newRow("joint") << static_cast<int>(control::LimiterKind::JointLimit);
    }
    void theLimitIsFoundAndLeft() {
        QFETCH(int, kind);
        const auto limiter = static_cast<control::LimiterKind>(kind);
        const auto check = practiceCheck(PracticeTask::FindLimit, project_);
        const Eigen::Vector3d at(0, -0.8, 0.3);
        check->follow(jogging(at, limiter, 0.8), project_);
        QVERIFY2(!check->passed() && check->text().contains("80"), qPrintable(check->text()));
        check->follow(jogging(at, limiter, 0.4), project_);
        QVERIFY(!check->passed());
        check->follow(jogging(at + Eigen::Vector3d(0, 0.03, 0), control::LimiterKind::None, 1), project_);
        QVERIFY2(!check->passed(), "the check passed too close to the limit");
        check->follow(jogging(at + Eigen::Vector3d(0, 0.06, 0), control::LimiterKind::None, 1), project_);
        QVERIFY(check->passed());
    }

    void aSpeedCapIsNotAReachLimit() {
        const auto check = practiceCheck(PracticeTask::FindLimit, project_);
        check->follow(jogging({0, -0.8, 0.3}, control::LimiterKind::TcpSpeed, 0.2), project_);
        check->follow(jogging({0, -0.5, 0.3}, control::LimiterKind::None, 1), project_);
        QVERIFY(!check->passed());
    }

    // ---- record and measure

    void theForceOfTheRecordingPasses_data() {
        QTest::addColumn<double>("answer");
        QTest::addColumn<bool>("passes");
        QTest::newRow("right") << -37.0 << true;
        QTest::newRow("without its sign") << 37.4 << true;
        QTest::newRow("rounded") << 36.0 << true;
        QTest::newRow("too small") << 30.0 << false;
        QTest::newRow("another curve") << 2.0 << false;
    }
    void theForceOfTheRecordingPasses() {
        QFETCH(double, answer);
        QFETCH(bool, passes);
        const auto check = practiceCheck(PracticeTask::Measure, project_);
        check->follow(pressed(-37, false, 0), project_);
        check->setAnswer(answer);
        QVERIFY2(!check->passed(), "the check passed without a recording");
        check->setAnswer(std::nullopt);
        record(*check, -37, 4);
        QVERIFY(!check->passed());
        check->setAnswer(answer);
        QCOMPARE(check->passed(), passes);
        QVERIFY(!check->text().isEmpty());
    }

    void aShortRecordingIsNotEnough() {
        const auto check = practiceCheck(PracticeTask::Measure, project_);
        record(*check, -37, 2);
        check->setAnswer(-37);
        QVERIFY(!check->passed());
        QVERIFY2(check->text().contains("too short"), qPrintable(check->text()));
        record(*check, -37, 3.5);
        QVERIFY(check->passed());
    }

    void aRecordingThatFailedDoesNotCount() {
        const auto check = practiceCheck(PracticeTask::Measure, project_);
        check->follow(pressed(-37, true, 0), project_);
        check->follow(pressed(-37, true, 5), project_);
        SessionState failed = pressed(-37, false, 5);
        failed.recording.error = QStringLiteral("disk full");
        check->follow(failed, project_);
        check->setAnswer(-37);
        QVERIFY(!check->passed());
    }
};

QTEST_MAIN(TestPracticeChecks)
#include "tst_practice_checks.moc"
