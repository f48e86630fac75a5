// SPDX-License-Identifier: MIT
// Behaviour of ur_rtde 1.5.8 that programs rely on, in addition to names and types: exceptions, results
// without a running program, and behaviour during a stop.
#include <ur_rtde/dashboard_client.h>
#include <ur_rtde/rtde_control_interface.h>

#include <QTest>

#include "tests/support/ur_rtde_control_test.h"

using namespace tiller;
using ur_rtde::AsyncOperationStatus;
using ur_rtde::RTDEControlInterface;
using List = std::vector<double>;

class TestUrRtdeCompatibility : public test::UrRtdeControlTest {
    Q_OBJECT

private:
    bool until(const std::function<bool()>& condition) {
        return cell_->until([&](const simulator::SimulatedState&) { return condition(); });
    }

private Q_SLOTS:
    void connectedRobotIsIdentified() {
        const auto& options = cell_->robot.options();
        QCOMPARE(control_->versions().major, options.software.major);
        QCOMPARE(control_->versions().minor, options.software.minor);
        QVERIFY(!control_->serial_number().empty());
    }

    void aNumberIsDecodedAsAStatus() {
        const AsyncOperationStatus none;
        QCOMPARE(none.value(), 0U);
        QCOMPARE(none.progress(), -1);
        AsyncOperationStatus status = 0x05018003;
        QVERIFY(status.isAsyncOperationRunning());
        QCOMPARE(status.operationId(), 5);
        QCOMPARE(status.changeCount(), 1);
        QCOMPARE(status.progress(), 3);
        status = 0x05020003;
        QVERIFY(!status.isAsyncOperationRunning());
        QCOMPARE(status.progress(), -1);
    }

    void finishedOperationsAlternateTheirNumbers() {
        std::vector<int> ended;
        for (const double turn : {0.05, -0.05, 0.05}) {
            auto q = cell_->robot.truth().q.array();
            q[5] += turn;
            QVERIFY(control_->moveJ(List(q.begin(), q.end()), 1.0, 1.0, true));
            QVERIFY(until([&] { return control_->getAsyncOperationProgress() < 0; }));
            QCOMPARE(control_->getAsyncOperationProgressEx().progress(), -1);
            ended.push_back(control_->getAsyncOperationProgress());
        }
        QVERIFY(ended[0] == -1 || ended[0] == -2);
        QCOMPARE(ended[1], -3 - ended[0]);
        QCOMPARE(ended[2], ended[0]);
    }

    void unansweredRequestsThrow() {
        control_->stopScript();
        QVERIFY(until([&] { return !control_->isProgramRunning(); }));
        const List pose{-0.1, -0.4, 0.2, 0, 3.1, 0};
        QVERIFY_EXCEPTION_THROWN(control_->poseTrans(pose, pose), std::runtime_error);
        QVERIFY_EXCEPTION_THROWN(control_->getJointTorques(), std::runtime_error);
        QVERIFY_EXCEPTION_THROWN(control_->getTCPOffset(), std::runtime_error);
        QVERIFY_EXCEPTION_THROWN(control_->getForwardKinematics(), std::runtime_error);
        QVERIFY_EXCEPTION_THROWN(control_->getFreedriveStatus(), std::runtime_error);
        QVERIFY_EXCEPTION_THROWN(control_->getActualToolFlangePose(), std::runtime_error);
        QVERIFY_EXCEPTION_THROWN(control_->getInverseKinematicsHasSolution(pose), std::runtime_error);
        QVERIFY(control_->getInverseKinematics(pose).empty());
        QVERIFY(control_->getTargetWaypoint().empty());
        QVERIFY(control_->getActualJointPositionsHistory().empty());
        QCOMPARE(control_->getStepTime(), 0.0);
        QCOMPARE(control_->toolContact(List(6, 0.0)), 0);
        QVERIFY(!control_->isSteady());
    }

    void aProgramThatDoesNotStartIsALogicError() {
        control_->stopScript();
        control_.reset();
        cell_->robot.emergencyStop(true);
        QVERIFY(until([&] { return cell_->robot.truth().safetyMode != SafetyMode::Normal; }));
        QVERIFY_EXCEPTION_THROWN(RTDEControlInterface{cell_->host()}, std::logic_error);
    }

    void constructorReportsWhatPreventsControl_data() {
        QTest::addColumn<QByteArray>("word");
        QTest::newRow("local") << QByteArray("local control");
        QTest::newRow("powered off") << QByteArray("POWER_OFF");
        QTest::newRow("protective stop") << QByteArray("PROTECTIVE_STOP");
        QTest::newRow("emergency stop") << QByteArray("EMERGENCY_STOP");
    }
    void constructorReportsWhatPreventsControl() {
        QFETCH(QByteArray, word);
        const QByteArray trouble = QTest::currentDataTag();
        control_->stopScript();
        control_.reset();
        if (trouble == "local") {
            QVERIFY(cell_->robot.inject("remote off").ok());
        } else if (trouble == "powered off") {
            ur_rtde::DashboardClient pendant(cell_->host());
            pendant.connect();
            pendant.powerOff();
            QVERIFY(until([&] { return cell_->robot.truth().robotMode == RobotMode::PowerOff; }));
        } else if (trouble == "protective stop") {
            QVERIFY(cell_->robot.inject("protective-stop").ok());
            QVERIFY(until([&] { return cell_->robot.truth().safetyMode != SafetyMode::Normal; }));
        } else {
            cell_->robot.emergencyStop(true);
            QVERIFY(until([&] { return cell_->robot.truth().safetyMode != SafetyMode::Normal; }));
        }
        QByteArray reported;
        try {
            const RTDEControlInterface never{cell_->host()};
        } catch (const std::logic_error& error) {
            reported = error.what();
        }
        QVERIFY2(reported.contains(word), reported.constData());
    }

    void theProgramIsUploadedDuringAProtectiveStop() {
        QVERIFY(control_->triggerProtectiveStop());
        QVERIFY(control_->reuploadScript());
        QVERIFY_EXCEPTION_THROWN(control_->unlockProtectiveStop(), std::logic_error);  // rejected for 5 s
        QVERIFY(cell_->pass(6));
        control_->unlockProtectiveStop();
        QVERIFY(until([&] { return cell_->robot.truth().safetyMode == SafetyMode::Normal; }));
        QVERIFY(control_->reuploadScript());
        auto q = cell_->robot.truth().q.array();
        q[5] += 0.1;
        QVERIFY(control_->moveJ(List(q.begin(), q.end())));
    }

    void contactAtTheStartIsDetected() {
        cell_->robot.pressHand(Wrench::fromVector((Vector6() << 0, 0, 150, 0, 0, 0).finished()));
        QVERIFY(until([&] { return control_->toolContact(List(6, 0.0)) > 0; }));
        const double z = cell_->robot.truth().tcpPose.position.z();
        QVERIFY(control_->moveUntilContact({0, 0, -0.05, 0, 0, 0}));
        QVERIFY(std::abs(cell_->robot.truth().tcpPose.position.z() - z) < 0.005);
    }

    void contactMoveIsRefusedWithoutContactDetection() {
        control_.reset();
        cell_.reset();
        cell_ = std::make_unique<test::UrRtdeCell>([](simulator::SimulatorOptions& options) {
            options.model = RobotModelId::UR5;
            options.software = {3, 15, 8, 0};
        });
        control_ = std::make_unique<RTDEControlInterface>(cell_->host());
        const auto before = cell_->robot.truth();
        QVERIFY(!control_->moveUntilContact({0, 0, -0.05, 0, 0, 0}));
        QVERIFY(!control_->startContactDetection());
        QVERIFY(control_->setTcp({0, 0, 0.123, 0, 0, 0}));
        QCOMPARE(control_->getTCPOffset()[2], 0.123);  // the registers also contain this value
        QCOMPARE(control_->toolContact(List(6, 0.0)), 0);
        const List q = control_->getActualJointPositionsHistory();
        QCOMPARE(q.size(), std::size_t(6));
        QVERIFY(std::abs(q[1] - before.q[1]) < 1e-3);
        QVERIFY(control_->getActualJointPositionsHistory(5).empty());
        const List waypoint = control_->getTargetWaypoint();
        QCOMPARE(waypoint.size(), std::size_t(6));
        QVERIFY(waypoint != control_->getTCPOffset());
        QVERIFY(cell_->pass(0.3));
        QVERIFY((cell_->robot.truth().q.values - before.q.values).norm() < 1e-3);
    }

    // The scripts end before any package reports a running program.
    void theShortestScriptsAreNotMissed() {
        for (int i = 0; i < 5; ++i) {
            QVERIFY(control_->sendCustomScriptFunction("blink", "set_standard_digital_out(1, True)"));
            QVERIFY(
                control_->sendCustomScript("def two():\n  write_output_integer_register(0, 1)\n"
                                           "  write_output_integer_register(0, 2)\nend\n"));
        }
        QVERIFY((cell_->robot.truth().digitalOutputs & 2U) != 0);
    }
};

QTEST_GUILESS_MAIN(TestUrRtdeCompatibility)
#include "tst_ur_rtde_compatibility.moc"
