// SPDX-License-Identifier: MIT
#include <QTest>
#include <atomic>
#include <cmath>
#include <limits>
#include <thread>

#include "robot/io/outputs.h"
#include "tests/support/rtde_peer.h"

using namespace tiller;
using namespace tiller::io;
using namespace std::chrono_literals;
using test::RtdePeer;

namespace {

// Only a failing test reaches this timeout.
constexpr auto kTestTimeout = 20s;

Deadline testTimeout() {
    return Deadline::after(kTestTimeout);
}

/// A simulated robot. Either the test sets its reports, or the robot executes the received commands.
struct Bench {
    explicit Bench(test::RtdePeerOptions robot = {})
        : peer(std::move(robot)), outputs(options(), feedback()) {}

    OutputsOptions options() const {
        OutputsOptions to;
        to.host = QStringLiteral("127.0.0.1");
        to.port = peer.port();
        return to;
    }
    OutputFeedback feedback() {
        return {[this] {
            Report report;
            report.sequence = frozen ? 1 : ++sequence;
            if (obedient) {
                follow();
            }
            report.digitalOutputs = bits.load();
            report.speedSlider = slider.load();
            return report;
        }};
    }
    /// Executes the newest inputs as a controller does.
    void follow() {
        apply("standard_digital_output", 0);
        apply("configurable_digital_output", 8);
        apply("tool_digital_output", 16);
        const auto mask = peer.input("speed_slider_mask");
        if (!mask.empty() && mask[0] == 1) {
            slider = peer.input("speed_slider_fraction").at(0);
        }
    }
    void apply(const std::string& field, int shift) {
        const auto mask = peer.input(field + "_mask");
        const auto values = peer.input(field);
        if (mask.empty()) {
            return;
        }
        const auto m = static_cast<std::uint64_t>(mask[0]) << shift;
        bits = (bits & ~m) | ((static_cast<std::uint64_t>(values[0]) << shift) & m);
    }

    RtdePeer peer;
    std::atomic<bool> obedient{true};
    std::atomic<bool> frozen{false};
    std::atomic<std::uint64_t> sequence{0};
    std::atomic<std::uint64_t> bits{0};
    std::atomic<double> slider{1.0};
    Outputs outputs;
};

}  // namespace

class TestOutputs : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void nothingIsSentWithoutConfirmingFields() {
        RtdePeer peer;
        receive::ReceiverOptions follow;
        follow.host = QStringLiteral("127.0.0.1");
        follow.port = peer.port();
        follow.fields = {"actual_q"};
        const receive::Receiver receiver(follow);
        Outputs outputs({.host = QStringLiteral("127.0.0.1"), .port = peer.port()},
                        OutputFeedback::fromReceiver(receiver));
        const auto refused = [](const Result<void>& done, const char* field) {
            return done.error().code == ErrorCode::FieldUnknown &&
                   done.error().controllerMessage.contains(QLatin1String(field));
        };
        QVERIFY(refused(outputs.setDigitalOutput(0, true, testTimeout()), "actual_digital_output_bits"));
        QVERIFY(refused(outputs.setSpeedSlider(0.5, testTimeout()), "target_speed_fraction"));
        QVERIFY(refused(outputs.setAnalogOutput(0, AnalogDomain::Voltage, 0.5, testTimeout()),
                        "analog_io_types"));
        QVERIFY(peer.input("standard_digital_output_mask").empty());
    }

    void setsOnlyTheRequestedBits_data();
    void setsOnlyTheRequestedBits();
    void groupsAreSetTogether();
    void waitsForConfirmationByTheRobot();
    void afterAMissingConfirmationANewConnectionIsUsed();
    void oldDataConfirmNothing();
    void outputsThatDoNotExistAreRefused();
    void sliderIsLimitedToItsRange();
    void inputsInUseAreNamed();
    void unsupportedInputsAreReported();
    void connectsAutomaticallyWhenNeeded();
    void aMissingRobotIsAnError();
    void disconnectEndsTheWait();
};

void TestOutputs::setsOnlyTheRequestedBits_data() {
    QTest::addColumn<int>("output");
    QTest::addColumn<QString>("field");
    QTest::addColumn<int>("mask");
    QTest::newRow("first standard") << 0 << "standard_digital_output" << 1;
    QTest::newRow("last standard") << 7 << "standard_digital_output" << 128;
    QTest::newRow("first configurable") << 8 << "configurable_digital_output" << 1;
    QTest::newRow("last configurable") << 15 << "configurable_digital_output" << 128;
    QTest::newRow("tool 0") << 16 << "tool_digital_output" << 1;
    QTest::newRow("tool 1") << 17 << "tool_digital_output" << 2;
}

void TestOutputs::setsOnlyTheRequestedBits() {
    QFETCH(int, output);
    QFETCH(QString, field);
    QFETCH(int, mask);
    Bench bench;
    const std::uint64_t bit = std::uint64_t(1) << output;
    const std::uint64_t before = 0x2A5A5 & ~bit;
    bench.bits = before;
    for (const bool on : {true, false, true}) {
        const auto set = bench.outputs.setDigitalOutput(output, on, testTimeout());
        QVERIFY2(set.ok(), qPrintable(set.error().toString()));
        QCOMPARE(bench.peer.input(field.toStdString() + "_mask"), std::vector<double>{double(mask)});
        QCOMPARE(bench.peer.input(field.toStdString()), std::vector<double>{on ? double(mask) : 0.0});
        QCOMPARE(bench.bits.load(), on ? before | bit : before & ~bit);
    }
    QCOMPARE(bench.peer.inputPackages(), 3);
    QVERIFY(!bench.peer.isStarted());
}

void TestOutputs::groupsAreSetTogether() {
    Bench bench;
    bench.bits = 0x3FFFF;
    QVERIFY(bench.outputs.setDigitalOutputs(0x30301, 0x10200, testTimeout()).ok());
    QCOMPARE(bench.bits.load(), std::uint64_t((0x3FFFF & ~0x30301) | 0x10200));
    QCOMPARE(bench.peer.inputPackages(), 3);
}

void TestOutputs::waitsForConfirmationByTheRobot() {
    Bench bench;
    bench.obedient = false;
    // Connect first, so that connecting does not use up the 50 ms for the command.
    QVERIFY(bench.outputs.connect(testTimeout()).ok());
    const auto set = bench.outputs.setDigitalOutput(3, true, Deadline::after(50ms));
    QCOMPARE(set.error().code, ErrorCode::Timeout);
    // The command was sent in spite of the error. Reverting it would require a confirmation too.
    QTRY_COMPARE_WITH_TIMEOUT(bench.peer.inputPackages(), 1, 20000);

    const CancelToken token;
    token.cancel();
    QCOMPARE(bench.outputs.setDigitalOutput(3, true, Deadline::after(1h, token)).error().code,
             ErrorCode::Cancelled);
}

// The controller may have closed the connection although sending still succeeds.
void TestOutputs::afterAMissingConfirmationANewConnectionIsUsed() {
    Bench bench;
    bench.obedient = false;
    QVERIFY(bench.outputs.connect(testTimeout()).ok());
    QCOMPARE(bench.outputs.setDigitalOutput(3, true, Deadline::after(50ms)).error().code, ErrorCode::Timeout);
    QCOMPARE(bench.peer.connections(), 1);
    bench.obedient = true;
    QVERIFY(bench.outputs.setDigitalOutput(3, true, testTimeout()).ok());
    QCOMPARE(bench.peer.connections(), 2);
}

void TestOutputs::oldDataConfirmNothing() {
    Bench bench;
    bench.obedient = false;
    bench.frozen = true;
    QVERIFY(bench.outputs.connect(testTimeout()).ok());
    // The report already contains the requested value but is older than the command.
    QCOMPARE(bench.outputs.setDigitalOutput(0, false, Deadline::after(50ms)).error().code,
             ErrorCode::Timeout);
    bench.frozen = false;
    QVERIFY(bench.outputs.setDigitalOutput(0, false, testTimeout()).ok());
}

void TestOutputs::outputsThatDoNotExistAreRefused() {
    Bench bench;
    for (const int output : {-1, 18, 1000}) {
        QCOMPARE(bench.outputs.setDigitalOutput(output, true, testTimeout()).error().code,
                 ErrorCode::InvalidArgument);
        QCOMPARE(bench.outputs.canSetDigitalOutput(output).error().code, ErrorCode::InvalidArgument);
    }
    for (const std::uint32_t mask : {0U, 1U << 18, ~0U}) {
        QCOMPARE(bench.outputs.setDigitalOutputs(mask, 0, testTimeout()).error().code,
                 ErrorCode::InvalidArgument);
    }
    QCOMPARE(bench.peer.inputPackages(), 0);
}

void TestOutputs::sliderIsLimitedToItsRange() {
    Bench bench;
    QVERIFY(bench.outputs.setSpeedSlider(0.5, testTimeout()).ok());
    QCOMPARE(bench.slider.load(), 0.5);
    QCOMPARE(bench.peer.input("speed_slider_mask"), std::vector<double>{1});
    for (const double low : {0.0, -3.0, 0.019}) {
        QVERIFY(!bench.outputs.setSpeedSlider(low, testTimeout()).ok());
        QCOMPARE(bench.slider.load(), 0.5);
    }
    QVERIFY(bench.outputs.setSpeedSlider(1.0, testTimeout()).ok());
    const int packages = bench.peer.inputPackages();
    for (const double wrong : {1.0001, std::nan(""), std::numeric_limits<double>::infinity()}) {
        QCOMPARE(bench.outputs.setSpeedSlider(wrong, testTimeout()).error().code, ErrorCode::InvalidArgument);
    }
    QCOMPARE(bench.peer.inputPackages(), packages);
    QCOMPARE(bench.slider.load(), 1.0);
}

void TestOutputs::inputsInUseAreNamed() {
    test::RtdePeerOptions robot;
    robot.inUse = {"speed_slider_mask", "speed_slider_fraction"};
    Bench bench(robot);
    // The other outputs can still be set.
    QVERIFY(bench.outputs.setDigitalOutput(1, true, testTimeout()).ok());
    QVERIFY(bench.outputs.canSetDigitalOutput(1).ok());
    const Error error = bench.outputs.setSpeedSlider(0.5, testTimeout()).error();
    QCOMPARE(error.code, ErrorCode::RegisterInUse);
    QVERIFY2(error.context.contains(QLatin1String("speed_slider_fraction")), qPrintable(error.context));
    QCOMPARE(bench.outputs.canSetSpeedSlider().error().code, ErrorCode::RegisterInUse);
    QVERIFY(bench.outputs.isConnected());
}

void TestOutputs::unsupportedInputsAreReported() {
    test::RtdePeerOptions robot;
    robot.missing = {"tool_digital_output_mask"};
    Bench bench(robot);
    QVERIFY(bench.outputs.connect(testTimeout()).ok());
    QCOMPARE(bench.outputs.setDigitalOutput(16, true, testTimeout()).error().code, ErrorCode::FieldUnknown);
    // A request that includes a tool output is refused as a whole and leaves the other outputs unchanged.
    QCOMPARE(bench.outputs.setDigitalOutputs(0x10001, 0x10001, testTimeout()).error().code,
             ErrorCode::FieldUnknown);
    QCOMPARE(bench.peer.inputPackages(), 0);
    QVERIFY(bench.outputs.setDigitalOutput(0, true, testTimeout()).ok());
}

void TestOutputs::connectsAutomaticallyWhenNeeded() {
    Bench bench;
    QVERIFY(!bench.outputs.isConnected());
    QCOMPARE(bench.outputs.canSetDigitalOutput(0).error().code, ErrorCode::NotConnected);
    QVERIFY(bench.outputs.setDigitalOutput(0, true, testTimeout()).ok());
    QVERIFY(bench.outputs.isConnected());
    QCOMPARE(bench.peer.connections(), 1);
    bench.outputs.disconnect();
    QVERIFY(!bench.outputs.isConnected());
    QVERIFY(bench.outputs.setDigitalOutput(0, false, testTimeout()).ok());
    QCOMPARE(bench.peer.connections(), 2);
    // The robot was power-cycled. One of the next two commands detects this and reconnects. A command waits
    // only a limited time on the previous connection, so that it still has time to reconnect.
    bench.peer.closeConnection();
    QTRY_VERIFY_WITH_TIMEOUT(
        bench.outputs.setDigitalOutput(0, true, Deadline::after(5s)).ok() && bench.peer.connections() >= 3,
        60000);
}

void TestOutputs::aMissingRobotIsAnError() {
    QTcpServer server;
    server.listen(QHostAddress::LocalHost);
    OutputsOptions to;
    to.host = QStringLiteral("127.0.0.1");
    to.port = server.serverPort();
    server.close();
    Outputs outputs(to, {[] { return Report(); }});
    QCOMPARE(outputs.connect(testTimeout()).error().code, ErrorCode::ConnectionRefused);
    QCOMPARE(outputs.setSpeedSlider(1.0, testTimeout()).error().code, ErrorCode::ConnectionRefused);
    QVERIFY(!outputs.isConnected());
}

void TestOutputs::disconnectEndsTheWait() {
    Bench bench;
    bench.obedient = false;
    QVERIFY(bench.outputs.connect(testTimeout()).ok());
    Result<void> result;
    std::thread caller([&] { result = bench.outputs.setDigitalOutput(0, true, Deadline::after(1h)); });
    QTRY_COMPARE_WITH_TIMEOUT(bench.peer.inputPackages(), 1, 20000);
    bench.outputs.disconnect();
    caller.join();
    QCOMPARE(result.error().code, ErrorCode::Cancelled);
}

QTEST_GUILESS_MAIN(TestOutputs)
#include "tst_outputs.moc"
