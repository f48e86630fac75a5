// SPDX-License-Identifier: MIT
// Analog outputs and input registers with the simulated controller.
#include <QTest>
#include <cmath>

#include "robot/io/input_registers.h"
#include "robot/io/outputs.h"
#include "robot/receive/receiver.h"
#include "robot/simulator/simulator.h"

using namespace tiller;
using namespace tiller::io;

namespace {

Deadline testTimeout() {
    return Deadline::after(std::chrono::seconds(20));
}

struct Bench {
    Bench() : robot(options()) {
        if (!robot.start()) {
            qFatal("no robot");
        }
        receive::ReceiverOptions to;
        to.host = robot.listenAddress();
        to.port = static_cast<std::uint16_t>(robot.ports().rtde);
        to.priority = 0;
        to.fields = {"timestamp",
                     "standard_analog_output0",
                     "standard_analog_output1",
                     "analog_io_types",
                     "target_speed_fraction",
                     "input_int_register_30",
                     "input_double_register_45"};
        receiver = std::make_unique<receive::Receiver>(to);
        receiver->start().value();
    }
    static simulator::SimulatorOptions options() {
        simulator::SimulatorOptions options;
        options.anyFreePorts = true;
        options.poweredOn = true;
        return options;
    }
    std::uint16_t port() const { return static_cast<std::uint16_t>(robot.ports().rtde); }

    simulator::Simulator robot;
    std::unique_ptr<receive::Receiver> receiver;
};

}  // namespace

class TestAnalogAndRegisters : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void analogOutputsAreSetWithTheirDomainAndConfirmed() {
        Bench bench;
        QTRY_VERIFY_WITH_TIMEOUT(bench.receiver->counters().packets > 0, 20000);
        Outputs outputs({bench.robot.listenAddress(), bench.port()},
                        OutputFeedback::fromReceiver(*bench.receiver));
        QVERIFY(outputs.setAnalogOutput(0, AnalogDomain::Voltage, 0.5, testTimeout()).ok());
        QVERIFY(outputs.setAnalogOutput(1, AnalogDomain::Current, 0.25, testTimeout()).ok());
        const receive::Sample sample = bench.receiver->latest();
        QVERIFY(std::abs(sample.field("standard_analog_output0")[0] - 5.0) < 1e-6);
        QCOMPARE(static_cast<unsigned>(sample.field("analog_io_types")[0]) >> 2, 1U);
        QVERIFY(outputs.setAnalogOutput(0, AnalogDomain::Current, 0.0, testTimeout()).ok());
        QVERIFY(outputs.canSetAnalogOutput().ok());
    }

    void wrongAnalogValuesAreRefused() {
        Bench bench;
        Outputs outputs({bench.robot.listenAddress(), bench.port()},
                        OutputFeedback::fromReceiver(*bench.receiver));
        QCOMPARE(outputs.setAnalogOutput(2, AnalogDomain::Voltage, 0.5, testTimeout()).error().code,
                 ErrorCode::InvalidArgument);
        QCOMPARE(outputs.setAnalogOutput(0, AnalogDomain::Voltage, 5.0, testTimeout()).error().code,
                 ErrorCode::InvalidArgument);
        QCOMPARE(outputs.setAnalogOutput(0, AnalogDomain::Voltage, std::nan(""), testTimeout()).error().code,
                 ErrorCode::InvalidArgument);
    }

    void registersAreSetAndConfirmed() {
        Bench bench;
        QTRY_VERIFY_WITH_TIMEOUT(bench.receiver->counters().packets > 0, 20000);
        InputRegistersOptions options;
        options.host = bench.robot.listenAddress();
        options.port = bench.port();
        options.ints = {30, 31};
        options.doubles = {45};
        options.bits = {64};
        InputRegisters registers(options, InputRegisters::fromReceiver(*bench.receiver));
        QVERIFY(registers.setInt(30, -7, testTimeout()).ok());
        QVERIFY(registers.setInt(31, 5, testTimeout()).ok());
        QVERIFY(registers.setDouble(45, 2.5, testTimeout()).ok());
        QVERIFY(registers.setBit(64, true, testTimeout()).ok());
        QCOMPARE(bench.receiver->latest().field("input_int_register_30")[0], -7.0);
        QCOMPARE(bench.receiver->latest().field("input_double_register_45")[0], 2.5);
        QCOMPARE(registers.setInt(32, 1, testTimeout()).error().code, ErrorCode::InvalidArgument);
        QCOMPARE(registers.setDouble(45, std::nan(""), testTimeout()).error().code,
                 ErrorCode::InvalidArgument);
    }

    void aRegisterInUseDoesNotBlockTheOthers() {
        Bench bench;
        InputRegistersOptions options;
        options.host = bench.robot.listenAddress();
        options.port = bench.port();
        options.ints = {33};
        InputRegisters owner(options);
        QVERIFY(owner.connect(testTimeout()).ok());
        options.ints = {33, 34};
        InputRegisters other(options);
        QVERIFY(other.setInt(34, 1, testTimeout()).ok());
        QCOMPARE(other.setInt(33, 1, testTimeout()).error().code, ErrorCode::RegisterInUse);
    }
};

QTEST_GUILESS_MAIN(TestAnalogAndRegisters)
#include "tst_analog_and_registers.moc"
