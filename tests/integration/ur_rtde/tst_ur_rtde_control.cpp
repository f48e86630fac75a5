// SPDX-License-Identifier: MIT
// Tests of all functions of RTDEControlInterface with the simulated robot.
#include <ur_rtde/rtde_control_interface.h>
#include <ur_rtde/script_client.h>

#include <QScopeGuard>
#include <QTemporaryDir>
#include <QTest>
#include <fstream>
#include <future>

#include "robot/ur_rtde/detail/waiting.h"
#include "tests/support/ur_rtde_control_test.h"

using namespace tiller;
using namespace tiller::test;
using ur_rtde::AsyncOperationStatus;
using ur_rtde::Path;
using ur_rtde::PathEntry;
using ur_rtde::RTDEControlInterface;

class TestUrRtdeControl : public UrRtdeControlTest {
    Q_OBJECT

private Q_SLOTS:
    // ---- lifetime ---------------------------------------------------------------------------------------

    void connectsAndRunsTheProgram() {
        QVERIFY(control_->isConnected());
        QVERIFY(control_->isProgramRunning());
        QVERIFY((control_->getRobotStatus() & (1U << RTDEControlInterface::ROBOT_STATUS_POWER_ON)) != 0);
        control_->disconnect();
        QVERIFY(!control_->isConnected());
        QVERIFY(!control_->isProgramRunning());
        QVERIFY(!control_->moveJ(kStart));
        QVERIFY(control_->reconnect());
        QVERIFY(control_->moveJ(with(kStart, 5, 0.1)));
        QVERIFY(near(joints(), with(kStart, 5, 0.1)));
    }

    void upperRegistersAndSeparateFrequency() {
        control_.reset();
        control_ = std::make_unique<RTDEControlInterface>(
            cell_->host(), 125.0,
            RTDEControlInterface::FLAG_UPLOAD_SCRIPT | RTDEControlInterface::FLAG_UPPER_RANGE_REGISTERS);
        QVERIFY(control_->moveJ(with(kStart, 5, 0.1)));
        QVERIFY(near(joints(), with(kStart, 5, 0.1)));
    }

    void takesOverFromAProgramThatRuns() {
        control_.reset();  // the program keeps running
        control_ = std::make_unique<RTDEControlInterface>(cell_->host());
        QVERIFY(control_->moveJ(with(kStart, 5, 0.1)));
    }

    void stopScriptEndsTheProgramAndReuploadRestartsIt() {
        control_->stopScript();
        QVERIFY(untilNotRunning());
        QVERIFY(!control_->isProgramRunning());
        QVERIFY(!control_->moveJ(kStart));
        QVERIFY(control_->reuploadScript());
        QVERIFY(control_->moveJ(with(kStart, 5, 0.1)));
    }

    void runningProgramIsUsedWithoutUpload() {
        control_->disconnect();
        RTDEControlInterface second(cell_->host(), -1.0, RTDEControlInterface::FLAG_NO_WAIT);
        QVERIFY(second.isConnected());
        QVERIFY(second.moveJ(with(kStart, 5, 0.1)));
    }

    void waitPeriodKeepsThePeriod() {
        const auto begin = control_->initPeriod();
        control_->waitPeriod(begin);
        QVERIFY(std::chrono::steady_clock::now() - begin >= std::chrono::microseconds(1999));
    }

    // ---- user programs ----------------------------------------------------------------------------------

    void customScriptsRunBetweenCommands() {
        QVERIFY(control_->sendCustomScriptFunction("mine", "set_standard_digital_out(1, True)\nsync()"));
        QVERIFY((cell_->robot.truth().digitalOutputs & 2U) != 0);
        QVERIFY(
            control_->sendCustomScript("def other():\n  set_standard_digital_out(2, True)\n  sync()\nend\n"));
        QVERIFY((cell_->robot.truth().digitalOutputs & 4U) != 0);
        QTemporaryDir folder;
        const std::string file = folder.filePath("third.script").toStdString();
        std::ofstream(file) << "def third():\n  set_standard_digital_out(3, True)\n  sync()\nend\n";
        QVERIFY(control_->sendCustomScriptFile(file));
        QVERIFY((cell_->robot.truth().digitalOutputs & 8U) != 0);
        QVERIFY(control_->moveJ(with(kStart, 5, 0.1)));  // the control program is running again
    }

    // The script may start and end between two checks of the waiting thread.
    void aShortScriptIsNotMissedByALatePoll() {
        urrtde::setInterruptCheck([] {
            std::this_thread::sleep_for(std::chrono::milliseconds(20));
            return false;
        });
        const auto undo = qScopeGuard([] { urrtde::setInterruptCheck(nullptr); });
        for (int i = 0; i < 10; ++i) {
            QVERIFY2(control_->sendCustomScript("def brief():\n  sync()\nend\n"),
                     qPrintable(QString::number(i)));
        }
        QVERIFY(control_->moveJ(with(kStart, 5, 0.1)));

        QTemporaryDir folder;
        const std::string file = folder.filePath("brief.script").toStdString();
        std::ofstream(file) << "def brief():\n  sync()\nend\n";
        control_->setCustomScriptFile(file);
        for (int i = 0; i < 5; ++i) {
            QVERIFY2(control_->reuploadScript(), qPrintable(QString::number(i)));
        }
    }

    // A customized program for ur_rtde, limited to the parts that the interface uses.
    void customProgramWorksLikeTheBuiltInOne() {
        QTemporaryDir folder;
        const std::string file = folder.filePath("custom.script").toStdString();
        std::ofstream(file) << R"(
  O = 0
  P = 0
$5.0   P = 5
$6.0   P = 6
  command = 0
  while command != 255:
    command = read_input_integer_register(O)
    if command == 0:
      write_output_integer_register(O, 1)
    elif command == 26:
      write_output_float_register(O, P)
      write_output_integer_register(O, 2)
    end
    sync()
  end
)";
        control_->setCustomScriptFile(file);  // starts immediately
        QCOMPARE(control_->getStepTime(), 5.0);
        QVERIFY(control_->reuploadScript());
        QCOMPARE(control_->getStepTime(), 5.0);
        control_->setCustomScriptFile("");
        QCOMPARE(control_->getStepTime(), 0.002);

        // A complete program that begins with a comment of its author.
        std::ifstream body(file);
        const std::string whole = folder.filePath("whole.script").toStdString();
        std::ofstream(whole) << "# mine\n\ndef rtde_control():\n" << body.rdbuf() << "end\nrun program\n";
        control_->setCustomScriptFile(whole);
        QCOMPARE(control_->getStepTime(), 5.0);
        control_->stopJ(2.0, true);  // the custom script does not support this command
        QCOMPARE(control_->getStepTime(), 5.0);

        // The watchdog thread writes this value before it ends a script. The next script must start without
        // it.
        QVERIFY(!control_->sendCustomScript(
            "def cut():\n  write_output_integer_register(1, 100004)\n  sync()\nend\n"));
        QVERIFY2(control_->lastError().find("heartbeat") != std::string::npos, control_->lastError().c_str());
        QVERIFY(control_->sendCustomScript("def whole():\n  sync()\n  sync()\nend\n"));
    }

    // ---- moves ------------------------------------------------------------------------------------------

    void movesInJointAndToolSpace() {
        QVERIFY(control_->moveJ(with(kStart, 0, 0.2), 1.05, 1.4));
        QVERIFY(near(joints(), with(kStart, 0, 0.2)));
        const List above = with(pose(), 2, 0.05);
        QVERIFY(control_->moveL(above, 0.25, 1.2));
        QVERIFY(near(pose(), above));
        QVERIFY(control_->moveJ_IK(with(above, 2, -0.05)));
        QVERIFY(near(pose(), with(above, 2, -0.05)));
        QVERIFY(control_->moveL_FK(kStart));
        QVERIFY(near(joints(), kStart));
    }

    void anUnreachablePoseIsRefusedAndTheProgramContinues() {
        QVERIFY(!control_->moveJ_IK({2.5, 0, 0.3, 0, 3.1, 0}));
        QVERIFY(control_->getInverseKinematics({2.5, 0, 0.3, 0, 3.1, 0}).empty());
        QVERIFY(!control_->getInverseKinematicsHasSolution({2.5, 0, 0.3, 0, 3.1, 0}));
        QVERIFY(control_->servoL({2.5, 0, 0.3, 0, 3.1, 0}, 0, 0, 0.002, 0.1, 300));
        QVERIFY(control_->servoStop());
        QVERIFY(near(joints(), kStart));
        QVERIFY(control_->moveJ(kStart));
    }

    void movesThroughManyWaypointsBlend() {
        const List a = with(pose(), 2, 0.05);
        const List b = with(a, 0, 0.05);
        const auto row = [](List position, double speed, double acceleration, double blend) {
            position.insert(position.end(), {speed, acceleration, blend});
            return position;
        };
        QVERIFY(control_->moveL({row(a, 0.25, 1.2, 0.01), row(b, 0.25, 1.2, 0.0)}));
        QVERIFY(near(pose(), b));
        QVERIFY(control_->moveJ({row(with(kStart, 0, 0.1), 1, 1.4, 0.02), row(kStart, 1, 1.4, 0)}));
        QVERIFY(near(joints(), kStart));

        Path path;
        QCOMPARE(path.size(), std::size_t(0));
        path.addEntry({PathEntry::MoveJ, PathEntry::PositionJoints, row(with(kStart, 5, 0.2), 1, 1.4, 0)});
        path.appendMovelPath({row(a, 0.25, 1.2, 0.01)});
        path.addEntry({PathEntry::MoveP, PathEntry::PositionTcpPose, row(b, 0.1, 1.2, 0.01)});
        path.appendMovejPath({row(kStart, 1, 1.4, 0)});
        QCOMPARE(path.size(), std::size_t(4));
        QVERIFY(control_->movePath(path));
        QVERIFY(near(joints(), kStart));
        QCOMPARE(path.waypoints().size(), std::size_t(4));
        path.clear();
        QCOMPARE(path.size(), std::size_t(0));
        QVERIFY_EXCEPTION_THROWN(control_->movePath(path), std::invalid_argument);
    }

    void asynchronousMotionReportsProgress() {
        QVERIFY(control_->getAsyncOperationProgress() < 0);
        const auto row = [](List position, double blend) {
            position.insert(position.end(), {0.5, 1.4, blend});
            return position;
        };
        List slow = row(kStart, 0);
        slow[6] = 0.05;  // [rad/s]; slow enough to be observed
        Path path;
        path.appendMovejPath({row(with(kStart, 0, 0.3), 0), row(with(kStart, 0, 0.6), 0), slow});
        QVERIFY(control_->movePath(path, true));
        int last = -1;
        bool rising = true;
        const bool ended = cell_->until([&](const simulator::SimulatedState&) {
            const AsyncOperationStatus status = control_->getAsyncOperationProgressEx();
            if (status.isAsyncOperationRunning()) {
                rising = rising && status.progress() >= last;
                last = status.progress();
            }
            return !status.isAsyncOperationRunning();
        });
        QVERIFY(ended);
        QVERIFY(rising);
        QCOMPARE(last, 2);
        const int first = control_->getAsyncOperationProgress();
        QVERIFY(first < 0);
        QVERIFY(near(joints(), kStart));

        QVERIFY(control_->moveJ(with(kStart, 0, 0.3), 0.5, 1.4, true));
        QVERIFY(cell_->until(
            [&](const simulator::SimulatedState&) { return control_->getAsyncOperationProgress() < 0; }));
        QVERIFY(control_->getAsyncOperationProgress() != first);
    }

    // ---- streams ----------------------------------------------------------------------------------------

    void speedsAreKeptUntilStopped() {
        QVERIFY(control_->speedJ({0, 0, 0, 0, 0, 0.3}, 2.0));
        QVERIFY(untilMoving());
        QVERIFY(cell_->pass(0.5));
        QVERIFY(control_->speedStop());
        QVERIFY(untilStanding());
        QVERIFY(joints()[5] > kStart[5] + 0.05);
        const double z = pose()[2];
        QVERIFY(control_->speedL({0, 0, 0.05, 0, 0, 0}, 1.0, 0.1));
        QVERIFY(cell_->until(
            [&](const simulator::SimulatedState& t) { return t.tcpPose.position.z() > z + 0.02; }));
        QVERIFY(control_->speedStop(5.0));
        QVERIFY(untilStanding());
    }

    void aMoveMayFollowAServoImmediately() {
        const List target = with(kStart, 5, 0.2);
        QVERIFY(cell_->until([&](const simulator::SimulatedState& t) {
            return !control_->servoJ(target, 0.5, 0.5, 0.002, 0.1, 300) || near(jointsOf(t), target, 5e-3);
        }));
        QVERIFY(near(joints(), target, 5e-3));
        QVERIFY(control_->moveJ(kStart));  // servoStop() is not needed
        QVERIFY(near(joints(), kStart));
        const List above = with(pose(), 2, 0.02);
        QVERIFY(cell_->until([&](const simulator::SimulatedState& t) {
            return !control_->servoL(above, 0.5, 0.5, 0.002, 0.1, 300) || near(poseOf(t), above, 5e-3);
        }));
        QVERIFY(control_->servoStop(5.0));
        QVERIFY(near(pose(), above, 1e-2));
        const List higher = with(above, 2, 0.03);
        QVERIFY(control_->servoC(higher, 0.1, 1.0, 0.0));
        // The calls run one after the other without hanging.
        QVERIFY(control_->servoC(higher, 0.1, 1.0, 0.0));
        QVERIFY(
            cell_->until([&](const simulator::SimulatedState& t) { return near(poseOf(t), higher, 5e-3); }));
        QVERIFY(control_->servoStop());
    }

    void jogsInEveryFrame() {
        for (const auto& [feature, frame] :
             {std::pair{RTDEControlInterface::FEATURE_BASE, List{}},
              std::pair{RTDEControlInterface::FEATURE_TOOL, List{}},
              std::pair{RTDEControlInterface::FEATURE_CUSTOM, List{0, 0, 0, 3.14159265, 0, 0}}}) {
            QVERIFY(control_->moveJ(kStart));
            const double z = pose()[2];
            QVERIFY(control_->jogStart({0, 0, 0.05, 0, 0, 0}, feature, 0.5, frame));
            QVERIFY(untilMoving());
            QVERIFY(cell_->pass(0.4));
            QVERIFY(control_->jogStop());
            QVERIFY(untilStanding());
            // In the start pose the tool points down, and so does the custom frame.
            const bool up = feature == RTDEControlInterface::FEATURE_BASE;
            QVERIFY2(up ? pose()[2] > z + 0.01 : pose()[2] < z - 0.01,
                     qPrintable(QString::number(pose()[2] - z)));
        }
    }

    // Motions without a target must end if their client stops sending.
    void streamsEndWhenTheClientStopsSending() {
        QVERIFY(control_->speedJ({0, 0, 0, 0, 0, 0.2}, 2.0));
        QVERIFY(untilMoving());
        control_->disconnect();
        QVERIFY(untilStanding());
        QVERIFY(cell_->pass(0.5));
        QVERIFY(stands(cell_->robot.truth()));
        QVERIFY(control_->reconnect());
        QVERIFY(stands(cell_->robot.truth()));
        QVERIFY(control_->moveJ(kStart));
    }

    // ---- force mode, freedrive, contact -------------------------------------------------------------------

    void forceModeStartsAndEnds() {
        QVERIFY(control_->zeroFtSensor());
        QVERIFY(control_->forceModeSetDamping(0.1));
        QVERIFY(control_->forceModeSetGainScaling(0.5));
        const double z = pose()[2];
        const List limits{2, 2, 1.5, 1, 1, 1};
        QVERIFY(cell_->until([&](const simulator::SimulatedState& t) {
            return !control_->forceMode({0, 0, 0, 0, 0, 0}, {0, 0, 1, 0, 0, 0}, {0, 0, -10, 0, 0, 0}, 2,
                                        limits) ||
                   t.tcpPose.position.z() < z - 0.005;
        }));
        QVERIFY(pose()[2] < z - 0.004);
        QVERIFY(control_->forceModeStop());
        QVERIFY(untilStanding());
        QVERIFY(control_->moveJ(kStart));
    }

    void forceModeUsesTheDefaultDampingAndGain() {
        ur_rtde::ScriptClient asking(cell_->host(), 5, 22, 30002);
        asking.connect();
        QVERIFY(
            asking.sendScriptCommand("sec s():\n"
                                     "  set_standard_digital_out(0, force_mode_get_damping() == 0.025)\n"
                                     "  set_standard_digital_out(1, force_mode_get_gain_scaling() == 0.5)\n"
                                     "end\n"));
        QVERIFY(
            cell_->until([](const simulator::SimulatedState& truth) { return truth.digitalOutputs == 3; }));
    }

    void externalSensorIsAccepted() {
        QVERIFY(control_->setExternalForceTorque({0, 0, 1, 0, 0, 0}));
        QVERIFY(control_->enableExternalFtSensor(true, 0.5, {0, 0, 0.05}, {0, 0, 0.02}));
        QVERIFY(control_->enableExternalFtSensor(false));
        QVERIFY(control_->ftRtdeInputEnable(true, 0.5));
        QVERIFY(control_->ftRtdeInputEnable(false));
        // The measurement must not block other commands.
        QVERIFY(control_->moveJ(with(kStart, 0, 1.0), 0.05, 1.4, true));
        QVERIFY(untilMoving());
        for (int i = 0; i < 3; ++i) {
            QVERIFY(control_->setExternalForceTorque({0, 0, 1, 0, 0, 0}));
            QVERIFY(cell_->pass(0.02));
        }
        control_->stopJ(2.0);
        QVERIFY(untilStanding());
        QVERIFY(joints()[0] < kStart[0] + 0.9);
    }

    void theArmIsGuidedByHand() {
        QVERIFY(control_->freedriveMode());
        QCOMPARE(control_->getFreedriveStatus(), 0);
        QVERIFY(control_->freedriveMode({1, 0, 0, 0, 0, 0}, {0, 0, 0, 0, 0, 0}));
        const double x = pose()[0];
        cell_->robot.pressHand(Wrench::fromVector((Vector6() << 40, 0, 0, 0, 0, 0).finished()));
        QVERIFY(cell_->until(
            [&](const simulator::SimulatedState& t) { return t.tcpPose.position.x() > x + 0.01; }));
        cell_->robot.pressHand(Wrench());
        QVERIFY(control_->endFreedriveMode());
        QVERIFY(control_->teachMode());
        QVERIFY(control_->endTeachMode());
        QVERIFY(control_->moveJ(kStart));  // the interface accepts commands again
    }

    void contactsAreDetected() {
        QCOMPARE(control_->toolContact({0, 0, 0, 0, 0, 0}), 0);
        QVERIFY(control_->startContactDetection());
        QVERIFY(!control_->readContactDetection());
        QVERIFY(control_->moveL(with(pose(), 2, -0.3), 0.05, 0.5, true));
        QVERIFY(untilMoving());
        cell_->robot.pressHand(Wrench::fromVector((Vector6() << 0, 0, 150, 0, 0, 0).finished()));
        QVERIFY(
            cell_->until([&](const simulator::SimulatedState&) { return control_->readContactDetection(); }));
        cell_->robot.pressHand(Wrench());
        QVERIFY(control_->stopContactDetection());
        QVERIFY(untilStanding());

        const double z = pose()[2];
        auto moving = std::async(std::launch::async, [&] {
            return control_->moveUntilContact({0, 0, -0.05, 0, 0, 0});
        });
        QVERIFY(cell_->until(
            [&](const simulator::SimulatedState& t) { return t.tcpPose.position.z() < z - 0.01; }));
        cell_->robot.pressHand(Wrench::fromVector((Vector6() << 0, 0, 150, 0, 0, 0).finished()));
        QVERIFY(moving.get());
        cell_->robot.pressHand(Wrench());
        QVERIFY(untilStanding());
    }

    // ---- settings and queries ---------------------------------------------------------------------------

    void settingsReachTheRobot() {
        QVERIFY(control_->setPayload(1.5));
        QVERIFY(control_->setPayload(1.5, {0, 0, 0.05}));
        QVERIFY(control_->setGravity({0, 0, 9.82}));
        const List offset{0, 0, 0.1, 0, 0, 0};
        QVERIFY(control_->setTcp(offset));
        QVERIFY(near(control_->getTCPOffset(), offset, 1e-9));
        // The pose in the data changes one package after it is set.
        QVERIFY(cell_->until([&](const simulator::SimulatedState&) {
            return !near(control_->getActualToolFlangePose(), pose(), 1e-2);
        }));
        QVERIFY(control_->setTcp({0, 0, 0, 0, 0, 0}));
        QVERIFY(cell_->until([&](const simulator::SimulatedState&) {
            return near(control_->getActualToolFlangePose(), pose());
        }));
    }

    void questionsAreAnswered() {
        QCOMPARE(control_->getStepTime(), 0.002);
        QVERIFY(near(control_->getActualJointPositionsHistory(), joints()));
        QVERIFY(near(control_->getActualJointPositionsHistory(5), joints()));
        QVERIFY(near(control_->getTargetWaypoint(), pose()));
        QVERIFY(near(control_->getForwardKinematics(), pose()));
        QVERIFY(near(control_->getForwardKinematics(kStart), pose()));
        QVERIFY(!near(control_->getForwardKinematics(kStart, {0, 0, 0.1, 0, 0, 0}), pose(), 1e-2));
        QVERIFY(near(control_->getInverseKinematics(pose()), joints()));
        QVERIFY(near(control_->getInverseKinematics(pose(), kStart), joints()));
        QVERIFY(control_->getInverseKinematicsHasSolution(pose()));
        QVERIFY(control_->getInverseKinematicsHasSolution(pose(), kStart, 1e-10, 1e-10));
        QVERIFY(near(control_->poseTrans({1, 0, 0, 0, 0, 0}, {0, 2, 0, 0, 0, 0}), {1, 2, 0, 0, 0, 0}, 1e-9));
        QVERIFY(control_->isPoseWithinSafetyLimits(pose()));
        QVERIFY(!control_->isPoseWithinSafetyLimits({3, 0, 0, 0, 0, 0}));
        QVERIFY(control_->isJointsWithinSafetyLimits(kStart));
        QVERIFY(!control_->isJointsWithinSafetyLimits({7, 0, 0, 0, 0, 0}));
        QCOMPARE(control_->getJointTorques().size(), std::size_t(6));
        QVERIFY(cell_->until([&](const simulator::SimulatedState&) { return control_->isSteady(); }));
    }

    void watchdogStopsTheProgramWithoutKicks() {
        QVERIFY(control_->setWatchdog(0.1));  // long enough for a slow test
        for (int i = 0; i < 10; ++i) {
            QVERIFY(control_->kickWatchdog());
            QVERIFY(cell_->pass(0.02));
        }
        QVERIFY(control_->isProgramRunning());
        QVERIFY(untilNotRunning());
        QVERIFY(!control_->moveJ(kStart));
    }

    void protectiveStopEndsTheCurrentMotion() {
        QVERIFY(control_->moveJ(with(kStart, 0, 1.0), 0.05, 1.4, true));
        QVERIFY(untilMoving());
        QVERIFY(control_->triggerProtectiveStop());
        QVERIFY(untilStanding());
        QCOMPARE(cell_->robot.truth().safetyMode, SafetyMode::ProtectiveStop);
        QVERIFY(!control_->moveJ(kStart));
    }
};

QTEST_GUILESS_MAIN(TestUrRtdeControl)
#include "tst_ur_rtde_control.moc"
