// SPDX-License-Identifier: MIT

#include <QTest>

#include "robot/kinematics/arm_kinematics.h"
#include "tests/support/raw_client.h"

using namespace tiller;
using namespace tiller::test;

namespace {

/// An RTDE client that receives one number per period.
struct Stream {
    explicit Stream(VirtualRobot& given) : robot(given), rtde(given.rtde()) {
        rtde.useVersion();
        rtde.setupOutputs(500, "timestamp");
        started = rtde.start();
        robot.controller.step();
        rtde.packages();
    }
    VirtualRobot& robot;
    RawRtde rtde;
    bool started = false;
};

}  // namespace

class TestFaults : public QObject {
    Q_OBJECT

    static void inject(VirtualRobot& robot, const QString& words) {
        const Result<QString> done = robot.controller.inject(words);
        QVERIFY2(done.ok(), qPrintable(done.error().context));
    }

private Q_SLOTS:
    void invalidFaultsAreExplainedAndHaveNoEffect_data() {
        QTest::addColumn<QString>("words");
        QTest::addColumn<QString>("hint");
        QTest::newRow("nothing") << ""
                                 << "help";
        QTest::newRow("unknown") << "explode"
                                 << "explode";
        QTest::newRow("neither on nor off") << "safeguard maybe"
                                            << "maybe";
        QTest::newRow("missing") << "safeguard"
                                 << "on|off";
        QTest::newRow("too much") << "fault now"
                                  << "now";
        QTest::newRow("too much after on") << "safeguard on please"
                                           << "please";
        QTest::newRow("no number") << "delay long"
                                   << "long";
        QTest::newRow("not a number at all") << "delay nan"
                                             << "nan";
        QTest::newRow("out of range") << "joint-near-limit 7"
                                      << "7";
        QTest::newRow("not whole") << "split 1.5"
                                   << "1.5";
        QTest::newRow("no such register") << "hold-registers input_int_register_99"
                                          << "exist";
    }
    void invalidFaultsAreExplainedAndHaveNoEffect() {
        QFETCH(QString, words);
        QFETCH(QString, hint);
        VirtualRobot robot;
        const QString before = robot.controller.inject("status").value();
        const Result<QString> refused = robot.controller.inject(words);
        QVERIFY(!refused.ok());
        QCOMPARE(refused.error().code, ErrorCode::InvalidArgument);
        QVERIFY2(refused.error().context.contains(hint), qPrintable(refused.error().context));
        robot.controller.drainSockets();
        QCOMPARE(robot.controller.inject("status").value(), before);
    }

    void questionsOfProgramsAreAnswered() {
        VirtualRobot robot;
        RawPrimary primary = robot.primary();
        QVERIFY(!robot.controller.inject("answer 1").ok());  // there is no pending request
        primary.send(
            "def p():\n  n = request_integer_from_primary_client(\"How many?\")\n"
            "  b = request_boolean_from_primary_client(\"Sure?\")\n"
            "  s = request_string_from_primary_client(\"Who?\")\n"
            "  f = request_float_from_primary_client(\"How much?\")\n"
            "  textmsg(str_cat(n, str_cat(b, str_cat(s, f))))\nend\n");
        robot.stepUntil([&] { return robot.programState() == RuntimeState::Playing; });
        robot.controller.step(2);
        QVERIFY(!robot.controller.inject("answer many").ok());
        for (const char* answer : {"answer 3", "answer true", "answer the left one", "answer 0.5"}) {
            inject(robot, QString::fromLatin1(answer));
            robot.controller.step(3);
        }
        QVERIFY(robot.stepUntil([&] { return robot.programState() == RuntimeState::Stopped; }));
        QCOMPARE(primary.messages(0).back(), QByteArray("3Truethe left one0.5"));
    }

    void theWorldIsBuiltByFaultCommands() {
        VirtualRobot robot;
        const auto force = [&] {
            robot.controller.step(20);
            RawRtde rtde = robot.rtde();
            return rtde.useVersion() && rtde.setupOutputs(500, "actual_TCP_force").size() == 9 && rtde.start()
                       ? (robot.controller.step(), doubleAt(rtde.next().payload, 1 + 16))
                       : qQNaN();
        };
        RawPrimary primary = robot.primary();
        primary.send("sec zero():\n  zero_ftsensor()\nend\n");
        robot.controller.drainSockets();
        QVERIFY(std::abs(force()) < 1);
        const Pose tool = robot.controller.truth().tcpPose;
        inject(robot, QStringLiteral("plane %1").arg(tool.position.z() + 0.0005));
        QVERIFY2(std::abs(force() - 10) < 1, qPrintable(QString::number(force())));  // 0.5 mm at 20 N/mm
        inject(robot, "no-surfaces");
        QVERIFY(std::abs(force()) < 1);
        inject(robot, QStringLiteral("box %1 %2 %3 0.2 0.2 0.1")
                          .arg(tool.position.x())
                          .arg(tool.position.y())
                          .arg(tool.position.z() - 0.0495));
        QVERIFY2(std::abs(force() - 10) < 1, qPrintable(QString::number(force())));
        inject(robot, "no-surfaces");
        inject(robot, "load 2");
        QVERIFY2(std::abs(force() + 2 * 9.82) < 1, qPrintable(QString::number(force())));
        inject(robot, "load none");
        QVERIFY(std::abs(force()) < 1);
        QVERIFY(robot.controller.inject("conveyor 0 1000").ok());
        QVERIFY(!robot.controller.inject("conveyor 2 1000").ok());
        QVERIFY(!robot.controller.inject("box 0 0 0 0 0 0").ok());
        QVERIFY(!robot.controller.inject("load").ok());
    }

    void faultPortAcceptsTheSameCommands() {
        VirtualRobot robot;
        RawClient console(robot.host(), robot.controller.ports().faults);
        console.send("protective-stop\n");
        QCOMPARE(console.line(), QByteArray("ok\n"));
        robot.controller.step();
        QCOMPARE(robot.controller.truth().safetyMode, SafetyMode::ProtectiveStop);
        console.send("status\r\nnonsense\n");
        QVERIFY(console.line().startsWith("ok robot_mode=RUNNING safety_mode=PROTECTIVE_STOP"));
        QVERIFY(console.line().startsWith("error: 'nonsense'"));
        // The fault control must respond while everything else is blocked. Otherwise, the fault could not be
        // ended.
        console.send("silence on\n");
        QCOMPARE(console.line(), QByteArray("ok\n"));
        console.send("link lost\n");
        QCOMPARE(console.line(), QByteArray("ok\n"));
        console.send("clear\n");
        QCOMPARE(console.line(), QByteArray("ok\n"));
        QCOMPARE(robot.dashboard().ask("robotmode"), QByteArray("Robotmode: RUNNING\n"));
        // A simulator that is not running reports an error.
        QVERIFY(!simulator::Simulator().inject("status").ok());
    }

    void everyPackageIsDelayedByTheSetTime() {
        VirtualRobot robot;
        Stream stream(robot);
        QVERIFY(stream.started);
        inject(robot, "delay 20");
        const double sent = robot.controller.truth().timestamp;
        robot.controller.step(9);
        QVERIFY(stream.rtde.packages().empty());
        robot.controller.step(20);
        const auto packages = stream.rtde.packages();
        QVERIFY(packages.size() >= 18 && packages.size() <= 21);
        QVERIFY(std::abs(doubleAt(packages.front().payload, 1) - sent - 0.002) < 1e-9);
        // No data are lost. When the delay ends, the remaining data arrive immediately.
        inject(robot, "delay 0");
        robot.controller.step(11);
        QCOMPARE(packages.size() + stream.rtde.packages().size(), std::size_t(40));
    }

    void requestsAreDelayedToo() {
        VirtualRobot robot;
        RawDashboard dashboard = robot.dashboard();
        inject(robot, "delay 100");
        dashboard.send("robotmode\n");
        robot.controller.drainSockets();
        robot.controller.stepSeconds(0.15);
        QVERIFY(dashboard.takeAll().isEmpty());
        robot.controller.stepSeconds(0.1);
        QCOMPARE(dashboard.line(), QByteArray("Robotmode: RUNNING\n"));
    }

    void jitterKeepsTheOrder() {
        VirtualRobot robot;
        Stream stream(robot);
        inject(robot, "delay 5 30");
        robot.controller.step(500);
        double last = 0;
        const auto packages = stream.rtde.packages();
        QVERIFY(packages.size() > 400);
        for (const auto& package : packages) {
            const double now = doubleAt(package.payload, 1);
            QVERIFY(last == 0 || std::abs(now - last - 0.002) < 1e-9);
            last = now;
        }
    }

    void packagesArriveInPieces() {
        VirtualRobot robot;
        Stream stream(robot);
        inject(robot, "split 5");
        robot.controller.step();
        QCOMPARE(stream.rtde.takeAll().size(), 5);
        robot.controller.step();
        QCOMPARE(stream.rtde.takeAll().size(), 12 - 5 + 5);
        robot.controller.step(300);
        inject(robot, "split 0");
        robot.controller.step(2);
        QCOMPARE(stream.rtde.takeAll().size(), 304 * 12 - 17);
    }

    void droppedPackagesAreNeverSent() {
        VirtualRobot robot;
        Stream stream(robot);
        inject(robot, "drop 25");
        robot.controller.step(2000);
        const auto arrived = stream.rtde.takeAll().size() / 12;
        QVERIFY2(arrived > 1300 && arrived < 1700, qPrintable(QString::number(arrived)));
        QVERIFY(robot.controller.inject("status").value().contains("drop=25"));
        inject(robot, "clear");
        robot.controller.step(100);
        QCOMPARE(stream.rtde.takeAll().size(), 100 * 12);
    }

    void packagesArriveTogether() {
        VirtualRobot robot;
        Stream stream(robot);
        inject(robot, "coalesce 20");
        QList<qsizetype> sizes;
        for (int i = 0; i < 30; ++i) {
            robot.controller.step();
            if (const auto size = stream.rtde.takeAll().size(); size > 0) {
                sizes << size;
            }
        }
        QVERIFY(sizes.size() >= 2 && sizes.size() <= 3);
        QCOMPARE(sizes[1], 10 * 12);
    }

    void aLostLinkKeepsTheConnectionAndEveryByte() {
        VirtualRobot robot;
        Stream stream(robot);
        inject(robot, "link lost");
        robot.controller.step(100);
        QVERIFY(stream.rtde.takeAll().isEmpty());
        QVERIFY(stream.rtde.isConnected());
        inject(robot, "link back");
        robot.controller.step();
        QCOMPARE(stream.rtde.packages().size(), std::size_t(101));
    }

    void aClientDroppedDuringALostLinkIsNotifiedLater() {
        VirtualRobot robot;
        Stream stream(robot);
        stream.rtde.setupInputs("input_int_register_0");
        inject(robot, "link lost");
        inject(robot, "close-clients");
        robot.controller.step(5);
        QVERIFY(stream.rtde.takeAll().isEmpty());
        QVERIFY(stream.rtde.isConnected());
        QCOMPARE(robot.controller.rtdeClients(), 0);
        inject(robot, "link back");
        QVERIFY(stream.rtde.waitClosed());
    }

    void aFullConnectionTableRefusesNewClients() {
        VirtualRobot robot;
        Stream stream(robot);
        inject(robot, "rtde-clients 1");
        RawRtde other = robot.rtde();
        QVERIFY(other.waitClosed());
        QVERIFY(stream.rtde.isConnected());
        QCOMPARE(robot.controller.rtdeClients(), 1);
        inject(robot, "clear");
        RawRtde later = robot.rtde();
        QVERIFY(later.useVersion());
    }

    void onlyTheControllerDropsAHalfOpenConnection() {
        VirtualRobot robot;
        Stream stream(robot);
        QCOMPARE(stream.rtde.setupInputs("input_int_register_3"), QByteArray("\x01INT32"));
        inject(robot, "half-open");
        QCOMPARE(robot.controller.rtdeClients(), 0);
        robot.controller.step(50);
        QVERIFY(stream.rtde.takeAll().isEmpty());
        QVERIFY(stream.rtde.isConnected());
        // The input registers can be reserved again, and a new connection works.
        RawRtde other = robot.rtde();
        QVERIFY(other.useVersion());
        QCOMPARE(other.setupInputs("input_int_register_3"), QByteArray("\x01INT32"));
        inject(robot, "clear");
        QVERIFY(stream.rtde.waitClosed());
    }

    void silenceStopsOnlyTheStream() {
        VirtualRobot robot;
        Stream stream(robot);
        inject(robot, "silence on");
        robot.controller.step(50);
        QVERIFY(stream.rtde.takeAll().isEmpty());
        inject(robot, "silence off");
        robot.controller.step(2);
        const auto packages = stream.rtde.packages();
        QCOMPARE(packages.size(), std::size_t(2));
        // Time has advanced. Data that were not sent are not sent later.
        QVERIFY(std::abs(doubleAt(packages[0].payload, 1) - robot.controller.truth().timestamp + 0.002) <
                1e-9);
    }

    void heldRegistersAreInUse() {
        VirtualRobot robot;
        inject(robot, "hold-registers lower");
        inject(robot, "hold-registers speed_slider_mask,speed_slider_fraction");
        RawRtde rtde = robot.rtde();
        QVERIFY(rtde.useVersion());
        QCOMPARE(rtde.setupInputs("input_int_register_0,input_double_register_24"),
                 QByteArray("\0IN_USE,DOUBLE", 14));
        QCOMPARE(rtde.setupInputs("speed_slider_mask"), QByteArray("\0IN_USE", 7));
        QCOMPARE(rtde.setupInputs("input_int_register_24"), QByteArray("\x01INT32"));
        QVERIFY(!robot.controller.inject("hold-registers upper").ok());  // one of the registers is in use
        inject(robot, "release-registers");
        QCOMPARE(rtde.setupInputs("input_int_register_0"), QByteArray("\x02INT32"));
    }

    void aScriptErrorEndsTheProgramWithAnException() {
        VirtualRobot robot;
        RawPrimary primary = robot.primary();
        primary.send("def p():\n  sleep(100)\nend\n");
        robot.controller.drainSockets();
        robot.controller.step(3);
        primary.packages();
        inject(robot, "script-error out of thin air");
        robot.controller.step();
        const auto exceptions = primary.messages(10);
        QCOMPARE(exceptions.size(), std::size_t(1));
        QCOMPARE(exceptions[0].mid(8), QByteArray("out of thin air"));
        QCOMPARE(robot.programState(), RuntimeState::Stopped);
    }

    void popupIsReportedToPrimaryClients() {
        VirtualRobot robot;
        RawPrimary primary = robot.primary();
        primary.packages();
        inject(robot, "popup look here");
        robot.controller.step();
        const auto popups = primary.messages(2);
        QCOMPARE(popups.size(), std::size_t(1));
        QVERIFY(popups[0].endsWith("look here"));
    }

    void powerIsLostAtOnceAndReturnsOnRequest() {
        VirtualRobot robot;
        inject(robot, "power-loss");
        robot.controller.step();
        QCOMPARE(robot.controller.truth().robotMode, RobotMode::PowerOff);
        QCOMPARE(robot.controller.truth().safetyMode, SafetyMode::Normal);
        robot.dashboard().ask("brake release");
        QVERIFY(robot.stepUntil([&] { return robot.controller.truth().robotMode == RobotMode::Running; }, 5));
    }

    void fiftyStopsOfAJointAreAFault() {
        VirtualRobot robot;
        RawPrimary primary = robot.primary();
        for (int i = 1; i < 50; ++i) {
            inject(robot, "protective-stop 157 3");
            robot.controller.step(2);
            primary.send("set unlock protective stop\n");
            robot.controller.drainSockets();
            robot.controller.stepSeconds(0.1);
            QCOMPARE(robot.controller.truth().safetyMode, SafetyMode::Normal);
        }
        inject(robot, "protective-stop 157 4");
        robot.controller.step(2);
        QCOMPARE(robot.controller.truth().safetyMode, SafetyMode::ProtectiveStop);
        primary.send("set unlock protective stop\n");
        robot.controller.drainSockets();
        robot.controller.stepSeconds(0.1);
        primary.packages();
        inject(robot, "protective-stop 157 3");
        robot.controller.step(2);
        QCOMPARE(robot.controller.truth().safetyMode, SafetyMode::Fault);
        const auto codes = primary.messages(6);
        QCOMPARE(codes.size(), std::size_t(2));
        QCOMPARE(intAt(codes[1], 0), 163);
        QCOMPARE(intAt(codes[1], 8), 4);  // 4: a fault
    }

    void aSlowBootPassesAllModesAndRestartsServicesOnce() {
        auto options = VirtualRobot::poweredOff();
        options.bootTime = 4;
        VirtualRobot robot(options);
        QCOMPARE(robot.controller.truth().robotMode, RobotMode::Disconnected);
        RawRtde early = robot.rtde();
        QVERIFY(early.useVersion());
        robot.controller.stepSeconds(1.9);
        QCOMPARE(robot.controller.truth().robotMode, RobotMode::Disconnected);
        robot.dashboard().ask("power on");  // too early, so it must be ignored
        robot.controller.stepSeconds(0.2);
        QCOMPARE(robot.controller.truth().robotMode, RobotMode::Booting);
        QVERIFY(early.waitClosed());
        QVERIFY(robot.controller.truth().timestamp < 0.2);
        RawPrimary primary = robot.primary();
        robot.controller.stepSeconds(2);
        QCOMPARE(robot.controller.truth().robotMode, RobotMode::PowerOff);
        QVERIFY(primary.packages().size() > 15);  // ten states per second, even after time resumes
        robot.controller.stepSeconds(5);
        QCOMPARE(robot.controller.truth().robotMode, RobotMode::PowerOff);
    }

    void anUnconfirmedSafetyConfigurationWaitsForTheOperator() {
        VirtualRobot robot;
        inject(robot, "restart 2 unconfirmed");
        robot.controller.stepSeconds(30);
        QCOMPARE(robot.controller.truth().robotMode, RobotMode::ConfirmSafety);
        inject(robot, "confirm-safety");
        robot.controller.stepSeconds(1.1);
        QCOMPARE(robot.controller.truth().robotMode, RobotMode::PowerOff);
    }

    void polyScopeXReportsUnconfirmedSafetyToNewClients() {
        auto options = VirtualRobot::options();
        options.software = {10, 12, 0, 0};
        VirtualRobot robot(options);
        {
            RawRtde quiet = robot.rtde();
            QCOMPARE(quiet.request('V', bigEndian(quint16(2))).type, 'V');
        }
        inject(robot, "restart 1 unconfirmed");
        robot.controller.stepSeconds(2);
        RawRtde rtde = robot.rtde();
        const RawRtde::Package text = rtde.request('V', bigEndian(quint16(2)));
        QCOMPARE(text.type, 'M');
        // A new connection uses version 1, where the level precedes the text.
        QCOMPARE(text.payload[0], char(2));
        QVERIFY(text.payload.contains("SafetySetup has not been confirmed yet"));
        QCOMPARE(rtde.next().type, 'V');
    }

    void aJointNearItsLimitStopsAMoveThatPassesIt() {
        VirtualRobot robot;
        inject(robot, "joint-near-limit 6 2");
        robot.controller.step();
        QVERIFY(std::abs(robot.controller.truth().q[5] - (kJointPositionLimit - 2 * M_PI / 180)) < 1e-3);
        RawPrimary primary = robot.primary();
        primary.send("def p():\n  speedj([0,0,0,0,0,0.5], 1, 5)\nend\n");
        robot.controller.drainSockets();
        QVERIFY(robot.stepUntil(
            [&] { return robot.controller.truth().safetyMode == SafetyMode::ProtectiveStop; }, 5));
        QVERIFY(robot.controller.truth().q[5] <= kJointPositionLimit + 1e-6);
    }

    void aWrongCalibrationIsReportedWithoutChangingTheArm() {
        VirtualRobot robot;
        RawPrimary primary = robot.primary();
        robot.controller.stepSeconds(0.3);
        const QByteArray right = firstWithKinematics(primary);
        QVERIFY(!right.isEmpty());
        const Pose before = robot.controller.truth().tcpPose;
        robot.controller.stepSeconds(0.3);
        QVERIFY(firstWithKinematics(primary).isEmpty());
        inject(robot, "calibration 1");
        robot.controller.stepSeconds(0.3);
        const QByteArray wrong = firstWithKinematics(primary);
        QVERIFY(!wrong.isEmpty());
        QVERIFY(wrong != right);
        // Values as reported by real robots: frames far from the links, and a deviation of the flange of less
        // than a centimetre.
        QCOMPARE(dhIn(right).d[1], 0.0);
        QVERIFY(std::abs(dhIn(wrong).d[1]) > 1);
        const JointPositions q = robot.controller.truth().q;
        const double deviation = (kinematics::forward(dhIn(wrong), q).translation() -
                                  kinematics::forward(dhIn(right), q).translation())
                                     .norm();
        QVERIFY(deviation > 1e-4 && deviation <= 1e-2);
        QVERIFY((robot.controller.truth().tcpPose.position - before.position).norm() < 1e-4);
    }

private:
    static DhParameters dhIn(const QByteArray& kinematicsInfo) {
        DhParameters dh;
        for (int i = 0; i < 6; ++i) {
            const auto joint = static_cast<std::size_t>(i);
            dh.theta[joint] = doubleAt(kinematicsInfo, 29 + 8 * i);
            dh.a[joint] = doubleAt(kinematicsInfo, 77 + 8 * i);
            dh.d[joint] = doubleAt(kinematicsInfo, 125 + 8 * i);
            dh.alpha[joint] = doubleAt(kinematicsInfo, 173 + 8 * i);
        }
        return dh;
    }
    /// KinematicsInfo of the first received state that contains it.
    static QByteArray firstWithKinematics(RawPrimary& primary) {
        for (const QByteArray& package : primary.packages()) {
            for (qsizetype at = 5; package[4] == 16 && at + 5 <= package.size(); at += intAt(package, at)) {
                if (package[at + 4] == 5) {
                    return package.mid(at, intAt(package, at));
                }
            }
        }
        return {};
    }
};

QTEST_GUILESS_MAIN(TestFaults)
#include "tst_faults.moc"
