// SPDX-License-Identifier: MIT
// Moves with a handle, paths, functions, queries and settings, with the simulated robot over sockets.
#include <cmath>

#include "robot/control/arm_queries.h"
#include "robot/control/compliance.h"
#include "robot/control/detail/registers.h"
#include "robot/control/motions.h"
#include "robot/control/output_pulses.h"
#include "robot/control/programs.h"
#include "robot/control/tool_setup.h"
#include "robot/core/wait_until.h"
#include "robot/kinematics/arm_kinematics.h"
#include "robot/script/script_client.h"
#include "tests/integration/control/cell.h"
#include "tests/support/waiting.h"

using namespace tiller;
using namespace tiller::control;
using namespace tiller::test;
using std::chrono::milliseconds;

namespace {

double apart(const JointPositions& a, const JointPositions& b) {
    return (a.values - b.values).cwiseAbs().maxCoeff();
}

Pose moved(Pose pose, double x, double y, double z) {
    pose.position += Eigen::Vector3d(x, y, z);
    return pose;
}

}  // namespace

class TestCommands : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void waitingForAMoveReportsItsProgress() {
        Cell cell;
        QVERIFY(cell.takeControl().ok());
        JointPositions target = cell.robot.truth().q;
        target[0] += 20 * kDeg;
        const auto move = Motions(*cell.controller).moveJ(target, {0.5, 1.4, Holding::Free});
        QVERIFY2(move.ok(), why(move));
        double last = 0;
        bool rises = true;
        cell.everyTick = [&] {
            const double now = move->progress().fraction;
            rises = rises && now >= last - 1e-3;
            last = now;
        };
        const auto ended = cell.during([&] { return move->wait(testTimeout()); });
        QVERIFY2(ended.ok(), why(ended));
        QVERIFY(rises);
        QCOMPARE(move->progress().fraction, 1.0);
        QVERIFY(apart(cell.robot.truth().q, target) < 1e-3);
        QVERIFY(!move->cancel());
    }

    // During a protective stop, the control program cannot be sent again. The state must not indicate that
    // control is still being taken.
    void aProtectiveStopDuringAScriptEndsTakingControl() {
        Cell cell;
        QVERIFY(cell.takeControl().ok());
        int ticks = 0;
        cell.everyTick = [&] {
            if (++ticks == 300) {
                QVERIFY(cell.robot.inject("protective-stop").ok());
            }
        };
        const auto ran = cell.during([&] {
            return Programs(*cell.controller).runScript("def long():\n  sleep(60)\nend\n", Deadline::never());
        });
        QVERIFY(!ran.ok());
        QCOMPARE(cell.robot.truth().safetyMode, SafetyMode::ProtectiveStop);
        QVERIFY(cell.during([&] {
            return waitUntil(Deadline::after(std::chrono::minutes(1)),
                             [&] { return cell.controller->status().loss == ControlLoss::ScriptStopped; });
        }));
    }

    // The library must not stop the other client's program, and the error must name the cause.
    void aProgramThatReplacesAScriptKeepsRunning_data() {
        QTest::addColumn<QString>("then");
        QTest::addColumn<RuntimeState>("expected");
        QTest::newRow("running") << QString() << RuntimeState::Playing;
        QTest::newRow("paused") << QStringLiteral("pause program\n") << RuntimeState::Paused;
    }
    void aProgramThatReplacesAScriptKeepsRunning() {
        QFETCH(const QString, then);
        QFETCH(const RuntimeState, expected);
        Cell cell;
        QVERIFY(cell.takeControl().ok());
        int ticks = 0;
        script::ScriptClient other(cell.robot.listenAddress(), cell.robot.ports().primary);
        cell.everyTick = [&] {
            if (++ticks == 300) {
                QVERIFY(other.connect(Deadline::never()).ok());
                QVERIFY(other
                            .send("def other():\n  while True:\n    set_digital_out(3, True)\n    sync()\n  "
                                  "end\nend\n",
                                  Deadline::never())
                            .ok());
            }
            if (ticks == 320 && !then.isEmpty()) {
                QVERIFY(other.send(then, Deadline::never()).ok());
            }
        };
        const auto ran = cell.during([&] {
            return Programs(*cell.controller).runScript("def long():\n  sleep(60)\nend\n", Deadline::never());
        });
        QCOMPARE(ran.error().code, ErrorCode::NotInControl);
        QVERIFY2(ran.error().controllerMessage.contains("another client"), why(ran));
        QVERIFY(cell.during([&] {
            return waitUntil(Deadline::after(std::chrono::minutes(1)),
                             [&] { return cell.controller->status().loss == ControlLoss::ScriptStopped; });
        }));
        QCOMPARE(cell.robot.truth().runtimeState, expected);
        QVERIFY((cell.robot.truth().digitalOutputs & 8U) != 0);
        QVERIFY(!cell.controller->status().inControl);
    }

    // The robot's messages name no program, and the data never report a stop.
    void aProgramThatReplacesAScriptWithoutANameIsRecognised() {
        Cell cell;
        QVERIFY(cell.takeControl().ok());
        int ticks = 0;
        script::ScriptClient other(cell.robot.listenAddress(), cell.robot.ports().primary);
        cell.everyTick = [&] {
            if (++ticks == 300) {
                QVERIFY(other.connect(Deadline::never()).ok());
                QVERIFY(other.send("def other():\n  while True:\n    sync()\n  end\nend\n", Deadline::never())
                            .ok());
            }
        };
        const auto ran = cell.during([&] {
            return Programs(*cell.controller)
                .runScript("sleep(600)\n", Deadline::after(std::chrono::seconds(20)),
                           Supervision::Unattended);
        });
        QCOMPARE(ran.error().code, ErrorCode::NotInControl);
        QVERIFY2(ran.error().controllerMessage.contains("another client"), why(ran));
        QCOMPARE(cell.robot.truth().runtimeState, RuntimeState::Playing);
    }

    // The secondary interface does not report the end of a program, only the data do.
    void aProgramThatFollowsAScriptKeepsRunning() {
        Cell cell;
        ControllerOptions options;
        options.host = cell.robot.listenAddress();
        options.primaryPort = cell.robot.ports().secondary;
        options.rtdePort = cell.robot.ports().rtde;
        options.clock = &cell.clock;
        options.priority = 0;
        cell.controller = std::make_unique<Controller>(options);
        QVERIFY(cell.takeControl().ok());
        int stopped = 0;
        bool wasPlaying = false;
        cell.everyTick = [&] {
            const bool plays = cell.robot.truth().runtimeState == RuntimeState::Playing;
            wasPlaying = wasPlaying || (plays && (cell.robot.truth().digitalOutputs & 16U) != 0);
            if (wasPlaying && !plays && ++stopped == 10) {
                // The controller waits in real time. It must observe the end before the next program starts.
                std::this_thread::sleep_for(std::chrono::milliseconds(100));
                script::ScriptClient other(cell.robot.listenAddress(), cell.robot.ports().primary);
                QVERIFY(other.connect(Deadline::never()).ok());
                QVERIFY(other.send("def other():\n  while True:\n    sync()\n  end\nend\n", Deadline::never())
                            .ok());
            }
        };
        const auto ran = cell.during([&] {
            return Programs(*cell.controller)
                .runScript("def short():\n  set_digital_out(4, True)\n  sleep(0.2)\nend\n",
                           Deadline::never());
        });
        QVERIFY(stopped >= 10);
        QCOMPARE(ran.error().code, ErrorCode::NotInControl);
        QVERIFY2(ran.error().controllerMessage.contains("another client"), why(ran));
        cell.everyTick = {};
        QVERIFY(cell.step(500));
        QCOMPARE(cell.robot.truth().runtimeState, RuntimeState::Playing);
        QVERIFY(!cell.controller->status().inControl);
    }

    // The robot receives the control program after the upload has been reported as failed.
    void aControlProgramThatStartsLateEnds() {
        Cell cell;
        bool fails = false;
        QString late;
        const auto send = [&](const QString& program) {
            script::ScriptClient client(cell.robot.listenAddress(), cell.robot.ports().primary);
            const auto connected = client.connect(testTimeout());
            return connected ? client.send(program, testTimeout()) : connected;
        };
        ControllerOptions options;
        options.host = cell.robot.listenAddress();
        options.primaryPort = cell.robot.ports().primary;
        options.rtdePort = cell.robot.ports().rtde;
        options.clock = &cell.clock;
        options.priority = 0;
        options.deliver = [&](const QString& program, const Deadline&) -> Result<void> {
            if (fails) {
                late = program;
                return Error{ErrorCode::Timeout, QStringLiteral("send the control program"), {}};
            }
            return send(program);
        };
        cell.controller = std::make_unique<Controller>(options);
        QVERIFY(cell.takeControl().ok());
        fails = true;
        const auto ran = cell.during([&] {
            return Programs(*cell.controller).runScript("def short():\n  sync()\nend\n", testTimeout());
        });
        QVERIFY(!ran.ok());
        QVERIFY(!late.isEmpty());
        QVERIFY(send(late).ok());
        int began = 0;
        cell.everyTick = [&] { began += cell.robot.truth().runtimeState == RuntimeState::Playing ? 1 : 0; };
        QVERIFY(cell.during([&] {
            return waitUntil(Deadline::after(std::chrono::minutes(1)), [&] {
                return began > 0 && cell.robot.truth().runtimeState == RuntimeState::Stopped;
            });
        }));
        QVERIFY(!cell.controller->status().inControl);
        QCOMPARE(cell.controller->status().loss, ControlLoss::ScriptStopped);
    }

    // A path is sent as a new control program. The previous program must end its pulses first.
    void aPulseIsNotShortenedByAPathOrAScript() {
        const Deadline limit = Deadline::never();
        Cell cell;
        QVERIFY(cell.takeControl().ok());
        double onFor = 0;
        cell.everyTick = [&] { onFor += (cell.robot.truth().digitalOutputs & 2U) != 0 ? 0.002 : 0; };
        OutputPulses pulses(*cell.controller);
        const auto pulse = [&](milliseconds time) {
            onFor = 0;
            const auto begun = cell.during([&] { return pulses.begin(2, 2, time, Holding::Held, limit); });
            QVERIFY2(begun.ok(), why(begun));
        };
        const PathEntry entry{PathEntry::Kind::MoveJ, cell.robot.truth().q, {}, 0.5, 1.4, 0};
        pulse(milliseconds(400));
        const auto path = cell.during([&] { return cell.motions().movePath({entry}, limit); });
        QVERIFY2(path.ok(), why(path));
        QVERIFY2(std::abs(onFor - 0.4) < 0.01, qPrintable(QString::number(onFor)));
        pulse(milliseconds(400));
        const auto script = cell.during(
            [&] { return Programs(*cell.controller).runScript("def quick():\n  sync()\nend\n", limit); });
        QVERIFY2(script.ok(), why(script));
        QVERIFY2(std::abs(onFor - 0.4) < 0.01, qPrintable(QString::number(onFor)));
        // If a pulse takes too long, the error names the pulse, and the pulse continues.
        pulse(milliseconds(600'000));  // long, because virtual time may advance faster than the deadline
        const auto late =
            cell.during([&] { return cell.motions().movePath({entry}, Deadline::after(milliseconds(200))); });
        QCOMPARE(late.error().code, ErrorCode::Timeout);
        QVERIFY2(
            late.error().controllerMessage.startsWith("the pulse of digital output 1 is active for another "),
            why(late));
        QVERIFY((cell.robot.truth().digitalOutputs & 2U) != 0);
        // After a pulse has ended, it does not block other commands.
        const auto ended = cell.during([&] { return pulses.end(2, limit); });
        QVERIFY2(ended.ok(), why(ended));
        const auto again = cell.during([&] { return cell.motions().movePath({entry}, limit); });
        QVERIFY2(again.ok(), why(again));
    }

    // At 2 % a move takes fifty times as long, and no wait may time out.
    void aWaitDoesNotTimeOutAtTwoPercent() {
        Cell cell;
        QVERIFY(cell.takeControl().ok());
        cell.robot.setSpeedSlider(0.02);
        JointPositions target = cell.robot.truth().q;
        target[5] += 3 * kDeg;
        const auto move = Motions(*cell.controller).moveJ(target, {0.5, 1.4, Holding::Free});
        const auto ended = cell.during([&] { return move->wait(Deadline::never()); });
        QVERIFY2(ended.ok(), why(ended));
        QVERIFY(apart(cell.robot.truth().q, target) < 1e-3);
        QVERIFY(std::abs(move->progress().speedFraction - 0.02) < 1e-6);
    }

    void movesToPosesAndAlongLinesToJoints() {
        Cell cell;
        QVERIFY(cell.takeControl().ok());
        Motions motions(*cell.controller);
        const Pose start = cell.tcp();
        const Pose there = moved(start, 0.05, 0.02, 0.04);
        const auto ik = motions.moveJToPose(there, {0.5, 1.4, Holding::Free});
        QVERIFY2(ik.ok(), why(ik));
        QVERIFY(cell.during([&] { return ik->wait(testTimeout()); }).ok());
        QVERIFY((cell.tcp().position - there.position).norm() < 1e-3);
        const JointPositions q = cell.robot.truth().q;
        const auto back = motions.moveL(start, {0.1, 0.5, Holding::Free});
        QVERIFY(cell.during([&] { return back->wait(testTimeout()); }).ok());
        const auto fk = motions.moveLToJoints(q, {0.1, 0.5, Holding::Free});
        QVERIFY2(fk.ok(), why(fk));
        QVERIFY(cell.during([&] { return fk->wait(testTimeout()); }).ok());
        QVERIFY((cell.tcp().position - there.position).norm() < 1e-3);
        QCOMPARE(motions.moveL(moved(start, 0, 0, 4), {0.1, 0.5}).error().code, ErrorCode::NoSolution);
        QCOMPARE(motions.moveJToPose(moved(start, 0, 0, 4), {0.1, 0.5}).error().code, ErrorCode::NoSolution);
    }

    void aPathOfEveryKindRunsToItsEnd() {
        Cell cell;
        QVERIFY(cell.takeControl().ok());
        const Pose start = cell.tcp();
        JointPositions turned = cell.robot.truth().q;
        turned[5] += 5 * kDeg;
        using Kind = PathEntry::Kind;
        const Pose end = moved(start, 0, 0, 0.06);
        const MotionPath path{
            {Kind::MoveJ, turned, {}, 0.5, 1.4, 0.005},
            {Kind::MoveL, moved(start, 0.04, 0, 0), {}, 0.1, 0.5, 0.01},
            {Kind::MoveP, moved(start, 0.04, 0, 0.04), {}, 0.1, 0.5, 0.005},
            {Kind::MoveC, end, moved(start, 0.03, 0, 0.06), 0.1, 0.5, 0.02},
        };
        const auto motion =
            cell.during([&] { return Motions(*cell.controller).movePath(path, testTimeout()); });
        QVERIFY2(motion.ok(), why(motion));
        int waypoint = 0;
        cell.everyTick = [&] { waypoint = std::max(waypoint, motion->progress().waypoint); };
        const auto ended = cell.during([&] { return motion->wait(testTimeout()); });
        QVERIFY2(ended.ok(), why(ended));
        QCOMPARE(waypoint, 4);
        QCOMPARE(motion->progress().waypoints, 4);
        QVERIFY((cell.tcp().position - end.position).norm() < 1e-3);
        // A move after the path must also work.
        const auto move = Motions(*cell.controller).moveL(start, {0.1, 0.5, Holding::Free});
        QVERIFY(cell.during([&] { return move->wait(testTimeout()); }).ok());
    }

    void aStopEndsAPath() {
        Cell cell;
        QVERIFY(cell.takeControl().ok());
        // The move is slow enough to be still active, even if the call returns late.
        const MotionPath path{{PathEntry::Kind::MoveL, moved(cell.tcp(), 0, 0, 0.2), {}, 0.01, 0.5, 0}};
        const auto motion =
            cell.during([&] { return Motions(*cell.controller).movePath(path, testTimeout()); });
        QVERIFY(motion.ok());
        QVERIFY(cell.stepMs(600));
        QVERIFY(!cell.isStanding());
        cell.controller->stop(StopCause::StopButton);
        QVERIFY(cell.ticksToStandstill(500) >= 0);
        QCOMPARE(motion->wait(testTimeout()).error().code, ErrorCode::Stopped);
        const Pose stands = cell.tcp();
        QVERIFY(cell.stepMs(300));
        QVERIFY((cell.tcp().position - stands.position).norm() < 1e-5);
    }

    void aFunctionRunsUnderTheControlProgram() {
        Cell cell;
        QVERIFY(cell.takeControl().ok());
        Programs programs(*cell.controller);
        const auto function = cell.during([&] {
            return programs.startFunction(
                QStringLiteral("paint"),
                QStringLiteral("speed = 3\nset_standard_digital_out(2, True)\nsleep(0.1)"), testTimeout());
        });
        QVERIFY2(function.ok(), why(function));
        QVERIFY(cell.during([&] { return function->wait(testTimeout()); }).ok());
        QVERIFY((cell.robot.truth().digitalOutputs & 4U) != 0);
        QVERIFY(cell.controller->status().inControl);
    }

    void compileErrorOfAFunctionIsReportedWithItsLine() {
        Cell cell;
        QVERIFY(cell.takeControl().ok());
        Programs programs(*cell.controller);
        const Error error =
            cell.during([&] {
                    return programs.startFunction(QStringLiteral("broken"),
                                                  QStringLiteral("a = 1\nb = = 2\nc = 3"), testTimeout());
                })
                .error();
        QCOMPARE(error.code, ErrorCode::ScriptError);
        QVERIFY2(error.controllerMessage.contains(QStringLiteral("broken line 2")),
                 qPrintable(error.toString()));
        QVERIFY(cell.controller->status().inControl);
    }

    void runtimeErrorOfAFunctionIsReportedWithItsLine() {
        Cell cell;
        QVERIFY(cell.takeControl().ok());
        Programs programs(*cell.controller);
        // The function fails only after the input is set, so it cannot fail before the call has returned.
        const auto function = cell.during([&] {
            return programs.startFunction(
                QStringLiteral("root"),
                QStringLiteral("while not get_standard_digital_in(0):\n  sync()\nend\nx = sqrt(-1)"),
                testTimeout());
        });
        QVERIFY2(function.ok(), why(function));
        cell.robot.setDigitalInput(0, true);
        const Error error = cell.during([&] { return function->wait(testTimeout()); }).error();
        QCOMPARE(error.code, ErrorCode::ScriptError);
        QVERIFY2(error.controllerMessage.contains(QStringLiteral("root line 4")),
                 qPrintable(error.toString()));
        QVERIFY(!cell.controller->status().inControl);
        const auto back = cell.during([&] { return programs.reupload(testTimeout()); });
        QVERIFY2(back.ok(), why(back));
        QVERIFY(cell.controller->status().inControl);
    }

    void wholeScriptRunsAndControlReturns() {
        Cell cell;
        QVERIFY(cell.takeControl().ok());
        Programs programs(*cell.controller);
        const auto ran = cell.during([&] {
            return programs.runScript(
                QStringLiteral("def mine():\n  set_standard_digital_out(1, True)\n  sleep(0.2)\nend\n"),
                testTimeout());
        });
        QVERIFY2(ran.ok(), why(ran));
        QVERIFY((cell.robot.truth().digitalOutputs & 2U) != 0);
        QVERIFY(cell.controller->status().inControl);
        const Error error =
            cell.during([&] {
                    return programs.runScript(QStringLiteral("def bad():\n  x = = 1\nend\n"), testTimeout());
                })
                .error();
        QCOMPARE(error.code, ErrorCode::ScriptError);
        QVERIFY2(error.controllerMessage.contains(QStringLiteral("line 2")), qPrintable(error.toString()));
        QVERIFY(cell.controller->status().inControl);
    }

    // Like the inserted watchdog thread, the script reports the missing heartbeat in output register 26
    // before it ends.
    void aScriptEndedByItsWatchdogIsNotCompleted() {
        Cell cell;
        QVERIFY(cell.takeControl().ok());
        Programs programs(*cell.controller);
        const QString script =
            QStringLiteral(
                "def cut():\n  sleep(0.1)\n  write_output_integer_register(26, %1)\n  sync()\nend\n")
                .arg(static_cast<int>(ScriptState::HeartbeatExpired));
        const auto ran = cell.during([&] { return programs.runScript(script, testTimeout()); });
        QCOMPARE(ran.error().code, ErrorCode::LinkLost);
        QVERIFY2(ran.error().controllerMessage.contains(QStringLiteral("heartbeat")),
                 qPrintable(ran.error().toString()));
        QVERIFY(cell.controller->status().inControl);
        QVERIFY(cell.during([&] { return programs.runScript(QStringLiteral("sleep(0.1)\n"), testTimeout()); })
                    .ok());
        // With regainsAfterDataGap = false, the controller does not take control again.
        ScriptTerms terms;
        terms.regainsAfterDataGap = false;
        const auto lost = cell.during([&] { return programs.runScript(script, testTimeout(), terms); });
        QCOMPARE(lost.error().code, ErrorCode::LinkLost);
        QVERIFY(!cell.controller->status().inControl);
        QVERIFY(cell.takeControl().ok());
    }

    void aScriptMustNotUseTheWatchdogsNames() {
        Cell cell;
        QVERIFY(cell.takeControl().ok());
        Programs programs(*cell.controller);
        const QString script = QStringLiteral("def f():\n  tiller_heartbeat_thread = 1\nend\n");
        QCOMPARE(programs.runScript(script, testTimeout()).error().code, ErrorCode::InvalidArgument);
        const auto ran =
            cell.during([&] { return programs.runScript(script, testTimeout(), Supervision::Unattended); });
        QVERIFY2(ran.ok(), why(ran));
    }

    void controlProgramEndsAndIsRestored() {
        Cell cell;
        QVERIFY(cell.takeControl().ok());
        Programs programs(*cell.controller);
        QVERIFY(programs.isProgramRunning());
        QVERIFY(cell.during([&] { return programs.endControlProgram(testTimeout()); }).ok());
        QVERIFY(!programs.isProgramRunning());
        QCOMPARE(Motions(*cell.controller).moveJ(cell.robot.truth().q, {0.5, 1}).error().code,
                 ErrorCode::NotInControl);
        QVERIFY(cell.during([&] { return programs.reupload(testTimeout()); }).ok());
        QVERIFY(cell.controller->status().inControl);
    }

    void questionsAreAnswered() {
        Cell cell;
        QVERIFY(cell.takeControl().ok());
        QVERIFY(cell.stepMs(1000));
        ArmQueries ask(*cell.controller);
        const auto with = [&](auto call) { return cell.during([&] { return call(testTimeout()); }); };
        const JointPositions q = cell.robot.truth().q;
        const Pose pose = cell.tcp();

        const auto forward = with([&](const Deadline& d) { return ask.forwardKinematics(q, {}, d); });
        QVERIFY2(forward.ok(), why(forward));
        QVERIFY((forward->position - pose.position).norm() < 1e-4);
        const Pose tcp(0, 0, 0.1, 0, 0, 0);
        const auto tool = with([&](const Deadline& d) { return ask.forwardKinematics(q, tcp, d); });
        QVERIFY2(tool.ok(), why(tool));
        QVERIFY(std::abs((tool->position - pose.position).norm() - 0.1) < 1e-4);
        const auto inverse = with([&](const Deadline& d) { return ask.inverseKinematics(pose, {}, d); });
        QVERIFY2(inverse.ok(), why(inverse));
        QVERIFY(apart(*inverse, q) < 1e-3);
        InverseOptions near;
        near.near = JointPositions(0.3, -1.2, 1.4, -1.8, -1.5, 0.2);
        near.maxPositionError = 1e-6;
        const auto other = with([&](const Deadline& d) { return ask.inverseKinematics(pose, near, d); });
        QVERIFY2(other.ok(), why(other));
        QVERIFY((kinematics::forwardTcp(robotModel(RobotModelId::UR5e).dh, *other).position - pose.position)
                    .norm() < 1e-3);
        const Pose far = moved(pose, 0, 0, 3);
        QCOMPARE(with([&](const Deadline& d) { return ask.inverseKinematics(far, {}, d); }).error().code,
                 ErrorCode::NoSolution);
        const auto has = with([&](const Deadline& d) { return ask.hasInverseKinematics(far, {}, d); });
        QVERIFY(has.ok() && !*has);
        const auto safe = with([&](const Deadline& d) { return ask.isWithinSafetyLimits(pose, d); });
        QVERIFY(safe.ok() && *safe);
        const auto wide = with(
            [&](const Deadline& d) { return ask.isWithinSafetyLimits(JointPositions(9, 0, 0, 0, 0, 0), d); });
        QVERIFY(wide.ok() && !*wide);
        QVERIFY(with([&](const Deadline& d) { return ask.jointTorques(d); })->allFinite());
        QVERIFY(*with([&](const Deadline& d) { return ask.isSteady(d); }));
        QCOMPARE(*with([&](const Deadline& d) { return ask.toolContact({}, d); }), 0);
        QVERIFY((with([&](const Deadline& d) { return ask.targetWaypoint(d); })->position - pose.position)
                    .norm() < 1e-3);
        QVERIFY(apart(*with([&](const Deadline& d) { return ask.jointPositionsHistory(100, d); }), q) < 1e-3);
        QCOMPARE(*with([&](const Deadline& d) { return ask.stepTime(d); }), 0.002);
        QVERIFY(with([&](const Deadline& d) { return ask.tcpOffset(d); })->position.norm() < 1e-9);
        QVERIFY(
            (with([&](const Deadline& d) { return ask.flangePose(d); })->position - pose.position).norm() <
            1e-3);
        QCOMPARE(*with([&](const Deadline& d) { return ask.freedriveStatus(d); }), 0);
    }

    void settingsArriveAtTheRobot() {
        Cell cell;
        QVERIFY(cell.takeControl().ok());
        ToolSetup setup(*cell.controller);
        const auto with = [&](auto call) { return cell.during([&] { return call(testTimeout()); }); };
        const Pose before = cell.tcp();
        const auto tcp = with([&](const Deadline& d) { return setup.setTcp(Pose(0, 0, 0.1, 0, 0, 0), d); });
        QVERIFY2(tcp.ok(), why(tcp));
        QVERIFY(cell.stepMs(20));
        QVERIFY(std::abs((cell.tcp().position - before.position).norm() - 0.1) < 1e-4);
        QVERIFY(with([&](const Deadline& d) {
                    return setup.setPayload(1.5, Eigen::Vector3d(0, 0, 0.05), d);
                }).ok());
        QVERIFY(with([&](const Deadline& d) { return setup.setPayload(1.0, {}, d); }).ok());
        QVERIFY(with([&](const Deadline& d) {
                    return setup.setTargetPayload(1.5, {0, 0, 0.05}, {0.1, 0.1, 0.1, 0, 0, 0}, d);
                }).ok());
        QVERIFY(with([&](const Deadline& d) { return setup.setGravity({0, 0, 9.82}, d); }).ok());
        QVERIFY(with([&](const Deadline& d) { return setup.zeroForceSensor(d); }).ok());
        QVERIFY(with([&](const Deadline& d) {
                    return setup.useExternalSensor({0.2, {0, 0, 0}, {0, 0, 0}}, d);
                }).ok());
        QVERIFY(setup.setExternalWrench({}).ok());
        const auto own = with([&](const Deadline& d) { return setup.useOwnSensor(d); });
        QVERIFY2(own.ok(), why(own));
        QVERIFY(with([&](const Deadline& d) { return setup.useExternalSensorLegacy({}, d); }).ok());
        QVERIFY(setup.setExternalWrench({}).ok());
        const auto ownAgain = with([&](const Deadline& d) { return setup.useOwnSensor(d); });
        QVERIFY2(ownAgain.ok(), why(ownAgain));
        QVERIFY(cell.controller->status().inControl);
    }

    void watchdogWithoutKicksStopsTheProgram() {
        Cell cell;
        QVERIFY(cell.takeControl().ok());
        ToolSetup setup(*cell.controller);
        // Advance time until the call has returned, which may take longer than the watchdog timeout.
        int ticks = 0;
        cell.everyTick = [&] {
            if (++ticks % 10 == 0) {
                (void)setup.kickWatchdog();
            }
        };
        QVERIFY(cell.during([&] { return setup.setWatchdog(10, testTimeout()); }).ok());
        cell.everyTick = nullptr;
        for (int i = 0; i < 20; ++i) {
            QVERIFY(setup.kickWatchdog().ok());
            QVERIFY(cell.stepMs(50));
        }
        QVERIFY(cell.controller->status().inControl);
        QVERIFY(cell.stepMs(300));
        QVERIFY(!cell.controller->status().inControl);
        QCOMPARE(cell.robot.truth().runtimeState, RuntimeState::Stopped);
    }

    void aTriggeredProtectiveStopIsReported() {
        Cell cell;
        QVERIFY(cell.takeControl().ok());
        const auto stopped =
            cell.during([&] { return ToolSetup(*cell.controller).triggerProtectiveStop(testTimeout()); });
        QVERIFY2(stopped.ok(), why(stopped));
        QCOMPARE(cell.controller->status().safetyMode, SafetyMode::ProtectiveStop);
        QCOMPARE(Motions(*cell.controller).startServoJ().error().code != ErrorCode::None, true);
    }

    void forceModePushesUntilItIsEndedOrStopped() {
        Cell cell;
        QVERIFY(cell.takeControl().ok());
        Compliance compliance(*cell.controller);
        ForceMode mode;
        mode.compliant = {false, false, true, false, false, false};
        mode.wrench.force.z() = 10;
        mode.limits = {0.1, 0.1, 0.05, 0.5, 0.5, 0.5};
        const auto with = [&](auto call) { return cell.during([&] { return call(testTimeout()); }); };
        QVERIFY(with([&](const Deadline& d) { return compliance.setForceDamping(0.1, d); }).ok());
        QVERIFY(with([&](const Deadline& d) { return compliance.setForceGainScaling(0.5, d); }).ok());
        const double low = cell.tcp().position.z();
        const auto on = with([&](const Deadline& d) { return compliance.setForceMode(mode, d); });
        QVERIFY2(on.ok(), why(on));
        QVERIFY(cell.stepMs(600));
        QVERIFY(cell.tcp().position.z() > low + 0.002);
        QVERIFY(with([&](const Deadline& d) { return compliance.endForceMode(d); }).ok());
        QVERIFY(cell.ticksToStandstill(500) >= 0);
        QVERIFY(with([&](const Deadline& d) { return compliance.setForceMode(mode, d); }).ok());
        QVERIFY(cell.stepMs(400));
        QVERIFY(!cell.isStanding());
        const std::uint64_t before = cell.controller->stops();
        cell.controller->stop(StopCause::StopButton);
        QVERIFY(cell.ticksToStandstill(500) >= 0);
        const Pose stands = cell.tcp();
        QVERIFY(cell.stepMs(400));
        QVERIFY((cell.tcp().position - stands.position).norm() < 1e-4);

        // Motions prepared before the stop must not start after it.
        Compliance early(*cell.controller, before);
        QCOMPARE(with([&](const Deadline& d) { return early.setForceMode(mode, d); }).error().code,
                 ErrorCode::Stopped);
        QVERIFY(!cell.controller->status().forceMode);
    }

    void freedriveLastsUntilItIsCancelled() {
        Cell cell;
        QVERIFY(cell.takeControl().ok());
        Compliance compliance(*cell.controller);
        const auto free = compliance.startFreedrive();
        QVERIFY2(free.ok(), why(free));
        QVERIFY(cell.stepMs(200));
        QVERIFY(free->progress().executing);
        QVERIFY(free->cancel());
        QVERIFY(cell.ticksToStandstill(300) >= 0);
        const auto teach = compliance.startTeachMode(Holding::Held);
        QVERIFY(teach.ok());
        QVERIFY(cell.stepMs(120));
        QCOMPARE(teach->state().cause, StopCause::EventLoopStalled);
    }

    void wrongArgumentsAreRefusedByName_data() {
        QTest::addColumn<int>("which");
        QTest::addColumn<int>("code");
        QTest::addColumn<QString>("name");
        int n = 0;
        const auto row = [&](const char* title, ErrorCode code, const char* name) {
            QTest::newRow(title) << n++ << static_cast<int>(code) << QString::fromLatin1(name);
        };
        row("joints in degrees", ErrorCode::InvalidArgument, "target");
        row("millimetres", ErrorCode::InvalidArgument, "target");
        row("rotation in degrees", ErrorCode::InvalidArgument, "target");
        row("speed in mm/s", ErrorCode::LimitExceeded, "speed");
        row("no acceleration", ErrorCode::InvalidArgument, "acceleration");
        row("lookahead", ErrorCode::LimitExceeded, "lookahead");
        row("gain", ErrorCode::LimitExceeded, "gain");
        row("blend in mm", ErrorCode::LimitExceeded, "blend");
        row("empty path", ErrorCode::InvalidArgument, "path");
        row("arc without via", ErrorCode::InvalidArgument, "via");
        row("force limits", ErrorCode::InvalidArgument, "limits");
        row("force not a number", ErrorCode::InvalidArgument, "wrench");
        row("damping", ErrorCode::LimitExceeded, "damping");
        row("payload in grams", ErrorCode::LimitExceeded, "mass");
        row("centre in mm", ErrorCode::InvalidArgument, "centreOfGravity");
        row("TCP in mm", ErrorCode::InvalidArgument, "tcp");
        row("watchdog", ErrorCode::LimitExceeded, "minFrequency");
        row("history", ErrorCode::LimitExceeded, "steps");
        row("deceleration", ErrorCode::InvalidArgument, "deceleration");
        row("twist of nothing", ErrorCode::InvalidArgument, "twist");
        row("function name", ErrorCode::InvalidArgument, "name");
        row("function body", ErrorCode::InvalidArgument, "body");
        row("function body that ends the function", ErrorCode::InvalidArgument, "\"end\" on line 2");
        row("function body without an end", ErrorCode::InvalidArgument, "\"while\" on line 1");
        row("negative contact force", ErrorCode::LimitExceeded, "contactForce");
    }
    void wrongArgumentsAreRefusedByName() {
        QFETCH(int, which);
        QFETCH(int, code);
        QFETCH(QString, name);
        Cell cell;
        Controller& c = *cell.controller;
        Motions m(c);
        ToolSetup s(c);
        Compliance f(c);
        const MoveParameters usual{0.1, 0.5, Holding::Free};
        const Deadline d = testTimeout();
        const double nan = std::nan("");
        ForceMode force;
        force.limits = {1, 1, 1, 1, 1, 1};
        ForceMode noLimits;
        ForceMode noForce = force;
        noForce.wrench.force.x() = nan;
        const JointPositions q(0, -1, 1, 0, 0, 0);
        using Kind = PathEntry::Kind;
        const std::vector<std::function<Error()>> calls{
            [&] { return m.moveJ(JointPositions(90, -90, 90, 0, 0, 0), usual).error(); },
            [&] { return m.moveL(Pose(300, -200, 400, 0, 3, 0), usual).error(); },
            [&] { return m.moveJToPose(Pose(0.3, -0.2, 0.4, 0, 180, 0), usual).error(); },
            [&] {
                return m.moveL(Pose(0.3, -0.2, 0.4, 0, 3, 0), {250, 0.5, Holding::Free}).error();
            },
            [&] {
                return m.moveJ(q, {0.5, 0, Holding::Free}).error();
            },
            [&] {
                return m.startServoJ({0.002, 0.5, 300}).error();
            },
            [&] {
                return m.startServoL({0.002, 0.1, 20}).error();
            },
            [&] {
                return m.movePath({{Kind::MoveJ, q, {}, 0.5, 1, 50}}, d).error();
            },
            [&] { return m.movePath({}, d).error(); },
            [&] {
                return m.movePath({{Kind::MoveC, q, {}, 0.5, 1, 0}}, d).error();
            },
            [&] { return f.setForceMode(noLimits, d).error(); },
            [&] { return f.setForceMode(noForce, d).error(); },
            [&] { return f.setForceDamping(1.5, d).error(); },
            [&] { return s.setPayload(1500, {}, d).error(); },
            [&] { return s.setPayload(1, Eigen::Vector3d(0, 0, 50), d).error(); },
            [&] { return s.setTcp(Pose(0, 0, 150, 0, 0, 0), d).error(); },
            [&] { return s.setWatchdog(0, d).error(); },
            [&] { return ArmQueries(c).jointPositionsHistory(-1, d).error(); },
            [&] { return m.stopJ(0).error(); },
            [&] { return m.moveUntilContact({}, d).error(); },
            [&] {
                return Programs(c).startFunction(QStringLiteral("1st"), QStringLiteral("x = 1"), d).error();
            },
            [&] {
                return Programs(c)
                    .startFunction(QStringLiteral("f"), QStringLiteral("tiller_x = 1"), d)
                    .error();
            },
            [&] {
                return Programs(c)
                    .startFunction(QStringLiteral("f"), QStringLiteral("sync()\nend\ndef g():\n  sync()"), d)
                    .error();
            },
            [&] {
                return Programs(c)
                    .startFunction(QStringLiteral("f"), QStringLiteral("while True:\n  sync() # end"), d)
                    .error();
            },
            [&] {
                JogTarget target;
                target.contactForce = -1;
                return m.startJog(target).error();
            },
        };
        const Error error = calls.at(static_cast<std::size_t>(which))();
        QVERIFY2(static_cast<int>(error.code) == code, qPrintable(error.toString()));
        QVERIFY2(error.controllerMessage.contains(name), qPrintable(error.toString()));
    }
};

QTEST_GUILESS_MAIN(TestCommands)
#include "tst_commands.moc"
