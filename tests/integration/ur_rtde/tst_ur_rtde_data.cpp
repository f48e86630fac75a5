// SPDX-License-Identifier: MIT
// Tests of all functions of RTDEReceiveInterface and RTDEIOInterface with the simulated robot.
#include <ur_rtde/rtde_io_interface.h>
#include <ur_rtde/rtde_receive_interface.h>

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include "tests/integration/ur_rtde/ur_rtde_cell.h"

using namespace tiller;
using ur_rtde::RTDEIOInterface;
using ur_rtde::RTDEReceiveInterface;
using List = std::vector<double>;

class TestUrRtdeData : public QObject {
    Q_OBJECT

private:
    std::unique_ptr<test::UrRtdeCell> cell_;
    std::unique_ptr<RTDEReceiveInterface> receive_;

    /// Waits until the robot reports the setting.
    template <class Condition>
    bool until(Condition condition) {
        return cell_->until([&](const simulator::SimulatedState&) { return condition(); });
    }
    /// Advances robot time and receives all data of that time.
    bool pass(double seconds, RTDEReceiveInterface& receive) {
        if (!cell_->pass(seconds)) {
            return false;
        }
        const double now = cell_->robot.truth().timestamp;
        return until([&] { return receive.getTimestamp() >= now; });
    }

private Q_SLOTS:
    void initTestCase() {
        cell_ = std::make_unique<test::UrRtdeCell>();
        receive_ = std::make_unique<RTDEReceiveInterface>(cell_->host());
    }
    void cleanupTestCase() {
        receive_.reset();
        cell_.reset();
    }

    void followsAndReconnects() {
        QVERIFY(receive_->isConnected());
        receive_->receiveCallback();
        const double before = receive_->getTimestamp();
        QVERIFY(before >= 60);
        QVERIFY(until([&] { return receive_->getTimestamp() > before; }));
        receive_->disconnect();
        QVERIFY(!receive_->isConnected());
        QVERIFY(receive_->reconnect());
        QVERIFY(receive_->isConnected());
        const auto begin = receive_->initPeriod();
        receive_->waitPeriod(begin);
        QVERIFY(std::chrono::steady_clock::now() - begin >= std::chrono::microseconds(1999));
    }

    // If reconnect() fails, e.g. during a restart of the robot, the interface must still recover.
    void aFailedReconnectDoesNotEndTheAutomaticOne() {
        simulator::SimulatorOptions options;
        options.listenAddress = test::ownAddress(7);
        options.poweredOn = true;
        auto robot = std::make_unique<simulator::Simulator>(options);
        QVERIFY(robot->start().ok());
        RTDEReceiveInterface receive(options.listenAddress.toStdString());
        QVERIFY(receive.isConnected());
        robot.reset();
        QVERIFY(!receive.reconnect());
        QVERIFY(!receive.isConnected());
        robot = std::make_unique<simulator::Simulator>(options);
        QVERIFY(robot->start().ok());
        QTRY_VERIFY_WITH_TIMEOUT(receive.isConnected(), 30'000);
    }

    void everyValueIsPresentAndCorrect() {
        const simulator::SimulatedState truth = cell_->robot.truth();
        const auto q = truth.q.array();
        const auto pose = truth.tcpPose.array();
        const List actualQ = receive_->getActualQ();
        const List tcp = receive_->getActualTCPPose();
        QCOMPARE(actualQ.size(), std::size_t(6));
        for (std::size_t i = 0; i < 6; ++i) {
            QVERIFY(std::abs(actualQ[i] - q[i]) < 1e-3);
            QVERIFY(std::abs(receive_->getTargetQ()[i] - q[i]) < 1e-3);
            QVERIFY(std::abs(tcp[i] - pose[i]) < 1e-3);
            QVERIFY(std::abs(receive_->getTargetTCPPose()[i] - pose[i]) < 1e-3);
            QVERIFY(std::abs(receive_->getActualQd()[i]) < 1e-3);
            QVERIFY(std::abs(receive_->getTargetQd()[i]) < 1e-6);
            QVERIFY(std::abs(receive_->getTargetQdd()[i]) < 1e-6);
            QVERIFY(std::abs(receive_->getActualTCPSpeed()[i]) < 1e-3);
            QVERIFY(std::abs(receive_->getTargetTCPSpeed()[i]) < 1e-6);
        }
        QCOMPARE(receive_->getTargetCurrent().size(), std::size_t(6));
        QCOMPARE(receive_->getTargetMoment().size(), std::size_t(6));
        QCOMPARE(receive_->getActualCurrent().size(), std::size_t(6));
        QCOMPARE(receive_->getJointControlOutput().size(), std::size_t(6));
        QCOMPARE(receive_->getActualTCPForce().size(), std::size_t(6));
        QCOMPARE(receive_->getJointTemperatures().size(), std::size_t(6));
        QCOMPARE(receive_->getActualJointVoltage().size(), std::size_t(6));
        QCOMPARE(receive_->getActualToolAccelerometer().size(), std::size_t(3));
        QCOMPARE(receive_->getFtRawWrench().size(), std::size_t(6));
        QCOMPARE(receive_->getPayloadCog().size(), std::size_t(3));
        QCOMPARE(receive_->getPayloadInertia().size(), std::size_t(6));
        QCOMPARE(receive_->getPayload(), 0.0);
        QCOMPARE(receive_->getRobotMode(), int(RobotMode::Running));
        QCOMPARE(receive_->getSafetyMode(), int(SafetyMode::Normal));
        QCOMPARE(receive_->getRuntimeState(), uint32_t(RTDEReceiveInterface::STOPPED));
        QCOMPARE(receive_->getRobotStatus(), uint32_t(1));
        QCOMPARE(receive_->getSafetyStatusBits(), uint32_t(1) << RTDEReceiveInterface::IS_NORMAL_MODE);
        for (const int32_t mode : receive_->getJointMode()) {
            QCOMPARE(mode, 253);
        }
        QVERIFY(receive_->getActualExecutionTime() >= 0);
        QVERIFY(receive_->getActualMomentum() >= 0);
        QVERIFY(receive_->getActualMainVoltage() > 40);
        QVERIFY(receive_->getActualRobotVoltage() > 40);
        QVERIFY(receive_->getActualRobotCurrent() >= 0);
        QVERIFY(receive_->getSpeedScaling() >= 0);
        QVERIFY(receive_->getStandardAnalogInput1() >= 0);
        QCOMPARE(receive_->getOutputIntRegister(12), 0);
        QCOMPARE(receive_->getOutputDoubleRegister(19), 0.0);
        QVERIFY(!receive_->isProtectiveStopped());
        QVERIFY(!receive_->isEmergencyStopped());
    }

    void inputsAreReported() {
        cell_->robot.setDigitalInput(3, true);
        cell_->robot.setAnalogInput(0, 4.5);
        QVERIFY(until([&] { return receive_->getDigitalInState(3); }));
        QVERIFY(!receive_->getDigitalInState(4));
        QCOMPARE(receive_->getActualDigitalInputBits(), uint64_t(8));
        QVERIFY(until([&] { return std::abs(receive_->getStandardAnalogInput0() - 4.5) < 0.01; }));
        cell_->robot.setDigitalInput(3, false);
    }

    void stopsAreReported() {
        test::UrRtdeCell other([](simulator::SimulatorOptions& o) { o.listenAddress = test::ownAddress(2); });
        RTDEReceiveInterface receive(other.host(), 125.0, {"safety_status_bits", "runtime_state"});
        other.robot.protectiveStop();
        QVERIFY(other.until([&](const simulator::SimulatedState&) { return receive.isProtectiveStopped(); }));
        other.robot.emergencyStop(true);
        QVERIFY(other.until([&](const simulator::SimulatedState&) { return receive.isEmergencyStopped(); }));
        // The error names the field that was not requested.
        try {
            receive.getActualQ();
            QFAIL("no exception was thrown");
        } catch (const std::runtime_error& error) {
            QVERIFY(QByteArray(error.what()).contains("actual_q"));
        }
        QVERIFY_EXCEPTION_THROWN(receive.getOutputIntRegister(12), std::range_error);
    }

    void upperRegistersAreFollowed() {
        // No realtime priority is requested.
        RTDEReceiveInterface upper(cell_->host(), 10.0, {}, true, true, -1);
        QCOMPARE(upper.getOutputIntRegister(36), 0);
        QCOMPARE(upper.getOutputDoubleRegister(43), 0.0);
        QVERIFY_EXCEPTION_THROWN(upper.getOutputIntRegister(12), std::range_error);
    }

    void recordsToAFile() {
        QTemporaryDir folder;
        const std::string path = folder.filePath("all.csv").toStdString();
        QVERIFY(receive_->startFileRecording(path));
        QVERIFY(!receive_->startFileRecording(path));
        receive_->recordCallback();
        QVERIFY(pass(0.1, *receive_));
        QVERIFY(receive_->stopFileRecording());
        QVERIFY(!receive_->stopFileRecording());
        QFile file(QString::fromStdString(path));
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArrayList lines = file.readAll().split('\n');
        QVERIFY(lines.size() > 20);
        QVERIFY(lines[0].startsWith("timestamp,target_q_0,"));
        QVERIFY(lines[0].endsWith(",output_double_register_19"));
        QCOMPARE(lines[1].count(','), lines[0].count(','));
        for (const char* column :
             {"actual_q_0", "actual_q_5", "target_TCP_pose_2", "robot_mode", "payload_cog_2"}) {
            QVERIFY2(lines[0].split(',').contains(column), column);
        }

        const std::string some = folder.filePath("some.csv").toStdString();
        QVERIFY(receive_->startFileRecording(some, {"timestamp", "actual_q"}));
        QVERIFY(receive_->stopFileRecording());
        QFile second(QString::fromStdString(some));
        QVERIFY(second.open(QIODevice::ReadOnly));
        QVERIFY(second.readLine().startsWith("timestamp,actual_q_0,actual_q_1,actual_q_2,actual_q_3"));

        // The file contains exactly the requested fields, because programs identify columns by number.
        const std::string two = folder.filePath("two.csv").toStdString();
        QVERIFY(receive_->startFileRecording(two, {"robot_mode", "payload_cog"}));
        QVERIFY(pass(0.1, *receive_));
        QVERIFY(receive_->stopFileRecording());
        QFile third(QString::fromStdString(two));
        QVERIFY(third.open(QIODevice::ReadOnly));
        QCOMPARE(third.readLine(), QByteArray("robot_mode,payload_cog_0,payload_cog_1,payload_cog_2\n"));
        QVERIFY(third.readLine().startsWith("7,0,0,"));
        QVERIFY(!receive_->startFileRecording("/nonexistent/folder/file.csv"));
    }

    // ---- outputs ----------------------------------------------------------------------------------------

    void outputsAreSetOneByOne() {
        RTDEIOInterface io(cell_->host());
        QVERIFY(io.setStandardDigitalOut(7, true));
        QVERIFY(until([&] { return receive_->getDigitalOutState(7); }));
        QVERIFY(io.setConfigurableDigitalOut(0, true));
        QVERIFY(io.setToolDigitalOut(1, true));
        QVERIFY(until(
            [&] { return receive_->getActualDigitalOutputBits() == ((1U << 7) | (1U << 8) | (1U << 17)); }));
        QVERIFY(io.setStandardDigitalOut(7, false));
        QVERIFY(until([&] { return !receive_->getDigitalOutState(7); }));
        QVERIFY(receive_->getDigitalOutState(8));
        QVERIFY(io.setAnalogOutputVoltage(0, 0.5));
        QVERIFY(until([&] { return std::abs(receive_->getStandardAnalogOutput0() - 5.0) < 0.01; }));
        QVERIFY(io.setAnalogOutputCurrent(1, 0.25));
        QVERIFY(until([&] { return receive_->getStandardAnalogOutput1() > 0; }));
        QVERIFY(io.setSpeedSlider(0.4));
        QVERIFY(until([&] { return std::abs(receive_->getTargetSpeedFraction() - 0.4) < 0.006; }));
        QVERIFY(std::abs(receive_->getSpeedScalingCombined() - receive_->getSpeedScaling() * 0.4) < 0.01);
        QVERIFY_EXCEPTION_THROWN(io.setSpeedSlider(0.0), std::range_error);  // the arm would creep
        QVERIFY(io.setSpeedSlider(0.02));
        QVERIFY(until([&] { return std::abs(receive_->getTargetSpeedFraction() - 0.02) < 0.006; }));
        QVERIFY(io.setSpeedSlider(1.0));
        QVERIFY(io.setInputIntRegister(18, 42));
        QVERIFY(io.setInputDoubleRegister(22, 1.5));
        io.disconnect();
        QVERIFY(!io.setStandardDigitalOut(7, true));
        QVERIFY(io.reconnect());
        QVERIFY(io.setStandardDigitalOut(7, true));
        QVERIFY(until([&] { return receive_->getDigitalOutState(7); }));
    }

    void registersReachAProgramInBothRanges() {
        RTDEReceiveInterface registers(cell_->host(), -1.0,
                                       {"input_int_register_18", "input_double_register_46", "timestamp"});
        RTDEIOInterface lower(cell_->host());
        RTDEIOInterface upper(cell_->host(), false, true);
        QVERIFY(lower.setInputIntRegister(18, 42));
        QVERIFY(upper.setInputDoubleRegister(46, 1.5));
        QVERIFY(upper.setInputIntRegister(42, -7));
        QTemporaryDir folder;
        const std::string path = folder.filePath("registers.csv").toStdString();
        QVERIFY(pass(0.05, registers));
        QVERIFY(registers.startFileRecording(path));
        QVERIFY(pass(0.05, registers));
        QVERIFY(registers.stopFileRecording());
        QFile file(QString::fromStdString(path));
        QVERIFY(file.open(QIODevice::ReadOnly));
        file.readLine();
        const QByteArray row = file.readLine();
        QVERIFY2(row.startsWith("42,1.5,"), row.constData());
    }

    // If another client uses an output, only that output cannot be set.
    void anInputOwnedByAnotherClientIsRefused() {
        RTDEIOInterface first(cell_->host());
        RTDEIOInterface second(cell_->host());
        QVERIFY(first.setInputIntRegister(20, 1));
        QVERIFY(!second.setInputIntRegister(20, 2));
    }
};

QTEST_GUILESS_MAIN(TestUrRtdeData)
#include "tst_ur_rtde_data.moc"
