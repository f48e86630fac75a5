// SPDX-License-Identifier: MIT
// Bounded motions, and everything around being in control, in virtual time.
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
        const auto move = cell.controller->moveJ(target, {0.5, 1.4, Holding::Held});
        QVERIFY(move.ok());
        QVERIFY(cell.holdMove(*move, 5000));
        QCOMPARE(cell.controller->motionState(*move).cause, StopCause::Completed);
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
            const simulator::Truth truth = cell.robot.truth();
            const Eigen::Vector3d now = kinematics::linkFrames(dh, truth.q)[2].translation();
            fastest = std::max(fastest, truth.tcpSpeed.linear.norm());
            if (elbow) {
                fastest = std::max(fastest, (now - *elbow).norm() / 0.002);
            }
            elbow = now;
        };
        const JointPositions stretched(0, -20 * kDeg, 30 * kDeg, -90 * kDeg, -90 * kDeg, 0);
        const auto there = cell.controller->moveJ(stretched, {3.0, 10.0, Holding::Free});
        QVERIFY(there.ok());
        QVERIFY(cell.stepMs(15'000));
        QCOMPARE(cell.controller->motionState(*there).cause, StopCause::Completed);
        if (linear) {
            Pose in = cell.tcp();
            in.position.head<2>() *= 0.75;
            const auto back = cell.controller->moveL(in, {cap, 2.0, Holding::Free});
            QVERIFY(back.ok());
            QVERIFY(cell.stepMs(6000));
            QCOMPARE(cell.controller->motionState(*back).cause, StopCause::Completed);
        }
        QVERIFY2(fastest < cap * 1.02, qPrintable(QString::number(fastest)));
        QVERIFY2(fastest > cap * 0.5, "it was not slowed down more than needed");
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
        const auto move = cell.controller->moveL(target, {0.1, 0.5, Holding::Held});
        QVERIFY(move.ok());
        QVERIFY(cell.holdMove(*move, 5000));
        QCOMPARE(cell.controller->motionState(*move).cause, StopCause::Completed);
        QVERIFY((cell.tcp().position - target.position).norm() < 0.0005);
        QVERIFY(aside < 0.0005);
    }

    void aFreeMoveNeedsNoHolder() {
        Cell cell;
        QVERIFY(cell.takeControl().ok());
        const JointPositions target = turned(cell.robot.truth().q, 0, 15 * kDeg);
        const auto move = cell.controller->moveJ(target, {0.5, 1.4, Holding::Free});
        QVERIFY(move.ok());
        QVERIFY(cell.stepMs(2000));
        QCOMPARE(cell.controller->motionState(*move).cause, StopCause::Completed);
        QVERIFY(distance(cell.robot.truth().q, target) < 1e-3);
    }

    void lettingGoOfAHeldMoveStopsItShortOfItsTarget() {
        Cell cell;
        QVERIFY(cell.takeControl().ok());
        const JointPositions start = cell.robot.truth().q;
        const auto move = cell.controller->moveJ(turned(start, 0, 60 * kDeg), {0.5, 1.4, Holding::Held});
        QVERIFY(cell.holdMove(*move, 800) == false);
        QVERIFY(cell.controller->end(*move, StopCause::Released));
        QVERIFY(cell.standsWithinMs(200));
        QVERIFY(cell.stepMs(100));
        const double way = distance(cell.robot.truth().q, start);
        QVERIFY(way > 5 * kDeg && way < 40 * kDeg);
        QCOMPARE(cell.controller->status().lastStop.cause, StopCause::Released);
        QVERIFY(!cell.controller->refreshMove(*move));
        const JointPositions standing = cell.robot.truth().q;
        QVERIFY(cell.stepMs(500));
        QVERIFY(distance(cell.robot.truth().q, standing) < 1e-4);
    }

    void aHeldMoveWithoutItsHolderEnds() {
        Cell cell;
        QVERIFY(cell.takeControl().ok());
        const auto move =
            cell.controller->moveJ(turned(cell.robot.truth().q, 0, 60 * kDeg), {0.5, 1.4, Holding::Held});
        QVERIFY(cell.stepMs(104));
        QCOMPARE(cell.controller->motionState(*move).cause, StopCause::EventLoopStalled);
        QVERIFY(cell.ticksToStandstill(500) >= 0);
    }

    void theLastMoveWins() {
        Cell cell;
        QVERIFY(cell.takeControl().ok());
        const JointPositions start = cell.robot.truth().q;
        const auto first = cell.controller->moveJ(turned(start, 0, 60 * kDeg), {0.5, 1.4, Holding::Free});
        QVERIFY(cell.stepMs(600));
        const auto second = cell.controller->moveJ(start, {0.5, 1.4, Holding::Free});
        QCOMPARE(cell.controller->motionState(*first).cause, StopCause::Superseded);
        QVERIFY(cell.stepMs(4000));
        QCOMPARE(cell.controller->motionState(*second).cause, StopCause::Completed);
        QVERIFY(distance(cell.robot.truth().q, start) < 1e-3);
    }

    void aMoveToWhereTheArmStandsIsDoneAtOnce() {
        Cell cell;
        QVERIFY(cell.takeControl().ok());
        const auto move = cell.controller->moveJ(cell.robot.truth().q, {0.5, 1.4, Holding::Held});
        QVERIFY(cell.holdMove(*move, 300));
        QCOMPARE(cell.controller->motionState(*move).cause, StopCause::Completed);
    }

    void impossibleTargetsAreRefusedBeforeAnythingMoves() {
        Cell cell;
        QVERIFY(cell.takeControl().ok());
        const JointPositions here = cell.robot.truth().q;
        const auto& controller = cell.controller;
        QCOMPARE(controller->moveJ(turned(here, 2, 20), {0.5, 1.4}).error().code, ErrorCode::LimitExceeded);
        QVERIFY(controller->moveJ(turned(here, 2, 20), {0.5, 1.4})
                    .error()
                    .controllerMessage.contains(QStringLiteral("Elbow")));
        QCOMPARE(controller->moveJ(here, {100, 1.4}).error().code, ErrorCode::LimitExceeded);
        QCOMPARE(controller->moveJ(here, {0, 1.4}).error().code, ErrorCode::InvalidArgument);
        QCOMPARE(controller->moveJ(turned(here, 1, std::nan("")), {0.5, 1.4}).error().code,
                 ErrorCode::InvalidArgument);
        QCOMPARE(controller->moveL(cell.tcp(), {0.5, 1.0}).error().code, ErrorCode::LimitExceeded);
        QCOMPARE(controller->moveL(cell.tcp(), {0.1, -1}).error().code, ErrorCode::InvalidArgument);
        JogTarget target = linearJog(0.1, 0, 0);
        target.twist.angular.y() = std::nan("");
        QCOMPARE(controller->startJog(target).error().code, ErrorCode::InvalidArgument);
        QVERIFY(cell.stepMs(100));
        QVERIFY(cell.isStanding());
    }

    void aLinkGoneSilentEndsAMoveToo() {
        Cell cell;
        QVERIFY(cell.takeControl().ok());
        const auto move =
            cell.controller->moveJ(turned(cell.robot.truth().q, 0, 90 * kDeg), {0.5, 1.4, Holding::Free});
        QVERIFY(cell.stepMs(700));
        QVERIFY(!cell.isStanding());
        cell.robot.silence(true);
        int ticks = 0;
        while (!cell.isStanding()) {
            cell.stepAlone();
            QVERIFY(++ticks * 2 <= 250);
        }
        QTRY_COMPARE(cell.controller->motionState(*move).cause, StopCause::DataStale);
    }

    void releasingEndsTheProgramAndControlCanBeTakenAgain() {
        Cell cell;
        for (int round = 0; round < 3; ++round) {
            QVERIFY(cell.takeControl().ok());
            QCOMPARE(cell.robot.truth().runtimeState, RuntimeState::Playing);
            const auto jog = cell.controller->startJog(linearJog(0, 0, 0.02));
            QVERIFY(cell.hold(*jog, 100));
            cell.release();
            QCOMPARE(cell.controller->status().loss, ControlLoss::Released);
            QVERIFY(!cell.controller->refreshJog(*jog));
            QVERIFY(cell.programEnds());
            QCOMPARE(cell.controller->startJog(linearJog(0, 0, 0.02)).error().code, ErrorCode::NotInControl);
            QTRY_COMPARE(cell.robot.rtdeClients(), 0);
        }
    }

    void takingControlTwiceChangesNothing() {
        Cell cell;
        QVERIFY(cell.takeControl().ok());
        const auto jog = cell.controller->startJog(linearJog(0, 0, 0.02));
        QVERIFY(cell.controller->takeControl(Deadline::after(std::chrono::seconds(1))).ok());
        QVERIFY(cell.hold(*jog, 100));
    }

    void anotherProgramTakesTheArmAway() {
        Cell cell;
        QVERIFY(cell.takeControl().ok());
        const auto jog = cell.controller->startJog(linearJog(0, 0, 0.05));
        QVERIFY(cell.hold(*jog, 200));
        script::ScriptClient other(cell.robot.listenAddress(), cell.robot.ports().secondary);
        QVERIFY(other.connect(Deadline::after(std::chrono::seconds(10))).ok());
        QVERIFY(other
                    .send(QStringLiteral("def other():\n  sleep(60)\nend\n"),
                          Deadline::after(std::chrono::seconds(10)))
                    .ok());
        bool alive = true;
        for (int i = 0; i < 5000 && alive; ++i) {
            QVERIFY(cell.step());
            alive = cell.controller->refreshJog(*jog);
        }
        QVERIFY(!alive);
        QCOMPARE(cell.controller->motionState(*jog).cause, StopCause::ControlLost);
        QVERIFY(cell.stepMs(700));
        QVERIFY(cell.isStanding());
        QVERIFY(!cell.controller->status().inControl);
        QVERIFY(cell.takeControl().ok());
    }

    void theLowerRegistersWorkToo() {
        Cell cell({}, RegisterRange::Lower);
        QVERIFY(cell.takeControl().ok());
        const auto jog = cell.controller->startJog(jointJog(5, 0.2));
        QVERIFY(cell.hold(*jog, 300));
        QVERIFY(!cell.isStanding());
    }

    void anOldControllerAt125HzWorksToo() {
        Cell cell(
            [](simulator::ControllerOptions& options) {
                options.model = RobotModelId::UR5;
                options.software = {3, 15, 8, 106339};
            },
            RegisterRange::Lower);
        const auto taken = cell.takeControl();
        QVERIFY2(taken.ok(), qPrintable(taken.error().toString()));
        const auto jog = cell.controller->startJog(jointJog(5, 0.2));
        QVERIFY(jog.ok());
        for (int i = 0; i < 50; ++i) {
            QVERIFY(cell.controller->refreshJog(*jog));
            QVERIFY(cell.step());
        }
        QVERIFY(std::abs(cell.robot.truth().qd[5] - 0.2) < 0.01);
        QVERIFY(cell.controller->end(*jog, StopCause::Released));
        int ticks = 0;
        while (!cell.isStanding()) {
            QVERIFY(cell.step());
            QVERIFY(++ticks * 8 <= 120);
        }
    }
};

QTEST_GUILESS_MAIN(TestMoves)
#include "tst_moves.moc"
