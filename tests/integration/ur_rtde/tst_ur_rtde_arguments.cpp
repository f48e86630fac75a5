// SPDX-License-Identifier: MIT
// Invalid arguments fail before anything is sent, and the error names the argument. Destruction is quick,
// regardless of the peer.
#include <ur_rtde/dashboard_client.h>
#include <ur_rtde/robotiq_gripper.h>
#include <ur_rtde/rtde_control_interface.h>
#include <ur_rtde/rtde_io_interface.h>
#include <ur_rtde/rtde_receive_interface.h>
#include <ur_rtde/script_client.h>

#include <QTcpServer>
#include <QTest>
#include <future>
#include <limits>
#include <memory>
#include <vector>

#include "tests/integration/ur_rtde/ur_rtde_cell.h"

using namespace tiller;
using ur_rtde::DashboardClient;
using ur_rtde::PathEntry;
using ur_rtde::RobotiqGripper;
using ur_rtde::RTDEControlInterface;
using ur_rtde::RTDEIOInterface;
using ur_rtde::RTDEReceiveInterface;
using ur_rtde::ScriptClient;
using List = std::vector<double>;

namespace {

const List kQ{-1.6, -1.7, -2.2, -0.8, 1.6, 0};
const List kPose{-0.1, -0.4, 0.2, 0, 3.1, 0};
const List kZeros(6, 0.0);
const double kNan = std::numeric_limits<double>::quiet_NaN();

enum class Wrong { Size, NotANumber, Range };

struct Case {
    const char* what;
    const char* argument;
    Wrong wrong;
    std::function<void(RTDEControlInterface&)> call;
};

using C = RTDEControlInterface;

const std::vector<Case>& cases() {
    static const std::vector<Case> table = {
        {"moveJ size", "q", Wrong::Size,
         [](C& c) {
             c.moveJ(List{1, 2});
         }},
        {"moveJ nan", "q[2]", Wrong::NotANumber,
         [](C& c) {
             c.moveJ(List{0, 0, kNan, 0, 0, 0});
         }},
        {"moveJ degrees", "q[1]", Wrong::Range,
         [](C& c) {
             c.moveJ(List{0, -90, 0, 0, 0, 0});
         }},
        {"moveJ speed", "speed", Wrong::Range, [](C& c) { c.moveJ(kQ, 60.0); }},
        {"moveJ above the arm's own limit", "speed", Wrong::Range, [](C& c) { c.moveJ(kQ, 3.5); }},
        {"moveL above ur_rtde's limit", "speed", Wrong::Range, [](C& c) { c.moveL(kPose, 3.1); }},
        {"moveL endless", "acceleration", Wrong::NotANumber,
         [](C& c) { c.moveL(kPose, 0.1, std::numeric_limits<double>::infinity()); }},
        {"moveJ at no speed", "speed", Wrong::Range, [](C& c) { c.moveJ(kQ, 0.0); }},
        {"moveJ without acceleration", "acceleration", Wrong::Range, [](C& c) { c.moveJ(kQ, 1.0, 0.0); }},
        {"moveL at no speed", "speed", Wrong::Range, [](C& c) { c.moveL(kPose, 0.0); }},
        {"moveL_FK without acceleration", "acceleration", Wrong::Range,
         [](C& c) { c.moveL_FK(kQ, 0.1, 0.0); }},
        {"servoC at no speed", "speed", Wrong::Range, [](C& c) { c.servoC(kPose, 0.0); }},
        {"moveJ negative", "speed", Wrong::Range, [](C& c) { c.moveJ(kQ, -1.0); }},
        {"moveJ acceleration", "acceleration", Wrong::Range, [](C& c) { c.moveJ(kQ, 1.0, 500.0); }},
        {"moveJ path", "path[0]", Wrong::Size, [](C& c) { c.moveJ(std::vector<List>{kQ}); }},
        {"moveJ_IK millimetres", "pose[0]", Wrong::Range,
         [](C& c) {
             c.moveJ_IK({-120, -400, 200, 0, 3, 0});
         }},
        {"moveL size", "pose", Wrong::Size, [](C& c) { c.moveL(List{}); }},
        {"moveL degrees", "pose[4]", Wrong::Range,
         [](C& c) {
             c.moveL({-0.1, -0.4, 0.2, 0, 180, 0});
         }},
        {"moveL speed in mm", "speed", Wrong::Range, [](C& c) { c.moveL(kPose, 250); }},
        {"moveL_FK degrees", "q[0]", Wrong::Range,
         [](C& c) {
             c.moveL_FK({90, 0, 0, 0, 0, 0});
         }},
        {"moveUntilContact", "xd[2]", Wrong::Range,
         [](C& c) {
             c.moveUntilContact({0, 0, -50, 0, 0, 0});
         }},
        {"contact direction", "direction", Wrong::Size,
         [](C& c) {
             c.moveUntilContact(kZeros, {0, 0});
         }},
        {"speedJ", "qd[0]", Wrong::Range,
         [](C& c) {
             c.speedJ({30, 0, 0, 0, 0, 0});
         }},
        {"speedJ nan", "acceleration", Wrong::NotANumber, [](C& c) { c.speedJ(kZeros, kNan); }},
        {"speedL", "xd[0]", Wrong::Range,
         [](C& c) {
             c.speedL({100, 0, 0, 0, 0, 0});
         }},
        {"speedStop", "a", Wrong::Range, [](C& c) { c.speedStop(-1); }},
        {"servoJ gain", "gain", Wrong::Range, [](C& c) { c.servoJ(kQ, 0, 0, 0.002, 0.1, 50); }},
        {"servoJ lookahead", "lookahead_time", Wrong::Range, [](C& c) { c.servoJ(kQ, 0, 0, 0.002, 1, 300); }},
        {"servoJ time", "time", Wrong::NotANumber, [](C& c) { c.servoJ(kQ, 0, 0, kNan, 0.1, 300); }},
        {"servoL", "pose[5]", Wrong::NotANumber,
         [](C& c) {
             c.servoL({0, 0, 0, 0, 0, kNan}, 0, 0, 0, 0.1, 300);
         }},
        {"servoC", "blend", Wrong::Range, [](C& c) { c.servoC(kPose, 0.1, 1, 10); }},
        {"servoStop", "a", Wrong::NotANumber, [](C& c) { c.servoStop(kNan); }},
        {"stopJ", "a", Wrong::Range, [](C& c) { c.stopJ(1000); }},
        {"stopL", "a", Wrong::Range, [](C& c) { c.stopL(0); }},
        {"jog feature", "feature", Wrong::Range, [](C& c) { c.jogStart(kZeros, 7); }},
        {"jog frame", "custom_frame", Wrong::Size, [](C& c) { c.jogStart(kZeros, C::FEATURE_CUSTOM); }},
        {"forceMode frame", "task_frame", Wrong::Size,
         [](C& c) {
             c.forceMode({0}, {0, 0, 1, 0, 0, 0}, kZeros, 2, kZeros);
         }},
        {"forceMode selection", "selection_vector[2]", Wrong::Range,
         [](C& c) {
             c.forceMode(kZeros, {0, 0, 2, 0, 0, 0}, kZeros, 2, kZeros);
         }},
        {"forceMode type", "type", Wrong::Range,
         [](C& c) {
             c.forceMode(kZeros, {0, 0, 1, 0, 0, 0}, kZeros, 4, kZeros);
         }},
        {"forceMode wrench", "wrench[0]", Wrong::Range,
         [](C& c) {
             c.forceMode(kZeros, {0, 0, 1, 0, 0, 0}, {1e6, 0, 0, 0, 0, 0}, 2, kZeros);
         }},
        {"damping", "damping", Wrong::Range, [](C& c) { c.forceModeSetDamping(2); }},
        {"scaling", "scaling", Wrong::Range, [](C& c) { c.forceModeSetGainScaling(3); }},
        {"payload", "mass", Wrong::Range, [](C& c) { c.setPayload(-1); }},
        {"payload cog", "cog[2]", Wrong::Range,
         [](C& c) {
             c.setPayload(1, {0, 0, 50});
         }},
        {"tcp in mm", "tcp_offset[2]", Wrong::Range,
         [](C& c) {
             c.setTcp({0, 0, 100, 0, 0, 0});
         }},
        {"gravity", "direction", Wrong::Size,
         [](C& c) {
             c.setGravity({0, 0});
         }},
        {"watchdog", "min_frequency", Wrong::Range, [](C& c) { c.setWatchdog(0); }},
        {"freedrive axes", "free_axes", Wrong::Size, [](C& c) { c.freedriveMode({1}); }},
        {"history", "steps", Wrong::Range, [](C& c) { c.getActualJointPositionsHistory(-1); }},
        {"ik near", "qnear", Wrong::Size, [](C& c) { c.getInverseKinematics(kPose, {1}); }},
        {"fk", "q[0]", Wrong::Range,
         [](C& c) {
             c.getForwardKinematics({90, 0, 0, 0, 0, 0});
         }},
        {"poseTrans", "p_from_to", Wrong::Size, [](C& c) { c.poseTrans(kZeros, {}); }},
        {"limits", "pose", Wrong::Size, [](C& c) { c.isPoseWithinSafetyLimits({}); }},
        {"tool contact", "direction", Wrong::Size, [](C& c) { c.toolContact({}); }},
        {"external force", "external_force_torque[1]", Wrong::NotANumber,
         [](C& c) {
             c.setExternalForceTorque({0, kNan, 0, 0, 0, 0});
         }},
        {"sensor", "sensor_cog[0]", Wrong::Range,
         [](C& c) {
             c.ftRtdeInputEnable(true, 0, {0, 0, 0}, {9, 0, 0});
         }},
        {"path entry", "parameters", Wrong::Size,
         [](C&) {
             PathEntry(PathEntry::MoveL, PathEntry::PositionTcpPose, {1, 2, 3});
         }},
        {"blend", "blend", Wrong::Range,
         [](C&) {
             PathEntry(PathEntry::MoveL, PathEntry::PositionTcpPose, {0, 0, 0, 0, 0, 0, 0.1, 1, 50});
         }},
        {"empty path", "path", Wrong::Size, [](C& c) { c.movePath({}); }},
        {"script name", "function_name", Wrong::Size, [](C& c) { c.sendCustomScriptFunction("", "sync()"); }},
        {"script file", "file_path", Wrong::Size, [](C& c) { c.sendCustomScriptFile("/nonexistent"); }},
    };
    return table;
}

/// A peer that accepts all connections and sends nothing.
class MuteServer {
public:
    explicit MuteServer(int port) {
        std::promise<bool> ready;
        auto listening = ready.get_future();
        thread_ = std::thread([this, port, &ready] {
            QTcpServer server;
            ready.set_value(server.listen(QHostAddress(test::ownAddress(3)), static_cast<quint16>(port)));
            while (!quit_) {
                server.waitForNewConnection(20);
            }
        });
        listening.wait();
    }
    ~MuteServer() {
        quit_ = true;
        thread_.join();
    }

private:
    std::atomic<bool> quit_{false};
    std::thread thread_;
};

}  // namespace

class TestUrRtdeArguments : public QObject {
    Q_OBJECT

private:
    std::unique_ptr<test::UrRtdeCell> cell_;
    std::unique_ptr<RTDEControlInterface> control_;

private Q_SLOTS:
    void initTestCase() {
        cell_ = std::make_unique<test::UrRtdeCell>();
        control_ = std::make_unique<RTDEControlInterface>(cell_->host());
    }
    void cleanupTestCase() {
        control_.reset();
        cell_.reset();
    }

    void wrongArgumentsAreNamed_data() {
        QTest::addColumn<int>("index");
        for (int i = 0; i < static_cast<int>(cases().size()); ++i) {
            QTest::newRow(cases()[static_cast<std::size_t>(i)].what) << i;
        }
    }
    void wrongArgumentsAreNamed() {
        QFETCH(int, index);
        const Case& wrong = cases()[static_cast<std::size_t>(index)];
        const auto status = control_->getAsyncOperationProgressEx();
        QByteArray message;
        bool rightKind = false;
        try {
            wrong.call(*control_);
        } catch (const std::range_error& error) {
            rightKind = wrong.wrong == Wrong::Range;
            message = error.what();
        } catch (const std::invalid_argument& error) {
            rightKind = wrong.wrong != Wrong::Range;
            message = error.what();
        }
        QVERIFY2(rightKind, message.constData());
        QVERIFY2(message.startsWith(wrong.argument), message.constData());
        // The call did not start an operation.
        QVERIFY(status.equals(control_->getAsyncOperationProgressEx()));
    }

    void otherInterfacesAlsoCheckArguments() {
        RTDEIOInterface io(cell_->host());
        QVERIFY_EXCEPTION_THROWN(io.setStandardDigitalOut(8, true), std::range_error);
        QVERIFY_EXCEPTION_THROWN(io.setConfigurableDigitalOut(8, true), std::range_error);
        QVERIFY_EXCEPTION_THROWN(io.setToolDigitalOut(2, true), std::range_error);
        QVERIFY_EXCEPTION_THROWN(io.setSpeedSlider(50), std::range_error);
        QVERIFY_EXCEPTION_THROWN(io.setSpeedSlider(kNan), std::invalid_argument);
        QVERIFY_EXCEPTION_THROWN(io.setAnalogOutputVoltage(0, 5.0), std::range_error);
        QVERIFY_EXCEPTION_THROWN(io.setAnalogOutputCurrent(2, 0.5), std::range_error);
        QVERIFY_EXCEPTION_THROWN(io.setInputIntRegister(17, 1), std::range_error);
        QVERIFY_EXCEPTION_THROWN(io.setInputDoubleRegister(18, kNan), std::invalid_argument);
        QVERIFY_EXCEPTION_THROWN(RTDEIOInterface(""), std::invalid_argument);
        QVERIFY_EXCEPTION_THROWN(RTDEReceiveInterface(""), std::invalid_argument);
        QVERIFY_EXCEPTION_THROWN(RTDEReceiveInterface("127.0.0.1", 1000.0), std::range_error);
        QVERIFY_EXCEPTION_THROWN(RTDEReceiveInterface("127.0.0.1", -1.0, {"nonsense"}),
                                 std::invalid_argument);
        QVERIFY_EXCEPTION_THROWN(RTDEControlInterface("127.0.0.1", kNan), std::invalid_argument);
        QVERIFY_EXCEPTION_THROWN(RTDEControlInterface("127.0.0.1", -1.0, 1, 0), std::range_error);
        QVERIFY_EXCEPTION_THROWN(RTDEReceiveInterface("127.0.0.1", -1.0, {}, false, false, 100),
                                 std::range_error);
        QVERIFY_EXCEPTION_THROWN(DashboardClient("127.0.0.1", 0), std::range_error);
        QVERIFY_EXCEPTION_THROWN(DashboardClient(""), std::invalid_argument);
        QVERIFY_EXCEPTION_THROWN(ScriptClient("127.0.0.1", 5, 0, 70000), std::range_error);
        QVERIFY_EXCEPTION_THROWN(RobotiqGripper(""), std::invalid_argument);
    }

    void missingRobotIsARuntimeError() {
        const std::string nobody = test::ownAddress(9).toStdString();
        QVERIFY_EXCEPTION_THROWN(RTDEControlInterface{nobody}, std::runtime_error);
        QVERIFY_EXCEPTION_THROWN(RTDEReceiveInterface{nobody}, std::runtime_error);
        QVERIFY_EXCEPTION_THROWN(RTDEIOInterface{nobody}, std::runtime_error);
        DashboardClient dashboard(nobody);
        QVERIFY_EXCEPTION_THROWN(dashboard.connect(), std::runtime_error);
        ScriptClient script(nobody, 5, 0);
        QVERIFY_EXCEPTION_THROWN(script.connect(), std::runtime_error);
        RobotiqGripper gripper(nobody);
        QVERIFY_EXCEPTION_THROWN(gripper.connect(), std::runtime_error);
    }

    // The robot hangs during all activities: connections remain open, and no data arrive. Robot time does not
    // advance, so waiting for it would make the test hang. tests/benchmarks/backend_performance measures the
    // duration.
    void closingIsQuickWithAHangingRobot() {
        test::UrRtdeCell hanging(
            [](simulator::SimulatorOptions& o) { o.listenAddress = test::ownAddress(2); });
        auto control = std::make_unique<RTDEControlInterface>(hanging.host());
        auto receive = std::make_unique<RTDEReceiveInterface>(hanging.host());
        auto io = std::make_unique<RTDEIOInterface>(hanging.host());
        DashboardClient dashboard(hanging.host());
        dashboard.connect();
        auto moving = std::async(std::launch::async, [&] { return control->moveJ(kQ, 0.05); });
        QVERIFY(hanging.until(
            [&](const simulator::SimulatedState&) { return control->getAsyncOperationProgress() >= 0; }));
        hanging.robot.silence(true);
        hanging.freeze(true);
        control->disconnect();
        QVERIFY(!moving.get());
        receive->disconnect();
        io->disconnect();
        dashboard.disconnect();
        control.reset();
        receive.reset();
        io.reset();
        hanging.robot.silence(false);
        hanging.freeze(false);
    }

    void silentPeersCauseATimeout() {
        const std::string host = test::ownAddress(3).toStdString();
        const MuteServer dashboardPort(29999);
        const MuteServer gripperPort(63352);
        DashboardClient dashboard(host);
        QVERIFY_EXCEPTION_THROWN(dashboard.connect(50), std::runtime_error);
        QVERIFY(!dashboard.isConnected());
        RobotiqGripper gripper(host);
        gripper.connect();
        QVERIFY_EXCEPTION_THROWN(gripper.getVar("POS"), std::runtime_error);
        QVERIFY(!gripper.isConnected());
    }

    // The URCap of the controller requests the program from this computer.
    void theUrCapGetsTheProgram() {
        QTcpServer free;
        QVERIFY(free.listen(QHostAddress::LocalHost));
        const int port = free.serverPort();
        free.close();
        RTDEControlInterface control(cell_->host(), -1.0,
                                     RTDEControlInterface::FLAG_USE_EXT_UR_CAP |
                                         RTDEControlInterface::FLAG_NO_WAIT |
                                         RTDEControlInterface::FLAG_UPPER_RANGE_REGISTERS,
                                     port);
        // Other connections that send nothing, e.g. from a port scanner, must not delay the request.
        std::vector<std::unique_ptr<QTcpSocket>> silent;
        for (int i = 0; i < 12; ++i) {
            silent.push_back(std::make_unique<QTcpSocket>());
            silent.back()->connectToHost(QHostAddress::LocalHost, static_cast<quint16>(port));
            QVERIFY(silent.back()->waitForConnected(10'000));
        }
        QTcpSocket cap;
        cap.connectToHost(QHostAddress::LocalHost, static_cast<quint16>(port));
        QVERIFY(cap.waitForConnected(10'000));
        cap.write("request_program\n");
        QByteArray text;
        while (!text.contains("# NODE_CONTROL_LOOP_ENDS") && cap.waitForReadyRead(10'000)) {
            text += cap.readAll();
        }
        QVERIFY(text.contains("\n# HEADER_BEGIN\n"));
        QVERIFY(text.contains("\n# HEADER_END\n"));
        QVERIFY(text.contains("\ntiller_FIRST = 24\n"));
        QVERIFY(!text.contains("def rtde_control") && !text.contains("def tiller_control"));
    }
};

QTEST_GUILESS_MAIN(TestUrRtdeArguments)
#include "tst_ur_rtde_arguments.moc"
