// SPDX-License-Identifier: MIT

#include <QTcpServer>
#include <QTest>

#include "tests/support/raw_client.h"

using namespace tiller;
using namespace tiller::test;

namespace {

const QByteArray kEchoScript =
    "def echo():\n  while True:\n    write_output_integer_register(24, read_input_integer_register(24))\n"
    "    sync()\n  end\nend\n";

/// Returns a loopback address that no other test on this computer uses at the same time.
QString ownAddress(int number) {
    const auto pid = static_cast<unsigned>(QCoreApplication::applicationPid());
    return QStringLiteral("127.%1.%2.%3").arg(210 + pid % 40).arg((pid / 40) % 250).arg(number);
}

}  // namespace

class TestSimulator : public QObject {
    Q_OBJECT

    static void send(VirtualRobot& robot, RawPrimary& primary, const QByteArray& script) {
        primary.send(script);
        robot.controller.drainSockets();
    }

private Q_SLOTS:
    void severalControllersShareTheStandardPorts() {
        std::vector<std::unique_ptr<simulator::Simulator>> controllers;
        for (int i = 1; i <= 3; ++i) {
            auto options = VirtualRobot::options();
            options.anyFreePorts = false;
            options.listenAddress = ownAddress(i);
            options.startJoints[0] = 0.1 * i;
            controllers.push_back(std::make_unique<simulator::Simulator>(options));
            const Result<void> started = controllers.back()->start();
            QVERIFY2(started.ok(), qPrintable(started.error().toString()));
            QCOMPARE(controllers.back()->ports().rtde, quint16(30004));
            QCOMPARE(controllers.back()->ports().dashboard, quint16(29999));
        }
        for (int i = 1; i <= 3; ++i) {
            RawRtde rtde(ownAddress(i), 30004);
            QVERIFY(rtde.useVersion());
            rtde.setupOutputs(500, "target_q");
            QVERIFY(rtde.start());
            controllers[static_cast<std::size_t>(i - 1)]->step();
            QVERIFY(std::abs(doubleAt(rtde.next().payload, 1) - 0.1 * i) < 1e-9);
        }
    }

    void portInUseIsNamedWithASolution() {
        auto options = VirtualRobot::options();
        options.anyFreePorts = false;
        options.listenAddress = ownAddress(9);
        simulator::Simulator first(options);
        QVERIFY(first.start().ok());
        simulator::Simulator second(options);
        const Result<void> refused = second.start();
        QVERIFY(!refused.ok());
        QCOMPARE(refused.error().code, ErrorCode::Rejected);
        QVERIFY(refused.error().context.contains("29999"));
        QVERIFY(refused.error().context.contains(ownAddress(9)));
        QVERIFY(refused.error().context.contains("port offset"));
        QVERIFY(!second.isRunning());
        first.stop();
        QVERIFY(second.start().ok());
    }

    void invalidAddressIsRefused() {
        auto options = VirtualRobot::options();
        options.listenAddress = "robot";
        QCOMPARE(simulator::Simulator(options).start().error().code, ErrorCode::AddressInvalid);
        options.listenAddress = "192.0.2.1";  // reserved for documentation, so no computer has this address
        QCOMPARE(simulator::Simulator(options).start().error().code, ErrorCode::AddressInvalid);
    }

    void anOffsetMovesAllPorts() {
        auto options = VirtualRobot::options();
        options.anyFreePorts = false;
        options.listenAddress = ownAddress(20);
        options.portOffset = 1000;
        simulator::Simulator controller(options);
        QVERIFY(controller.start().ok());
        QCOMPARE(controller.ports().dashboard, quint16(30999));
        QCOMPARE(controller.ports().rtde, quint16(31004));
        QVERIFY(RawRtde(ownAddress(20), 31004).useVersion());
    }

    void virtualTimeDoesNotAdvanceBetweenSteps() {
        VirtualRobot robot;
        const double before = robot.controller.truth().timestamp;
        RawRtde rtde = robot.rtde();
        QVERIFY(rtde.useVersion());
        robot.controller.drainSockets();
        QCOMPARE(robot.controller.truth().timestamp, before);
        robot.controller.step(500);
        QVERIFY(std::abs(robot.controller.truth().timestamp - before - 1.0) < 1e-9);
    }

    void realTimeAdvancesWithoutSteps() {
        auto options = VirtualRobot::options();
        options.time = simulator::Time::Real;
        simulator::Simulator controller(options);
        QVERIFY(controller.start().ok());
        RawRtde rtde(controller.listenAddress(), controller.ports().rtde);
        QVERIFY(rtde.useVersion());
        rtde.setupOutputs(500, "timestamp");
        QVERIFY(rtde.start());
        double last = doubleAt(rtde.next().payload, 1);
        for (int i = 0; i < 100; ++i) {
            const double now = doubleAt(rtde.next().payload, 1);
            QVERIFY(std::abs(now - last - 0.002) < 1e-9);
            last = now;
        }
    }

    void inputTakesEffectInTheNextStep() {
        VirtualRobot robot;
        RawPrimary primary = robot.primary();
        send(robot, primary, kEchoScript);
        RawRtde rtde = robot.rtde();
        QVERIFY(rtde.useVersion());
        rtde.setupInputs("input_int_register_24");
        rtde.setupOutputs(500, "output_int_register_24");
        QVERIFY(rtde.start());
        robot.controller.step();
        rtde.next();
        for (int i = 1; i <= 200; ++i) {
            rtde.sendPackage('U', QByteArray("\x01") + bigEndian(qint32(i)));
            QVERIFY(robot.controller.waitForInputPackages(
                static_cast<quint64>(i), Deadline::after(std::chrono::milliseconds(kWaitTimeoutMs))));
            robot.controller.step();
            QCOMPARE(intAt(rtde.next().payload, 1), i);
        }
    }

    void twoRunsOfTheSameProgramAreTheSame() {
        const auto run = [] {
            VirtualRobot robot;
            RawPrimary primary = robot.primary();
            send(robot, primary,
                 "def p():\n  movej([-1.2,-1.5,-2.0,-1,1.5,0], a=1.4, v=1)\n  speedl([0,0,0.05,0,0,0], 0.5, "
                 "1)\n"
                 "end\n");
            robot.controller.step(1234);
            return robot.controller.truth();
        };
        const simulator::SimulatedState first = run();
        const simulator::SimulatedState second = run();
        QCOMPARE(first.q.array(), second.q.array());
        QCOMPARE(first.qd.array(), second.qd.array());
    }

    void anEmergencyStopBrakesTheArmAndPowersItOff() {
        VirtualRobot robot;
        RawPrimary primary = robot.primary();
        send(robot, primary, "def p():\n  speedj([1,0,0,0,0,0], 5, 10)\nend\n");
        robot.controller.stepSeconds(0.6);
        QVERIFY(robot.controller.truth().qd[0] > 0.9);
        robot.controller.emergencyStop(true);
        robot.controller.step();
        QCOMPARE(robot.controller.truth().safetyMode, SafetyMode::RobotEmergencyStop);
        QCOMPARE(robot.controller.truth().runtimeState, RuntimeState::Stopped);
        // Category 1: a controlled stop instead of an abrupt one.
        QVERIFY(robot.controller.truth().qd[0] > 0.8);
        QVERIFY(
            robot.stepUntil([&] { return robot.controller.truth().robotMode == RobotMode::PowerOff; }, 1));
        QVERIFY(robot.controller.truth().qd.values.norm() < 0.05);

        RawDashboard dashboard = robot.dashboard();
        dashboard.ask("power on");
        robot.controller.stepSeconds(2);
        QCOMPARE(robot.controller.truth().robotMode, RobotMode::PowerOff);
        robot.controller.emergencyStop(false);
        robot.controller.step();
        QCOMPARE(robot.controller.truth().safetyMode, SafetyMode::Normal);
        QCOMPARE(robot.controller.truth().robotMode, RobotMode::PowerOff);
        dashboard.ask("brake release");
        QVERIFY(robot.stepUntil([&] { return robot.controller.truth().robotMode == RobotMode::Running; }, 5));
    }

    void aSafeguardStopPausesAndItsReleaseResumes() {
        VirtualRobot robot;
        RawPrimary primary = robot.primary();
        send(robot, primary, "def p():\n  movej([0.5,-1.7,-2.2,-0.8,1.6,0], a=1.4, v=0.5)\nend\n");
        robot.controller.stepSeconds(1);
        robot.controller.safeguardStop(true);
        QVERIFY(robot.stepUntil([&] { return robot.programState() == RuntimeState::Paused; }, 2));
        const simulator::SimulatedState paused = robot.controller.truth();
        QCOMPARE(paused.safetyMode, SafetyMode::SafeguardStop);
        QCOMPARE(paused.robotMode, RobotMode::Running);
        robot.controller.stepSeconds(1);
        QVERIFY(std::abs(robot.controller.truth().q[0] - paused.q[0]) < 1e-3);
        robot.controller.safeguardStop(false);
        QVERIFY(robot.stepUntil([&] { return robot.programState() == RuntimeState::Stopped; }, 10));
        QVERIFY(std::abs(robot.controller.truth().q[0] - 0.5) < 1e-3);
    }

    void aProtectiveStopPausesTheProgramUntilItIsResumed() {
        VirtualRobot robot;
        RawPrimary primary = robot.primary();
        send(robot, primary, "def p():\n  movej([0.5,-1.7,-2.2,-0.8,1.6,0], a=1.4, v=0.5)\nend\n");
        robot.controller.stepSeconds(1);
        robot.controller.protectiveStop();
        robot.controller.step();
        QCOMPARE(robot.controller.truth().safetyMode, SafetyMode::ProtectiveStop);
        QVERIFY(robot.programState() != RuntimeState::Playing);
        robot.controller.stepSeconds(5.1);
        const double stopped = robot.controller.truth().q[0];
        QVERIFY(stopped < 0);
        QCOMPARE(robot.dashboard().ask("unlock protective stop"), QByteArray("Protective stop releasing\n"));
        robot.controller.stepSeconds(2);
        QCOMPARE(robot.controller.truth().safetyMode, SafetyMode::Normal);
        QVERIFY(std::abs(robot.controller.truth().q[0] - stopped) < 1e-3);
        // A new program can start.
        send(robot, primary, "def q():\n  movej([-1.0,-1.7,-2.2,-0.8,1.6,0], a=1.4, v=1)\nend\n");
        robot.controller.step(2);
        QVERIFY(robot.stepUntil([&] { return robot.programState() == RuntimeState::Stopped; }, 5));
        QVERIFY(std::abs(robot.controller.truth().q[0] - -1.0) < 1e-3);
    }

    void theSpeedSliderStretchesAMove() {
        VirtualRobot robot;
        RawPrimary primary = robot.primary();
        const auto duration = [&](double slider, double target) {
            robot.controller.setSpeedSlider(slider);
            robot.controller.step(500);
            send(robot, primary,
                 "def p():\n  movej([" + QByteArray::number(target) +
                     ",-1.7,-2.2,-0.8,1.6,0], a=3, v=0.5)\nend\n");
            const double begin = robot.controller.truth().timestamp;
            robot.controller.step(2);
            while (robot.programState() != RuntimeState::Stopped &&
                   robot.controller.truth().timestamp < begin + 60) {
                robot.controller.step(10);
            }
            return robot.controller.truth().timestamp - begin;
        };
        duration(1.0, 0.0);
        const double full = duration(1.0, 1.0);
        const double half = duration(0.5, 0.0);
        QVERIFY2(std::abs(half / full - 2.0) < 0.15, qPrintable(QString::number(half / full)));
    }

    void aWatchdogStopsAProgramWithoutInput() {
        VirtualRobot robot;
        RawRtde rtde = robot.rtde();
        QVERIFY(rtde.useVersion());
        rtde.setupInputs("input_int_register_0");
        RawPrimary primary = robot.primary();
        send(robot, primary,
             "def p():\n  rtde_set_watchdog(\"input_int_register_0\", 10, \"stop\")\n  while True:\n    "
             "sync()\n"
             "  end\nend\n");
        for (int i = 0; i < 10; ++i) {
            rtde.sendPackage('U', QByteArray("\x01\0\0\0\0", 5));
            QVERIFY(robot.controller.waitForInputPackages(
                static_cast<quint64>(i) + 1, Deadline::after(std::chrono::milliseconds(kWaitTimeoutMs))));
            robot.controller.step(25);
            QCOMPARE(robot.programState(), RuntimeState::Playing);
        }
        robot.controller.step(80);
        QCOMPARE(robot.programState(), RuntimeState::Stopped);
    }

    void socketsOfAProgramAreClosedAtItsEnd() {
        QTcpServer server;
        QVERIFY(server.listen(QHostAddress::LocalHost));
        VirtualRobot robot;
        RawPrimary primary = robot.primary();
        send(robot, primary,
             "def p():\n  socket_open(\"127.0.0.1\", " + QByteArray::number(server.serverPort()) +
                 ", \"s\")\n  socket_send_line(\"hello\", \"s\")\n"
                 "  r = socket_read_ascii_float(1, \"s\", 5)\n"
                 "  write_output_float_register(24, r[1])\n  sleep(0.2)\nend\n");
        QVERIFY(robot.stepUntil(
            [&] { return server.hasPendingConnections() || server.waitForNewConnection(1); }, 10));
        QTcpSocket* peer = server.nextPendingConnection();
        QVERIFY(robot.stepUntil([&] { return peer->canReadLine() || peer->waitForReadyRead(1); }, 10));
        QCOMPARE(peer->readLine().trimmed(), QByteArray("hello"));
        peer->write("(2.5)\n");
        peer->flush();
        QVERIFY(robot.stepUntil([&] { return robot.programState() == RuntimeState::Stopped; }, 20));
        QTRY_COMPARE_WITH_TIMEOUT(peer->state(), QAbstractSocket::UnconnectedState, 60'000);

        RawRtde rtde = robot.rtde();
        QVERIFY(rtde.useVersion());
        rtde.setupOutputs(500, "output_double_register_24");
        QVERIFY(rtde.start());
        robot.controller.step();
        QCOMPARE(doubleAt(rtde.next().payload, 1), 2.5);
    }

    void digitalInputsReachClientsAndPrograms() {
        VirtualRobot robot;
        robot.controller.setDigitalInput(3, true);
        robot.controller.setDigitalInput(16, true);
        robot.controller.setDigitalInput(99, true);
        RawPrimary primary = robot.primary();
        send(robot, primary, "def p():\n  set_standard_digital_out(0, get_standard_digital_in(3))\nend\n");
        robot.controller.step(3);
        QCOMPARE(robot.controller.truth().digitalOutputs, 1ULL);
        RawRtde rtde = robot.rtde();
        QVERIFY(rtde.useVersion());
        rtde.setupOutputs(500, "actual_digital_input_bits");
        QVERIFY(rtde.start());
        robot.controller.step();
        QCOMPARE(qFromBigEndian<quint64>(rtde.next().payload.constData() + 1), (1ULL << 3) | (1ULL << 16));
    }

    void simulatorCanBeStoppedAndRestarted() {
        VirtualRobot robot;
        RawRtde rtde = robot.rtde();
        QVERIFY(rtde.useVersion());
        robot.controller.stop();
        QVERIFY(rtde.waitClosed());
        QVERIFY(!robot.controller.isRunning());
        robot.controller.step();  // no effect on a controller that is not running
        robot.controller.protectiveStop();
        QVERIFY(robot.controller.start().ok());
        QVERIFY(robot.rtde().useVersion());
        QCOMPARE(robot.controller.truth().safetyMode, SafetyMode::Normal);
    }
};

QTEST_GUILESS_MAIN(TestSimulator)
#include "tst_simulator.moc"
