// SPDX-License-Identifier: MIT
// DashboardClient, ScriptClient, RobotiqGripper, RTDEUtility and Path.
#include <ur_rtde/dashboard_client.h>
#include <ur_rtde/robotiq_gripper.h>
#include <ur_rtde/rtde_path.h>
#include <ur_rtde/rtde_utility.h>
#include <ur_rtde/script_client.h>

#include <QTemporaryDir>
#include <QTest>
#include <fstream>

#include "tests/integration/ur_rtde/gripper_peer.h"
#include "tests/integration/ur_rtde/ur_rtde_cell.h"

using namespace tiller;
using ur_rtde::DashboardClient;
using ur_rtde::Path;
using ur_rtde::PathEntry;
using ur_rtde::RobotiqGripper;
using ur_rtde::RTDEUtility;
using ur_rtde::ScriptClient;
using List = std::vector<double>;

namespace {
const QByteArray kProgram = "def loaded():\n  while True:\n    sync()\n  end\nend\n";
}

class TestUrRtdeClients : public QObject {
    Q_OBJECT

private:
    QTemporaryDir folder_;

    std::unique_ptr<test::UrRtdeCell> cell(
        const std::function<void(simulator::SimulatorOptions&)>& adjust = {}) {
        return std::make_unique<test::UrRtdeCell>([&](simulator::SimulatorOptions& options) {
            options.programsFolder = folder_.path();
            if (adjust) {
                adjust(options);
            }
        });
    }

private Q_SLOTS:
    void initTestCase() {
        std::ofstream(folder_.filePath("loaded.script").toStdString()) << kProgram.constData();
        std::ofstream(folder_.filePath("loaded.urp").toStdString()) << kProgram.constData();
    }

    void dashboardAnswersEveryQuestion() {
        const auto robot = cell();
        DashboardClient dashboard(robot->host());
        QVERIFY(!dashboard.isConnected());
        dashboard.connect();
        QVERIFY(dashboard.isConnected());
        QCOMPARE(dashboard.robotmode(), std::string("Robotmode: RUNNING"));
        QCOMPARE(dashboard.safetymode(), std::string("Safetymode: NORMAL"));
        QCOMPARE(dashboard.safetystatus(), std::string("Safetystatus: NORMAL"));
        QCOMPARE(dashboard.polyscopeVersion().substr(0, 5), std::string("5.22."));
        QCOMPARE(dashboard.getRobotModel().substr(0, 3), std::string("UR5"));
        QCOMPARE(dashboard.getSerialNumber().substr(0, 2), std::string("20"));
        QVERIFY(dashboard.isInRemoteControl());
        QVERIFY(dashboard.isProgramSaved());
        QVERIFY(!dashboard.running());
        dashboard.send("programState\n");
        dashboard.send("robotmode");
        QCOMPARE(dashboard.receive().substr(0, 7), std::string("STOPPED"));
        QCOMPARE(dashboard.receive(), std::string("Robotmode: RUNNING"));
        QVERIFY_EXCEPTION_THROWN(dashboard.receive(), std::logic_error);
        dashboard.popup("hello");
        dashboard.closePopup();
        dashboard.closeSafetyPopup();
        dashboard.addToLog("a line");
        dashboard.disconnect();
        QVERIFY(!dashboard.isConnected());
        QVERIFY_EXCEPTION_THROWN(dashboard.robotmode(), std::runtime_error);
    }

    void dashboardRunsPrograms() {
        const auto robot = cell();
        DashboardClient dashboard(robot->host(), 29999, true);
        dashboard.connect(5000);
        QVERIFY_EXCEPTION_THROWN(dashboard.loadURP("nothing.urp"), std::runtime_error);
        QVERIFY_EXCEPTION_THROWN(dashboard.play(), std::runtime_error);  // no program is loaded
        dashboard.loadURP("loaded.urp");
        const QString loaded = QString::fromStdString(dashboard.getLoadedProgram());
        QVERIFY2(loaded.startsWith("Loaded program: ") && loaded.endsWith("loaded.urp"), qPrintable(loaded));
        dashboard.play();
        QVERIFY(robot->until([&](const simulator::SimulatedState&) { return dashboard.running(); }));
        QCOMPARE(dashboard.programState(), std::string("PLAYING loaded.urp"));
        dashboard.pause();
        QVERIFY(robot->until([&](const simulator::SimulatedState&) {
            return dashboard.programState() == "PAUSED loaded.urp";
        }));
        dashboard.stop();
        QVERIFY(robot->until([&](const simulator::SimulatedState&) { return !dashboard.running(); }));
    }

    void dashboardPowersTheRobotOnAndOff() {
        const auto robot = cell([](simulator::SimulatorOptions& o) { o.poweredOn = false; });
        DashboardClient dashboard(robot->host());
        dashboard.connect();
        const auto becomes = [&](RobotMode mode) {
            return robot->until(
                [mode](const simulator::SimulatedState& truth) { return truth.robotMode == mode; });
        };
        dashboard.powerOn();
        QVERIFY(becomes(RobotMode::Idle));
        dashboard.brakeRelease();
        QVERIFY(becomes(RobotMode::Running));
        robot->robot.protectiveStop();
        QVERIFY(robot->until([](const simulator::SimulatedState& truth) {
            return truth.safetyMode == SafetyMode::ProtectiveStop;
        }));
        QVERIFY_EXCEPTION_THROWN(dashboard.unlockProtectiveStop(), std::logic_error);  // rejected for 5 s
        QVERIFY(robot->pass(6));
        dashboard.unlockProtectiveStop();
        QVERIFY(robot->until(
            [](const simulator::SimulatedState& truth) { return truth.safetyMode == SafetyMode::Normal; }));
        dashboard.powerOff();
        QVERIFY(becomes(RobotMode::PowerOff));
        robot->robot.fault();
        QVERIFY(robot->until(
            [](const simulator::SimulatedState& t) { return t.safetyMode == SafetyMode::Fault; }));
        dashboard.restartSafety();
        QVERIFY(robot->until(
            [](const simulator::SimulatedState& t) { return t.safetyMode == SafetyMode::Normal; }));
        dashboard.quit();
        QVERIFY(!dashboard.isConnected());
        dashboard.connect();
        dashboard.shutdown();
        QVERIFY(!dashboard.isConnected());
    }

    void userRolesExistOnlyOnCb3() {
        const auto robot = cell([](simulator::SimulatorOptions& options) {
            options.model = RobotModelId::UR5;
            options.software = {3, 15, 8, 0};
        });
        DashboardClient dashboard(robot->host());
        dashboard.connect();
        const auto role = [&dashboard] {
            dashboard.send("getUserRole");
            return dashboard.receive();
        };
        QCOMPARE(role(), std::string("PROGRAMMER"));
        dashboard.setUserRole(ur_rtde::UserRole::OPERATOR);
        QCOMPARE(role(), std::string("OPERATOR"));
        dashboard.setUserRole(ur_rtde::UserRole::RESTRICTED);
        QCOMPARE(role(), std::string("RESTRICTED"));

        // An e-Series robot has no user roles and reports an error.
        const auto later =
            cell([](simulator::SimulatorOptions& o) { o.listenAddress = test::ownAddress(2); });
        DashboardClient other(later->host());
        other.connect();
        QVERIFY_EXCEPTION_THROWN(other.setUserRole(ur_rtde::UserRole::OPERATOR), std::logic_error);
    }

    void scriptsAreSentAndPrepared() {
        const auto robot = cell();
        ScriptClient client(robot->host(), 5, 22);
        QVERIFY(!client.isConnected());
        QVERIFY(!client.sendScriptCommand("sync()"));
        client.connect();
        QVERIFY(client.isConnected());
        const auto outputs = [&](std::uint64_t bits) {
            return robot->until(
                [bits](const simulator::SimulatedState& truth) { return truth.digitalOutputs == bits; });
        };
        QVERIFY(client.sendScriptCommand("set_standard_digital_out(0, True)"));
        QVERIFY(outputs(1));
        const std::string file = folder_.filePath("mine.script").toStdString();
        std::ofstream(file) << "def mine():\n$5.4   set_standard_digital_out(1, True)\n"
                               "$6.0   unknown_function()\n# place\n  sync()\nend\n";
        client.setScriptFile(file);
        client.setScriptInjection("# place\n", "  set_standard_digital_out(3, True)\n");
        // Replaces the previous injection.
        client.setScriptInjection("# place\n", "  set_standard_digital_out(2, True)\n");
        const QString text = QString::fromStdString(client.getScript());
        QVERIFY(text.contains("set_standard_digital_out(2, True)"));
        QVERIFY(!text.contains("unknown_function"));
        QVERIFY(!text.contains("$"));
        QVERIFY(client.sendScript());
        QVERIFY(outputs(7));
        const std::string plain = folder_.filePath("plain.script").toStdString();
        std::ofstream(plain) << "def plain():\n  set_standard_digital_out(0, False)\n  sync()\nend\n";
        QVERIFY(client.sendScript(plain));
        QVERIFY(outputs(6));
        QVERIFY(!client.sendScript(folder_.filePath("missing.script").toStdString()));
        client.disconnect();
        QVERIFY(!client.isConnected());
    }

    void linesForNewerSoftwareAreDropped() {
        ScriptClient old("127.0.0.1", 3, 15);
        std::string text = "a\n$3.5 b\n$5.4 c\n$5.10|3.15 d\n$3.16 e\n";
        QVERIFY(old.removeUnsupportedFunctions(text));
        QCOMPARE(text, std::string("a\n     b\n           d\n"));
        ScriptClient recent("127.0.0.1", 5, 9);
        text = "$3.5 b\n$5.10|3.15 d\n$5.9 f\n";
        QVERIFY(recent.removeUnsupportedFunctions(text));
        QCOMPARE(text, std::string("     b\n     f\n"));
        text = "$x y\n";
        QVERIFY(!recent.removeUnsupportedFunctions(text));
        recent.setScriptInjection("here\n", "there\n");
        text = "here\nend\n";
        QVERIFY(recent.scanAndInjectAdditionalScriptCode(text));
        QCOMPARE(text, std::string("here\nthere\nend\n"));
        text = "nowhere";
        QVERIFY(!recent.scanAndInjectAdditionalScriptCode(text));
    }

    void gripperIsActivatedAndMoved() {
        test::GripperPeer peer;
        RobotiqGripper gripper("127.0.0.1", peer.port());
        QVERIFY(!gripper.isConnected());
        QVERIFY_EXCEPTION_THROWN(gripper.isActive(), std::runtime_error);
        gripper.connect();
        QVERIFY(gripper.isConnected());
        QVERIFY(!gripper.isActive());
        gripper.activate();
        QVERIFY(gripper.isActive());
        gripper.autoCalibrate();
        int lowest = 0;
        int highest = 0;
        gripper.getNativePositionRange(lowest, highest);
        QCOMPARE(lowest, peer.kOpen);
        QCOMPARE(highest, peer.kClosed);
        QVERIFY(gripper.isOpen());
        QCOMPARE(gripper.close(1.0F, 0.0F, RobotiqGripper::WAIT_FINISHED), int(RobotiqGripper::AT_DEST));
        QVERIFY(gripper.isClosed());
        QCOMPARE(gripper.getClosedPosition(), 0.0F);
        QCOMPARE(gripper.getOpenPosition(), 1.0F);
        QCOMPARE(gripper.open(), int(RobotiqGripper::MOVING));
        QCOMPARE(gripper.getVars({"SPE", "FOR"}), (std::vector<int>{255, 0}));  // default: minimum force
        QCOMPARE(gripper.waitForMotionComplete(), RobotiqGripper::AT_DEST);
        QCOMPARE(gripper.getCurrentPosition(), 1.0F);

        gripper.setUnit(RobotiqGripper::POSITION, RobotiqGripper::UNIT_MM);
        gripper.setPositionRange_mm(50);
        QCOMPARE(gripper.move(25.0F, -1.0F, -1.0F, RobotiqGripper::WAIT_FINISHED),
                 int(RobotiqGripper::AT_DEST));
        QVERIFY(std::abs(gripper.getCurrentPosition() - 25.0F) < 0.3F);
        gripper.setUnit(RobotiqGripper::SPEED, RobotiqGripper::UNIT_PERCENT);
        QVERIFY(std::abs(gripper.setSpeed(50.0F) - 50.0F) < 0.3F);
        QCOMPARE(gripper.setForce(2.0F), 1.0F);  // limited to the maximum

        QVERIFY(gripper.setVar("FOR", 10));
        QVERIFY(gripper.setVars({{"SPE", 20}, {"FOR", 30}}));
        QCOMPARE(gripper.getVar("SPE"), 20);
        QCOMPARE(gripper.getVars({"SPE", "FOR"}), (std::vector<int>{20, 30}));
        QCOMPARE(gripper.faultStatus(), int(RobotiqGripper::NO_FAULT));
        QCOMPARE(gripper.objectDetectionStatus(), RobotiqGripper::AT_DEST);
        gripper.emergencyRelease(RobotiqGripper::OPEN);
        QCOMPARE(gripper.faultStatus(), int(RobotiqGripper::FAULT_EMCY_RELEASE_FINISHED));
        QCOMPARE(gripper.getVar("ARD"), 1);  // opening
        gripper.setNativePositionRange(0, 255);
        QVERIFY_EXCEPTION_THROWN(gripper.setNativePositionRange(10, 5), std::range_error);
        QCOMPARE(gripper.move(90.0F, -1.0F, 3.0F, RobotiqGripper::WAIT_FINISHED),
                 int(RobotiqGripper::AT_DEST));
        QCOMPARE(gripper.getVars({"PRE", "FOR"}), (std::vector<int>{0, 255}));  // limited to their ranges
        QVERIFY_EXCEPTION_THROWN(gripper.move(std::nanf("")), std::invalid_argument);
        gripper.disconnect();
        QVERIFY(!gripper.isConnected());
    }

    void utilitiesWorkAsDocumented() {
        QCOMPARE(RTDEUtility::split("a,b,,c,", ','), (std::vector<std::string>{"a", "b", "", "c"}));
        QVERIFY(RTDEUtility::split("", ',').empty());
        for (const char* yes : {"1", "-2.5", "+3", "0.25"}) {
            QVERIFY2(RTDEUtility::isNumber(yes), yes);
        }
        for (const char* no : {"", "x", "1x", "1 ", "--1"}) {
            QVERIFY2(!RTDEUtility::isNumber(no), no);
        }
        const auto begin = std::chrono::steady_clock::now();
        RTDEUtility::preciseSleep(0.003);
        QVERIFY(std::chrono::steady_clock::now() - begin >= std::chrono::milliseconds(3));
        RTDEUtility::waitPeriod(begin, 0.006);
        QVERIFY(std::chrono::steady_clock::now() - begin >= std::chrono::milliseconds(6));
        QVERIFY(!RTDEUtility::setRealtimePriority(0));
        QFile flag("/sys/kernel/realtime");
        const bool said = flag.open(QIODevice::ReadOnly) && flag.readAll().trimmed() == "1";
        QCOMPARE(RTDEUtility::isRealtimeKernelAvailable(), said);
    }

    void pathsAreConvertedToScript() {
        Path path;
        path.appendMovejPath({{0, -1.5, 1, 0, 0.5, 0, 1.05, 1.4, 0.02}});
        path.appendMovelPath({{0.1, 0.2, 0.3, 0, 3.14, 0, 0.25, 1.2, 0}});
        path.addEntry({PathEntry::MoveC,
                       PathEntry::PositionTcpPose,
                       {0.1, 0.2, 0.3, 0, 0, 0, 0.2, 0.3, 0.4, 0, 0, 0, 0.25, 1.2, 0.01}});
        QCOMPARE(path.toScriptCode(),
                 std::string("\tsignal_async_progress(0)\n\tmovej([0,-1.5,1,0,0.5,0],a=1.4,v=1.05,r=0.02)\n"
                             "\tsignal_async_progress(1)\n\tmovel(p[0.1,0.2,0.3,0,3.14,0],a=1.2,v=0.25,r=0)\n"
                             "\tsignal_async_progress(2)\n\tmovec(p[0.1,0.2,0.3,0,0,0],p[0.2,0.3,0.4,0,0,0],"
                             "a=1.2,v=0.25,r=0.01,mode=0)\n"));
        QCOMPARE(path.waypoints()[1].toScriptCode(),
                 std::string("\tmovel(p[0.1,0.2,0.3,0,3.14,0],a=1.2,v=0.25,r=0)\n"));
        QCOMPARE(path.waypoints()[1].pos_type_, PathEntry::PositionTcpPose);
        QVERIFY_EXCEPTION_THROWN(path.appendMovejPath({{1, 2}}), std::invalid_argument);
    }
};

QTEST_GUILESS_MAIN(TestUrRtdeClients)
#include "tst_ur_rtde_clients.moc"
