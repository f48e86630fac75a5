// SPDX-License-Identifier: MIT
// Bounded motions, and control of the robot, in virtual time.
#include <QRegularExpression>
#include <cmath>
#include <initializer_list>
#include <optional>

#include "robot/kinematics/arm_kinematics.h"
#include "robot/script/script_client.h"
#include "tests/integration/control/cell.h"

using namespace tiller;
using namespace tiller::control;
using namespace tiller::test;

namespace {

double distance(const JointPositions& a, const JointPositions& b) {
    return (a.values - b.values).cwiseAbs().maxCoeff();
}

JointPositions turned(const JointPositions& q, int joint, double angle) {
    JointPositions to = q;
    to[joint] += angle;
    return to;
}

}  // namespace

class TestMoves : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void aHeldMoveJReachesItsTarget() {
        Cell cell;
        QVERIFY(cell.takeControl().ok());
        const JointPositions target = turned(cell.robot.truth().q, 0, 20 * kDeg);
        const auto move = cell.motions().moveJ(target, {0.5, 1.4, Holding::Held});
        QVERIFY(move.ok());
        QVERIFY(cell.holdMove(*move, 5000));
        QCOMPARE(move->state().cause, StopCause::Completed);
        QVERIFY(cell.stepMs(20));
        QVERIFY(distance(cell.robot.truth().q, target) < 1e-3);
        QCOMPARE(cell.controller->status().motion, kNoMotion);
    }

    void aFastMoveKeepsTcpAndElbowUnderTheCap_data() {
        QTest::addColumn<bool>("linear");
        QTest::newRow("MoveJ, arm stretched") << false;
        QTest::newRow("MoveL, elbow runs ahead") << true;
    }
    void aFastMoveKeepsTcpAndElbowUnderTheCap() {
        QFETCH(bool, linear);
        Cell cell;
        QVERIFY(cell.takeControl().ok());
        const DhParameters& dh = robotModel(RobotModelId::UR5e).dh;
        const double cap = cell.controller->limits().tcpSpeed;
        double fastest = 0;
        std::optional<Eigen::Vector3d> elbow;
        cell.everyTick = [&] {
            const simulator::SimulatedState truth = cell.robot.truth();
            const Eigen::Vector3d now = kinematics::linkFrames(dh, truth.q)[2].translation();
            fastest = std::max(fastest, truth.tcpSpeed.linear.norm());
            if (elbow) {
                fastest = std::max(fastest, (now - *elbow).norm() / 0.002);
            }
            elbow = now;
        };
        const JointPositions stretched(0, -20 * kDeg, 30 * kDeg, -90 * kDeg, -90 * kDeg, 0);
        const auto there = cell.motions().moveJ(stretched, {3.0, 10.0, Holding::Free});
        QVERIFY(there.ok());
        QVERIFY(cell.stepMs(15'000));
        QCOMPARE(there->state().cause, StopCause::Completed);
        if (linear) {
            Pose in = cell.tcp();
            in.position.head<2>() *= 0.75;
            const auto back = cell.motions().moveL(in, {cap, 2.0, Holding::Free});
            QVERIFY(back.ok());
            QVERIFY(cell.stepMs(6000));
            QCOMPARE(back->state().cause, StopCause::Completed);
        }
        QVERIFY2(fastest < cap * 1.02, qPrintable(QString::number(fastest)));
        QVERIFY2(fastest > cap * 0.5, "the speed was reduced more than necessary");
    }

    void aHeldMoveLReachesItsPoseOnAStraightLine() {
        Cell cell;
        QVERIFY(cell.takeControl().ok());
        const Pose start = cell.tcp();
        Pose target = start;
        target.position += Eigen::Vector3d(0.06, 0.03, 0.05);
        const Eigen::Vector3d along = (target.position - start.position).normalized();
        double aside = 0;
        cell.everyTick = [&] {
            const Eigen::Vector3d way = cell.tcp().position - start.position;
            aside = std::max(aside, (way - way.dot(along) * along).norm());
        };
        const auto move = cell.motions().moveL(target, {0.1, 0.5, Holding::Held});
        QVERIFY(move.ok());
        QVERIFY(cell.holdMove(*move, 5000));
        QCOMPARE(move->state().cause, StopCause::Completed);
        QVERIFY((cell.tcp().position - target.position).norm() < 0.0005);
        QVERIFY(aside < 0.0005);
    }

    void aFreeMoveNeedsNoRefresh() {
        Cell cell;
        QVERIFY(cell.takeControl().ok());
        const JointPositions target = turned(cell.robot.truth().q, 0, 15 * kDeg);
        const auto move = cell.motions().moveJ(target, {0.5, 1.4, Holding::Free});
        QVERIFY(move.ok());
        QVERIFY(cell.stepMs(2000));
        QCOMPARE(move->state().cause, StopCause::Completed);
        QVERIFY(distance(cell.robot.truth().q, target) < 1e-3);
    }

    void bracesDenoteJointsAndAllParametersHaveDefaults() {
        Cell cell;
        QVERIFY(cell.takeControl().ok());
        Motions motions = cell.motions();
        const JointPositions target(-1.4, -1.7, -2.2, -0.8, 1.6, 0.0);
        const auto move = motions.moveJ({-1.4, -1.7, -2.2, -0.8, 1.6, 0.0});
        QVERIFY2(move.ok(), qPrintable(move.error().toString()));
        QVERIFY(cell.stepMs(3000));
        QCOMPARE(move->state().cause, StopCause::Completed);
        QVERIFY(distance(cell.robot.truth().q, target) < 1e-3);
        // A move must not be refused because the speed cap is below the default speed.
        QVERIFY(cell.controller->setSpeedCap(0.05).ok());
        Pose up = cell.tcp();
        up.position.z() += 0.02;
        const auto line = motions.moveL(up);
        QVERIFY2(line.ok(), qPrintable(line.error().toString()));
        QVERIFY(cell.stepMs(1500));
        QCOMPARE(line->state().cause, StopCause::Completed);
    }

    void theHandleReportsTheDurationOfTheMove_data() {
        QTest::addColumn<bool>("linear");
        QTest::addColumn<double>("speed");
        QTest::newRow("MoveJ as asked") << false << 0.3;
        QTest::newRow("MoveJ held down by the cap") << false << 2.0;
        QTest::newRow("MoveL") << true << 0.1;
    }
    void theHandleReportsTheDurationOfTheMove() {
        QFETCH(bool, linear);
        QFETCH(double, speed);
        Cell cell;
        QVERIFY(cell.takeControl().ok());
        Pose up = cell.tcp();
        up.position.z() += 0.1;
        const auto move = linear
                              ? cell.motions().moveL(up, {.speed = speed, .acceleration = 0.5})
                              : cell.motions().moveJ(turned(cell.robot.truth().q, 0, 1.5), {.speed = speed});
        QVERIFY2(move.ok(), qPrintable(move.error().toString()));
        QVERIFY(move->plan().has_value());
        const MotionPlan plan = *move->plan();
        QVERIFY(cell.stepMs(200));
        // The speed cap slows down the move, and the status reports it.
        const bool slowed = speed > 1;
        QCOMPARE(plan.limiter.kind, slowed ? LimiterKind::TcpSpeed : LimiterKind::None);
        QCOMPARE(cell.controller->status().limiter.kind, plan.limiter.kind);
        QCOMPARE(plan.limiter.scale < 0.5, slowed);
        QVERIFY(std::abs(plan.speed - speed * plan.limiter.scale) < 1e-9);
        int ms = 200;
        for (; move->isActive() && ms < 20'000; ms += 2) {
            QVERIFY(cell.step());
        }
        QCOMPARE(move->state().cause, StopCause::Completed);
        QVERIFY2(std::abs(ms * 0.001 - plan.duration.count()) < 0.05,
                 qPrintable(QStringLiteral("%1 s, not %2").arg(ms * 0.001).arg(plan.duration.count())));
        QCOMPARE(cell.controller->status().limiter.kind, LimiterKind::None);
    }

    void aSpeedAboveTheCapIsRefusedWithASuggestion() {
        Cell cell;
        QVERIFY(cell.takeControl().ok());
        const Error error = cell.motions().moveL(cell.tcp(), {.speed = 0.5}).error();
        QCOMPARE(error.code, ErrorCode::LimitExceeded);
        QVERIFY2(error.controllerMessage.contains(QStringLiteral("setSpeedCap")),
                 qPrintable(error.toString()));
        for (const double millimetres : {250.0, 1e9, 3.001}) {
            const Error cap = cell.controller->setSpeedCap(millimetres).error();
            QCOMPARE(cap.code, ErrorCode::LimitExceeded);
            QVERIFY2(cap.controllerMessage.contains(QStringLiteral("cap: ")), qPrintable(cap.toString()));
            QCOMPARE(cap.controllerMessage.contains(QStringLiteral("mm/s")), millimetres > 100);
        }
        QCOMPARE(cell.controller->limits().tcpSpeed, 0.25);
        QVERIFY(cell.controller->setSpeedCap(3.0).ok());
    }

    void limitsInAnotherUnitAreRefusedWhenControlIsTaken() {
        for (const auto& [name, set] :
             std::initializer_list<std::pair<const char*, std::function<void(MotionLimits&)>>>{
                 {"limits.tcpSpeed", [](MotionLimits& l) { l.tcpSpeed = 250; }},
                 {"limits.tcpRotationSpeed", [](MotionLimits& l) { l.tcpRotationSpeed = 45; }},
                 {"limits.jointSpeed", [](MotionLimits& l) { l.jointSpeed = std::nan(""); }},
                 {"limits.jogDeceleration", [](MotionLimits& l) { l.jogDeceleration = 0; }},
                 {"limits.jointAcceleration", [](MotionLimits& l) { l.jointAcceleration = 120; }}}) {
            MotionLimits limits;
            set(limits);
            Cell cell({}, RegisterRange::Upper, limits);
            const auto taken = cell.takeControl();
            QVERIFY2(!taken && taken.error().controllerMessage.contains(QLatin1String(name)),
                     qPrintable(taken.error().toString()));
        }
        MotionLimits none;
        none.tcpSpeed = none.tcpRotationSpeed = none.jointSpeed = kNoCap;
        Cell cell({}, RegisterRange::Upper, none);
        QVERIFY(cell.takeControl().ok());
        const auto move = cell.motions().moveJ(turned(cell.robot.truth().q, 0, 0.5), {.speed = 3});
        QVERIFY2(move.ok(), qPrintable(move.error().toString()));
        QCOMPARE(move->plan()->limiter.kind, LimiterKind::None);
    }

    // The robot and this computer receive no data from each other for a limited time.
    void aFreeMoveSurvivesAnOutageWithinItsTimeout_data() {
        QTest::addColumn<int>("heartbeatTimeoutMs");
        QTest::addColumn<Holding>("holding");
        QTest::addColumn<int>("gapMs");
        QTest::addColumn<bool>("survives");
        QTest::addColumn<bool>("keepsControl");
        // If data are missing for longer than ControllerOptions::connectionTimeout and the heartbeat timeout
        // of the move, the connection counts as lost.
        const auto timeoutMs = static_cast<int>(ControllerOptions().connectionTimeout.count());
        QTest::newRow("usual") << 100 << Holding::Free << 400 << false << true;
        QTest::newRow("longer") << 800 << Holding::Free << 600 << true << true;
        // The next package arrives 2 ms later, exactly at the timeout.
        QTest::newRow("too long, at the timeout") << 110 << Holding::Free << timeoutMs - 2 << false << true;
        QTest::newRow("too long, above the timeout")
            << 110 << Holding::Free << timeoutMs + 2 << false << false;
        QTest::newRow("longer, at its limit") << 800 << Holding::Free << 798 << true << true;
        QTest::newRow("longer, above its limit") << 800 << Holding::Free << 802 << false << false;
        QTest::newRow("held") << 800 << Holding::Held << 400 << false << true;
    }
    void aFreeMoveSurvivesAnOutageWithinItsTimeout() {
        QFETCH(int, heartbeatTimeoutMs);
        QFETCH(Holding, holding);
        QFETCH(int, gapMs);
        QFETCH(bool, survives);
        QFETCH(bool, keepsControl);
        Cell cell;
        QVERIFY(cell.takeControl().ok());
        const JointPositions target = turned(cell.robot.truth().q, 0, 40 * kDeg);
        const auto move =
            cell.motions().moveJ(target, {0.5, 1.4, holding, std::chrono::milliseconds(heartbeatTimeoutMs)});
        QVERIFY2(move.ok(), qPrintable(move.error().toString()));
        for (int t = 0; t < 400; t += 20) {
            QVERIFY(move->refresh());
            QVERIFY(cell.stepMs(20));
        }
        cell.robot.silence(true);
        cell.stepAlone(gapMs / 2);
        if (!keepsControl) {
            QTRY_VERIFY_WITH_TIMEOUT(!cell.controller->isConnected(), 60000);
            QCOMPARE(cell.controller->status().loss, ControlLoss::LinkLost);
            QCOMPARE(move->wait(Deadline::after(std::chrono::seconds(60))).error().code, ErrorCode::LinkLost);
            QCOMPARE(cell.motions().moveJ(target).error().code, ErrorCode::NotInControl);
            cell.stepAlone(500);
            QVERIFY(cell.isStanding());
            QVERIFY(distance(cell.robot.truth().q, target) > 1e-3);
            return;
        }
        QTest::qWait(100);  // the control thread polls every 4 ms and gives up after ten polls
        QVERIFY(cell.controller->isConnected());
        QCOMPARE(!cell.isStanding(), survives);
        cell.robot.silence(false);
        QVERIFY(cell.stepMs(2000));
        QVERIFY(cell.controller->status().inControl);
        QCOMPARE(move->state().cause == StopCause::Completed, survives);
        QCOMPARE(distance(cell.robot.truth().q, target) < 1e-3, survives);
        QVERIFY(cell.isStanding());
    }

    void anOutOfRangeHeartbeatTimeoutIsRefused() {
        Cell cell;
        QVERIFY(cell.takeControl().ok());
        for (const int ms : {0, 50, 4001, 60'000}) {
            const Error error =
                cell.motions()
                    .moveJ(cell.robot.truth().q, {.heartbeatTimeout = std::chrono::milliseconds(ms)})
                    .error();
            QCOMPARE(error.code, ErrorCode::LimitExceeded);
            QVERIFY(error.controllerMessage.contains(QStringLiteral("heartbeatTimeout")));
        }
    }

    void endlessMotionsAreHeldByDefault() {
        Cell cell;
        QVERIFY(cell.takeControl().ok());
        const auto held = cell.motions().startJog(linearJog(0, 0, 0.02));
        QVERIFY(cell.stepMs(104));
        QCOMPARE(held->state().cause, StopCause::EventLoopStalled);
        const auto contact = cell.during([&] {
            return cell.motions().moveUntilContact({{0, 0, 0.02}, {0, 0, 0}},
                                                   Deadline::after(std::chrono::seconds(20)));
        });
        QVERIFY2(contact.ok(), qPrintable(contact.error().toString()));
        QVERIFY(cell.stepMs(104));
        QCOMPARE(contact->state().cause, StopCause::EventLoopStalled);
        QVERIFY(cell.ticksToStandstill(1000) >= 0);

        const auto free = cell.motions().startJog(linearJog(0, 0, 0.02), Holding::Free);
        QVERIFY(cell.stepMs(400));
        QVERIFY(free->isActive());
        QVERIFY(!cell.isStanding());
        cell.robot.silence(true);  // the robot must also stop without this computer
        cell.stepAlone(125);
        QVERIFY(cell.isStanding());
    }

    void releasingAHeldMoveStopsItBeforeItsTarget() {
        Cell cell;
        QVERIFY(cell.takeControl().ok());
        const JointPositions start = cell.robot.truth().q;
        const auto move = cell.motions().moveJ(turned(start, 0, 60 * kDeg), {0.5, 1.4, Holding::Held});
        QVERIFY(cell.holdMove(*move, 800) == false);
        QVERIFY(move->cancel(StopCause::Released));
        QVERIFY(cell.standsWithinMs(200));
        QVERIFY(cell.stepMs(100));
        const double way = distance(cell.robot.truth().q, start);
        QVERIFY(way > 5 * kDeg && way < 40 * kDeg);
        QCOMPARE(cell.controller->status().lastStop.cause, StopCause::Released);
        QVERIFY(!move->refresh());
        const JointPositions standing = cell.robot.truth().q;
        QVERIFY(cell.stepMs(500));
        QVERIFY(distance(cell.robot.truth().q, standing) < 1e-4);
    }

    void aHeldMoveEndsWithoutRefresh() {
        Cell cell;
        QVERIFY(cell.takeControl().ok());
        const auto move =
            cell.motions().moveJ(turned(cell.robot.truth().q, 0, 60 * kDeg), {0.5, 1.4, Holding::Held});
        QVERIFY(cell.stepMs(104));
        QCOMPARE(move->state().cause, StopCause::EventLoopStalled);
        QVERIFY(cell.ticksToStandstill(500) >= 0);
    }

    // A motion that was prepared before a stop, or that follows another motion, must not start after the
    // stop.
    void noPreparedMotionStartsAfterALaterStop() {
        Cell cell;
        QVERIFY(cell.takeControl().ok());
        const JointPositions start = cell.robot.truth().q;
        const std::uint64_t stops = cell.controller->stops();
        Motions armed(*cell.controller, stops);
        const auto first = armed.moveJ(turned(start, 0, 3 * kDeg), {0.5, 1.4, Holding::Held});
        QVERIFY(first.ok());
        QVERIFY(cell.holdMove(*first, 2000));
        QCOMPARE(first->state().cause, StopCause::Completed);
        QCOMPARE(cell.controller->stops(), stops);
        const auto second = armed.moveJ(start, {0.5, 1.4, Holding::Held});
        QVERIFY2(second.ok(), "the end of the first motion counts as a stop");
        QVERIFY(second->cancel(StopCause::Released));
        QVERIFY(cell.standsWithinMs(200));
        cell.controller->stop(StopCause::Space);
        QCOMPARE(armed.moveJ(start, {0.5, 1.4, Holding::Held}).error().code, ErrorCode::Stopped);
        QCOMPARE(armed.moveL(cell.tcp(), {0.1, 1.0, Holding::Held}).error().code, ErrorCode::Stopped);
        QCOMPARE(armed.startJog({.twist = {{0, 0, 0.1}, {0, 0, 0}}}).error().code, ErrorCode::Stopped);
        QVERIFY2(cell.motions().moveJ(start, {0.5, 1.4, Holding::Held}).ok(),
                 "a new motion after the stop was refused");
    }

    static MotionPath slowPath(const Cell& cell) {
        const JointPositions start = cell.robot.truth().q;
        return {{PathEntry::Kind::MoveJ, turned(start, 0, 20 * kDeg), {}, 0.3, 1.4, 0.01},
                {PathEntry::Kind::MoveJ, turned(start, 0, 60 * kDeg), {}, 0.3, 1.4, 0}};
    }
    static Deadline soon() { return Deadline::after(std::chrono::seconds(20)); }

    void aPreparedPathMovesNothingUntilItIsStarted() {
        Cell cell;
        QVERIFY(cell.takeControl().ok());
        const JointPositions start = cell.robot.truth().q;
        const auto path = cell.during([&] { return cell.motions().preparePath(slowPath(cell), soon()); });
        QVERIFY(path.ok());
        QVERIFY(cell.controller->status().inControl);
        QVERIFY(cell.stepMs(500));
        QVERIFY(distance(cell.robot.truth().q, start) < 1e-4);
        const auto motion = cell.motions().startPath(*path, Holding::Held);
        QVERIFY(motion.ok());
        QVERIFY(cell.holdMove(*motion, 10'000));
        QCOMPARE(motion->state().cause, StopCause::Completed);
        QVERIFY(distance(cell.robot.truth().q, turned(start, 0, 60 * kDeg)) < 1e-3);
        QCOMPARE(cell.motions().startPath(*path, Holding::Held).error().code, ErrorCode::Stopped);
    }

    void aStopOrAnotherMotionInvalidatesAPreparedPath() {
        Cell cell;
        QVERIFY(cell.takeControl().ok());
        const JointPositions start = cell.robot.truth().q;
        QCOMPARE(cell.motions().startPath({}, Holding::Held).error().code, ErrorCode::Stopped);
        const auto prepare = [&] {
            return cell.during([&] { return cell.motions().preparePath(slowPath(cell), soon()); });
        };
        const auto stopped = prepare();
        QVERIFY(stopped.ok());
        cell.controller->stop(StopCause::Escape);
        QCOMPARE(cell.motions().startPath(*stopped, Holding::Held).error().code, ErrorCode::Stopped);
        const auto superseded = prepare();
        QVERIFY(superseded.ok());
        const auto move = cell.motions().moveJ(start, {0.5, 1.4, Holding::Held});
        QVERIFY(cell.holdMove(*move, 500));
        QCOMPARE(cell.motions().startPath(*superseded, Holding::Held).error().code, ErrorCode::Stopped);
        // A stop before the path has been sent also takes effect.
        Motions armed(*cell.controller, cell.controller->stops());
        cell.controller->stop(StopCause::Released);
        const auto late = cell.during([&] { return armed.preparePath(slowPath(cell), soon()); });
        QCOMPARE(late.error().code, ErrorCode::Stopped);
        QVERIFY(cell.stepMs(300));
        QVERIFY(distance(cell.robot.truth().q, start) < 1e-3);
    }

    void aHeldPathEndsWithoutRefresh() {
        Cell cell;
        QVERIFY(cell.takeControl().ok());
        const auto path = cell.during([&] { return cell.motions().preparePath(slowPath(cell), soon()); });
        const auto motion = cell.motions().startPath(*path, Holding::Held);
        QVERIFY(!cell.holdMove(*motion, 600));
        QVERIFY(!cell.isStanding());
        QVERIFY(cell.stepMs(104));
        QCOMPARE(motion->state().cause, StopCause::EventLoopStalled);
        QVERIFY(cell.ticksToStandstill(200) >= 0);
        const JointPositions stands = cell.robot.truth().q;
        QVERIFY(cell.stepMs(500));
        QVERIFY(distance(cell.robot.truth().q, stands) < 1e-4);
    }

    void theLastMoveWins() {
        Cell cell;
        QVERIFY(cell.takeControl().ok());
        const JointPositions start = cell.robot.truth().q;
        const auto first = cell.motions().moveJ(turned(start, 0, 60 * kDeg), {0.5, 1.4, Holding::Free});
        QVERIFY(cell.stepMs(600));
        const auto second = cell.motions().moveJ(start, {0.5, 1.4, Holding::Free});
        QCOMPARE(first->state().cause, StopCause::Superseded);
        QVERIFY(cell.stepMs(4000));
        QCOMPARE(second->state().cause, StopCause::Completed);
        QVERIFY(distance(cell.robot.truth().q, start) < 1e-3);
    }

    void aMoveToTheCurrentPositionCompletesImmediately() {
        Cell cell;
        QVERIFY(cell.takeControl().ok());
        const auto move = cell.motions().moveJ(cell.robot.truth().q, {0.5, 1.4, Holding::Held});
        QVERIFY(cell.holdMove(*move, 300));
        QCOMPARE(move->state().cause, StopCause::Completed);
    }

    void impossibleTargetsAreRefusedBeforeAnythingMoves() {
        Cell cell;
        QVERIFY(cell.takeControl().ok());
        const JointPositions here = cell.robot.truth().q;
        Motions motions = cell.motions();
        QCOMPARE(motions.moveJ(turned(here, 2, 20), {0.5, 1.4}).error().code, ErrorCode::LimitExceeded);
        QVERIFY(motions.moveJ(turned(here, 2, 20), {0.5, 1.4})
                    .error()
                    .controllerMessage.contains(QStringLiteral("Elbow")));
        QCOMPARE(motions.moveJ(here, {100, 1.4}).error().code, ErrorCode::LimitExceeded);
        QCOMPARE(motions.moveJ(here, {0, 1.4}).error().code, ErrorCode::InvalidArgument);
        QCOMPARE(motions.moveJ(turned(here, 1, std::nan("")), {0.5, 1.4}).error().code,
                 ErrorCode::InvalidArgument);
        QCOMPARE(motions.moveL(cell.tcp(), {0.5, 1.0}).error().code, ErrorCode::LimitExceeded);
        QCOMPARE(motions.moveL(cell.tcp(), {0.1, -1}).error().code, ErrorCode::InvalidArgument);
        JogTarget target = linearJog(0.1, 0, 0);
        target.twist.angular.y() = std::nan("");
        QCOMPARE(motions.startJog(target).error().code, ErrorCode::InvalidArgument);
        QVERIFY(cell.stepMs(100));
        QVERIFY(cell.isStanding());
    }

    void aSilentLinkAlsoEndsAMove() {
        Cell cell;
        QVERIFY(cell.takeControl().ok());
        const auto move =
            cell.motions().moveJ(turned(cell.robot.truth().q, 0, 90 * kDeg), {0.5, 1.4, Holding::Free});
        QVERIFY(cell.stepMs(700));
        QVERIFY(!cell.isStanding());
        cell.robot.silence(true);
        int ticks = 0;
        while (!cell.isStanding()) {
            cell.stepAlone();
            QVERIFY(++ticks * 2 <= 250);
        }
        QTRY_COMPARE_WITH_TIMEOUT(move->state().cause, StopCause::DataStale, 60'000);
        const Error error = move->wait(Deadline::after(std::chrono::seconds(60))).error();
        QCOMPARE(error.code, ErrorCode::LinkLost);
        const QRegularExpression measured(QStringLiteral(
            "^no data from the robot for [1-9]\\d\\d ms \\(limit 100 ms\\): .*heartbeat timeout"));
        QVERIFY2(measured.match(error.controllerMessage).hasMatch(), qPrintable(error.controllerMessage));
    }

    void releasingEndsTheProgramAndControlCanBeTakenAgain() {
        Cell cell;
        for (int round = 0; round < 3; ++round) {
            QVERIFY(cell.takeControl().ok());
            QCOMPARE(cell.robot.truth().runtimeState, RuntimeState::Playing);
            const auto jog = cell.motions().startJog(linearJog(0, 0, 0.02));
            QVERIFY(cell.hold(*jog, 100));
            cell.release();
            QCOMPARE(cell.controller->status().loss, ControlLoss::Released);
            QVERIFY(!jog->refresh());
            QVERIFY(cell.programEnds());
            QCOMPARE(cell.motions().startJog(linearJog(0, 0, 0.02)).error().code, ErrorCode::NotInControl);
            QTRY_COMPARE_WITH_TIMEOUT(cell.robot.rtdeClients(), 0, 60'000);
        }
    }

    void takingControlTwiceChangesNothing() {
        Cell cell;
        QVERIFY(cell.takeControl().ok());
        const auto jog = cell.motions().startJog(linearJog(0, 0, 0.02));
        QVERIFY(cell.controller->takeControl(Deadline::after(std::chrono::minutes(1))).ok());
        QVERIFY(cell.hold(*jog, 100));
    }

    void anotherProgramTakesOverTheArm() {
        Cell cell;
        QVERIFY(cell.takeControl().ok());
        const auto jog = cell.motions().startJog(linearJog(0, 0, 0.05));
        QVERIFY(cell.hold(*jog, 200));
        script::ScriptClient other(cell.robot.listenAddress(), cell.robot.ports().secondary);
        QVERIFY(other.connect(Deadline::after(std::chrono::minutes(1))).ok());
        QVERIFY(other
                    .send(QStringLiteral("def other():\n  sleep(60)\nend\n"),
                          Deadline::after(std::chrono::minutes(1)))
                    .ok());
        bool alive = true;
        for (int i = 0; i < 5000 && alive; ++i) {
            QVERIFY(cell.step());
            alive = jog->refresh();
        }
        QVERIFY(!alive);
        QCOMPARE(jog->state().cause, StopCause::ControlLost);
        QVERIFY(cell.stepMs(700));
        QVERIFY(cell.isStanding());
        QVERIFY(!cell.controller->status().inControl);
        QVERIFY(cell.takeControl().ok());
    }

    void theLowerRegistersWorkToo() {
        Cell cell({}, RegisterRange::Lower);
        QVERIFY(cell.takeControl().ok());
        const auto jog = cell.motions().startJog(jointJog(5, 0.2));
        QVERIFY(cell.hold(*jog, 300));
        QVERIFY(!cell.isStanding());
    }

    void anOldControllerAt125HzWorksToo() {
        Cell cell(
            [](simulator::SimulatorOptions& options) {
                options.model = RobotModelId::UR5;
                options.software = {3, 15, 8, 106339};
            },
            RegisterRange::Lower);
        const auto taken = cell.takeControl();
        QVERIFY2(taken.ok(), qPrintable(taken.error().toString()));
        const auto jog = cell.motions().startJog(jointJog(5, 0.2));
        QVERIFY(jog.ok());
        for (int i = 0; i < 50; ++i) {
            QVERIFY(jog->refresh());
            QVERIFY(cell.step());
        }
        QVERIFY(std::abs(cell.robot.truth().qd[5] - 0.2) < 0.01);
        QVERIFY(jog->cancel(StopCause::Released));
        int ticks = 0;
        while (!cell.isStanding()) {
            QVERIFY(cell.step());
            QVERIFY(++ticks * 8 <= 120);
        }
    }
};

QTEST_GUILESS_MAIN(TestMoves)
#include "tst_moves.moc"
