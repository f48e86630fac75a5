// SPDX-License-Identifier: MIT
//
// Script facilities other than the arm and registers: named frames, terminal actions, the Modbus map, values
// entered by operators, payload estimates, software versions.

#include <QTcpServer>
#include <QTcpSocket>
#include <QTest>

#include "robot/simulator/controller/controller_model.h"
#include "robot/simulator/host/script_host.h"
#include "robot/simulator/programs/program_runner.h"

using namespace tiller;
using namespace tiller::simulator;
using Unit = urscript::SourceSplitter::Unit;

namespace {

SimulatorOptions running(SoftwareVersion software = {5, 22, 1, 0}) {
    SimulatorOptions options;
    options.poweredOn = true;
    options.software = software;
    return options;
}

constexpr SoftwareVersion kX{10, 12, 0, 0};

/// A simulated robot that records the messages it sends to primary clients.
struct Robot {
    explicit Robot(const SimulatorOptions& options = running()) : plant(options) {}

    void submit(const std::string& body) {
        plant.programs().submit({Unit::Kind::Program, "def t():\n" + body + "\nend\n"});
    }
    void steps(int count) {
        for (int i = 0; i < count; ++i) {
            plant.step();
            for (const primary::Bytes& m : plant.takeOutbox()) {
                messages.emplace_back(reinterpret_cast<const char*>(m.data()),
                                      static_cast<qsizetype>(m.size()));
            }
        }
    }
    /// Runs a program to its end and returns its text messages.
    QByteArrayList reported(const std::string& body) {
        messages.clear();
        submit(body);
        steps(5);
        return bodies(0);
    }
    /// Bodies of the robot messages of one type.
    QByteArrayList bodies(int kind) const {
        QByteArrayList out;
        for (const QByteArray& m : messages) {
            if (m[14] == kind) {
                out << m.mid(15);
            }
        }
        return out;
    }
    /// Text of the last runtime exception.
    QByteArray error() const { return bodies(10).isEmpty() ? QByteArray() : bodies(10).last().mid(8); }

    ControllerModel plant;
    std::vector<QByteArray> messages;
};

}  // namespace

class TestScriptEquipment : public QObject {
    Q_OBJECT

private Q_SLOTS:
    // ---- named frames
    void framesAreConvertedIntoEachOther() {
        Robot robot(running(kX));
        QCOMPARE(
            robot.reported("add_frame(\"table\", p[1,0,0,0,0,1.570796326794897])\n"
                           "add_frame(\"part\", p[0,0.5,0,0,0,0], \"table\")\n"
                           "textmsg(to_str(get_pose(\"part\", \"base\")))\n"
                           "textmsg(to_str(get_pose(\"part\", \"table\")))\n"
                           "textmsg(to_str(get_pose(\"part\", \"table\", \"base\")))\n"
                           "textmsg(to_str(convert_pose(p[0,0,0,0,0,0], \"base\", \"table\")))\n"
                           "textmsg(get_frame_parent(\"part\"), get_children(\"table\"))\n"
                           "textmsg(is_frame(\"part\"), is_frame(\"nothing\"))"),
            (QByteArrayList{"p[0.5, 0, 0, 0, 0, 1.570796]", "p[0, 0.5, 0, 0, 0, 0]", "p[-0.5, 0, 0, 0, 0, 0]",
                            "p[0, 1, 0, 0, 0, -1.570796]", "table[part]", "TrueFalse"}));
    }
    void attachedFramesMoveWithTheArm() {
        Robot robot(running(kX));
        QCOMPARE(
            robot.reported("t = get_pose(\"tcp\", \"base\")\nadd_frame(\"held\", p[0,0,0.1,0,0,0], \"tcp\")\n"
                           "add_frame(\"lying\", t)\nbefore = get_pose(\"lying\", \"base\")\n"
                           "attach_frame(\"lying\", \"flange\")\n"
                           "textmsg(pose_dist(before, get_pose(\"lying\", \"base\")) < 0.000001)\n"
                           "textmsg(get_frame_parent(\"lying\"))\nattach_frame(\"held\", \"lying\")\n"
                           "delete_frame(\"lying\")\ntextmsg(get_frame_parent(\"held\"))"),
            (QByteArrayList{"True", "flange", "flange"}));
        robot.submit("movej([-1.2,-1.7,-2.2,-0.8,1.6,0], t=1)");
        robot.steps(700);
        QCOMPARE(robot.reported("d = pose_sub(get_pose(\"held\", \"base\"), get_actual_tcp_pose())\n"
                                "textmsg(norm([d[0], d[1], d[2]]) < 0.11)"),
                 QByteArrayList{"True"});
    }
    void framesAreMovedAndDeleted() {
        Robot robot(running(kX));
        QCOMPARE(robot.reported("add_frame(\"a\", p[1,0,0,0,0,0])\nadd_frame(\"b\", p[0,1,0,0,0,0], \"a\")\n"
                                "move_frame(\"a\", p[2,0,0,0,0,0])\ntextmsg(get_pose(\"b\", \"base\"))\n"
                                "move_frame(\"b\", p[0,0,0,0,0,0])\ntextmsg(get_pose(\"b\", \"a\"))\n"
                                "delete_all_frames()\ntextmsg(is_frame(\"a\"))"),
                 (QByteArrayList{"p[2,1,0,0,0,0]", "p[-2,0,0,0,0,0]", "False"}));
    }
    void wrongFramesEndTheProgram_data() {
        QTest::addColumn<QString>("body");
        QTest::addColumn<QByteArray>("error");
        QTest::newRow("unknown") << "x = get_pose(\"a\", \"base\")" << QByteArray("Unknown frame 'a'");
        QTest::newRow("twice") << "add_frame(\"a\", p[0,0,0,0,0,0])\nadd_frame(\"a\", p[0,0,0,0,0,0])"
                               << QByteArray("Frame 'a' already exists");
        QTest::newRow("fixed") << "delete_frame(\"base\")" << QByteArray("Unknown frame 'base'");
        QTest::newRow("loop") << "add_frame(\"a\", p[0,0,0,0,0,0])\nadd_frame(\"b\", p[0,0,0,0,0,0], \"a\")\n"
                                 "attach_frame(\"a\", \"b\")"
                              << QByteArray("Frame 'a' cannot be attached to itself");
    }
    void wrongFramesEndTheProgram() {
        QFETCH(QString, body);
        QFETCH(QByteArray, error);
        Robot robot(running(kX));
        robot.reported(body.toStdString());
        QCOMPARE(robot.error(), error);
    }
    void attachedMassesFormThePayload() {
        Robot robot(running(kX));
        robot.reported(
            "add_frame(\"a\", p[0,0,0.1,0,0,0], \"flange\")\nadd_frame(\"b\", p[0.1,0,0,0,0,0], \"a\")\n"
            "add_frame(\"far\", p[0,0,0,0,0,0])\nset_mass_properties(\"far\", 9, [0,0,0], [0,0,0,0,0,0])\n"
            "set_mass_properties(\"a\", 1, [0,0,0], [0.01,0.01,0.01,0,0,0])\n"
            "set_mass_properties(\"b\", 1, [0,0,0], [0,0,0,0,0,0])\nset_payload_from_attached_frames()");
        QCOMPARE(robot.error(), QByteArray());
        const arm::Payload& load = robot.plant.arm().payload();
        QVERIFY(std::abs(load.mass - 2) < 1e-12);
        QVERIFY((load.centreOfGravity - Eigen::Vector3d(0.05, 0, 0.1)).norm() < 1e-9);
        // Steiner's theorem: two masses at 0.05 m on either side of the centre of gravity, plus the inertia
        // of the body.
        QVERIFY(std::abs(load.inertia[0] - 0.01) < 1e-9);
        QVERIFY(std::abs(load.inertia[1] - (0.01 + 2 * 0.05 * 0.05)) < 1e-9);
    }
    void optimoveMovesToNamedFrames() {
        Robot robot(running(kX));
        robot.submit(
            "add_frame(\"goal\", pose_trans(get_actual_tcp_pose(), p[0,0,-0.05,0,0,0]))\n"
            "optimovel(struct(pose=p[0,0,-0.02,0,0,0], frame=\"goal\"), a=0.5, v=0.5)\n"
            "textmsg(norm(get_pose(\"goal\", \"tcp\")))");
        robot.steps(3000);
        QCOMPARE(robot.error(), QByteArray());
        QVERIFY(std::abs(robot.bodies(0).value(0).toDouble() - 0.02) < 1e-3);
    }

    // ---- terminals
    void outputsFollowTheProgram() {
        Robot robot;
        robot.reported(
            "set_runstate_standard_digital_output_to_value(0, 1)\n"
            "set_runstate_configurable_digital_output_to_value(1, 2)\n"
            "set_runstate_tool_digital_output_to_value(0, 3)\n"
            "set_runstate_gp_boolean_output_to_value(65, 2)\n"
            "set_runstate_standard_analog_output_to_value(1, 2)\nset_standard_digital_out(0, True)\n"
            "set_standard_digital_out(5, True)");
        robot.steps(5);
        QCOMPARE(robot.plant.pins().digitalOutputs, std::uint64_t((1 << 9) | (1 << 5)));
        QVERIFY(robot.plant.registers().output.bits[65]);
        QCOMPARE(robot.plant.pins().analogOutputLevels[1], 1.0);
        robot.submit("sleep(0.05)");
        robot.steps(10);
        QVERIFY(Pins::bit(robot.plant.pins().digitalOutputs, kToolPin));
        robot.steps(40);
        QVERIFY(!Pins::bit(robot.plant.pins().digitalOutputs, kToolPin));
    }
    void listedOutputsAreHighWhileAProgramRuns() {
        Robot robot;
        robot.reported("set_runstate_outputs([1, 4])");
        robot.submit("sleep(0.05)");
        robot.steps(10);
        QCOMPARE(robot.plant.pins().digitalOutputs, std::uint64_t((1 << 1) | (1 << 4)));
        robot.steps(40);
        QCOMPARE(robot.plant.pins().digitalOutputs, std::uint64_t(0));
        robot.reported("set_runstate_outputs([])");
        robot.submit("sleep(0.05)");
        robot.steps(10);
        QCOMPARE(robot.plant.pins().digitalOutputs, std::uint64_t(0));
    }
    void inputsActAsFreedriveButtons() {
        Robot robot;
        robot.reported("set_standard_digital_input_action(2, \"freedrive\")");
        robot.steps(5);
        Pins::setBit(robot.plant.pins().digitalInputs, 2, true);
        robot.steps(2);
        QVERIFY(robot.plant.arm().compliance().isFreedrive());
        Pins::setBit(robot.plant.pins().digitalInputs, 2, false);
        robot.steps(2);
        QVERIFY(!robot.plant.arm().compliance().isFreedrive());
        robot.reported("set_input_actions_to_default()");
        Pins::setBit(robot.plant.pins().digitalInputs, 2, true);
        robot.steps(5);
        QVERIFY(!robot.plant.arm().compliance().isFreedrive());
    }
    void theToolOutputsHaveTheirModes() {
        Robot robot;
        QCOMPARE(robot.reported("set_tool_output_mode(1)\nset_tool_digital_output_mode(1, 3)\nsync()\n"
                                "textmsg(get_rtde_value(\"tool_output_mode\"))\n"
                                "textmsg(get_rtde_value(\"tool_digital_output0_mode\"))\n"
                                "textmsg(get_rtde_value(\"tool_digital_output1_mode\"))"),
                 (QByteArrayList{"1", "1", "3"}));
        robot.reported("set_tool_output_mode(2)");
        QVERIFY(robot.error().startsWith("Range error"));
    }
    void modbusRegistersKeepTheirValues() {
        Robot robot;
        robot.reported(
            "write_port_bit(7, True)\nwrite_port_register(130, 65535)\nwrite_port_register(131, -5)");
        QCOMPARE(robot.reported("textmsg([read_port_register(130), read_port_register(131)])\n"
                                "textmsg(read_port_bit(7), read_port_bit(8))"),
                 (QByteArrayList{"[-1,-5]", "TrueFalse"}));
        robot.reported("write_port_register(512, 0)");
        QVERIFY(robot.error().startsWith("Range error"));
    }

    // ---- functions without a test of their own
    void functionsHaveTheirEffect_data() {
        QTest::addColumn<QByteArray>("script");
        QTest::addColumn<QByteArrayList>("texts");
        const auto row = [](const char* name, const char* script, const QByteArrayList& texts) {
            QTest::newRow(name) << QByteArray(script) << texts;
        };
        row("atan", "textmsg(atan(1))", {"0.785398"});
        row("joint speeds and accelerations",
            "thread m():\n speedj([0,0,0,0,0,0.5], 2, 1)\nend\nrun m()\nsleep(0.1)\n"
            "textmsg(get_actual_joint_accelerations()[5] > 1)\n"
            "textmsg(get_target_joint_accelerations()[5] > 1)\nsleep(0.4)\n"
            "textmsg(norm(get_actual_joint_speeds()[5] - 0.5) < 0.05)",
            {"True", "True", "True"});
        row("analog outputs",
            "set_analog_out(1, 0.5)\ntextmsg(get_analog_out(1))\ntextmsg(get_standard_analog_out(1))",
            {"0.012", "0.012"});
        row("analog input range",
            "set_analog_inputrange(0, 1)\nsync()\na = get_rtde_value(\"analog_io_types\")\n"
            "set_analog_inputrange(0, 0)\nsync()\nsync()\ntextmsg(a - get_rtde_value(\"analog_io_types\"))",
            {"1"});
        row("flags", "set_flag(3, True)\ntextmsg(get_flag(3), get_flag(4))", {"TrueFalse"});
        row("tool output",
            "set_tool_digital_out(1, True)\ntextmsg(get_tool_digital_out(1), get_digital_out(9))",
            {"TrueTrue"});
        row("output registers",
            "write_output_boolean_register(2, True)\nwrite_output_float_register(2, 1.5)\n"
            "textmsg(read_output_boolean_register(2), read_output_float_register(2))",
            {"True1.5"});
        row("payload",
            "set_target_payload(1, [0,0,0.1], [0.1,0.2,0.3,0,0,0])\ntextmsg(get_target_payload_inertia())\n"
            "set_payload_cog([0,0,0.2])\ntextmsg(get_target_payload())\ntextmsg(get_target_payload_cog())",
            {"[0.1,0.2,0.3,0,0,0]", "1", "[0,0,0.2]"});
        row("motion settings",
            "jerk_gain_scaling_set(0.5)\nmotion_version_set(2)\n"
            "textmsg(jerk_gain_scaling_get())\ntextmsg(motion_version_get())",
            {"0.5", "2"});
        row("sensors of the tool",
            "textmsg(get_tool_temp() > 10, get_tool_current() >= 0)\ntextmsg(norm(get_tcp_force()) < 5)",
            {"TrueTrue", "True"});
        row("coriolis torques",
            "textmsg(norm(get_coriolis_and_centrifugal_torques()) < 0.001)\n"
            "textmsg(norm(get_coriolis_and_centrifugal_torques(get_actual_joint_positions(), [1,1,1,1,1,1])) "
            "> 0.1)",
            {"True", "True"});
        row("conveyor",
            "encoder_enable_set_tick_count(0, "
            "0)\nset_conveyor_tick_count(5)\ntextmsg(get_conveyor_tick_count())",
            {"5"});
        row("Modbus coil",
            "modbus_add_signal(\"192.168.0.5\", 255, 1, 1, \"c\")\nmodbus_set_output_signal(\"c\", True)\n"
            "sleep(0.5)\ntextmsg(modbus_get_signal_status(\"c\"))\nmodbus_delete_signal(\"c\")\n"
            "x = modbus_get_signal_status(\"c\")\ntextmsg(\"not reached\")",
            {"True"});
    }
    void functionsHaveTheirEffect() {
        QFETCH(QByteArray, script);
        QFETCH(QByteArrayList, texts);
        Robot robot(running({5, 25, 1, 0}));
        robot.submit(script.toStdString());
        robot.steps(5);
        for (int i = 0; i < 1500 && robot.plant.programs().isActive(); ++i) {
            robot.steps(1);
        }
        QCOMPARE(robot.bodies(0), texts);
    }
    void inputsAreReadByAllTheirNames() {
        Robot robot;
        constexpr int kConfigurable = 8, kTool = 16;
        for (const int bit : {2, kConfigurable + 3, kTool + 1}) {
            Pins::setBit(robot.plant.pins().digitalInputs, bit, true);
        }
        robot.steps(2);
        QCOMPARE(robot.reported("textmsg(get_digital_in(2), get_digital_in(3))\n"
                                "textmsg(get_configurable_digital_in(3), get_configurable_digital_in(2))\n"
                                "textmsg(get_digital_in(9), get_tool_digital_in(0))\n"
                                "textmsg(get_analog_in(0) == get_standard_analog_in(0))\n"
                                "textmsg(get_analog_in(2) == get_tool_analog_in(0))"),
                 (QByteArrayList{"TrueFalse", "TrueFalse", "TrueFalse", "True", "True"}));
    }
    // ---- operator requests
    void aQuestionIsShownAndItsAnswerUsed() {
        Robot robot;
        robot.submit(
            "n = request_integer_from_primary_client(\"How many?\")\ntextmsg(n + 1)\n"
            "textmsg(request_string_from_primary_client(\"Who?\"))\n"
            "textmsg(request_boolean_from_primary_client(\"Sure?\"))\n"
            "textmsg(request_float_from_primary_client(\"How much?\"))");
        robot.steps(10);
        QCOMPARE(robot.bodies(9).size(), 1);
        QCOMPARE(robot.bodies(9)[0].mid(4), QByteArray("\0\0\0\1How many?", 13));
        QCOMPARE(robot.plant.programs().state(), RuntimeState::Playing);
        QVERIFY(!robot.plant.scriptHost().answerRequest(std::string("seven")));  // wrong type for the request
        QVERIFY(robot.plant.scriptHost().answerRequest(std::int32_t{7}));
        robot.steps(2);
        QVERIFY(robot.plant.scriptHost().answerRequest(std::string("me")));
        robot.steps(2);
        QVERIFY(robot.plant.scriptHost().answerRequest(true));
        robot.steps(2);
        QVERIFY(robot.plant.scriptHost().answerRequest(0.25));
        robot.steps(5);
        QCOMPARE(robot.bodies(0), (QByteArrayList{"8", "me", "True", "0.25"}));
        QCOMPARE(robot.plant.programs().state(), RuntimeState::Stopped);
        QVERIFY(!robot.plant.scriptHost().answerRequest(true));  // no request is pending
    }

    // ---- other programs
    void aProgramCallsAnXmlRpcServer() {
        QTcpServer server;
        QVERIFY(server.listen(QHostAddress::LocalHost));
        QByteArrayList requests;
        connect(&server, &QTcpServer::newConnection, this, [&] {
            QTcpSocket* client = server.nextPendingConnection();
            connect(client, &QTcpSocket::readyRead, client, [&requests, client] {
                const QByteArray request = client->readAll();
                if (!request.contains("</methodCall>")) {
                    return;
                }
                requests << request;
                client->write(
                    "HTTP/1.0 200 OK\r\nContent-Type: text/xml\r\n\r\n<?xml version='1.0'?>"
                    "<methodResponse><params><param><value><double>0.75</double></value></param>"
                    "</params></methodResponse>");
                client->disconnectFromHost();
            });
        });
        Robot robot;
        robot.submit("h = rpc_factory(\"xmlrpc\", \"http://127.0.0.1:" + std::to_string(server.serverPort()) +
                     "/RPC2\")\ntextmsg(h.width(\"left\", 2) * 2)\ntextmsg(h.width(\"right\", 3))");
        QVERIFY(QTest::qWaitFor([&] {
            robot.steps(1);
            return robot.bodies(0).size() == 2 || !robot.error().isEmpty();
        }));
        QCOMPARE(robot.error(), QByteArray());
        QCOMPARE(robot.bodies(0), (QByteArrayList{"1.5", "0.75"}));
        QCOMPARE(requests.size(), 2);
        QVERIFY(requests[1].contains("<string>right</string>"));
    }

    // ---- model
    void thePayloadIsEstimated() {
        Robot robot;
        const QByteArrayList reported = robot.reported(
            "c = [0.01, -0.02, 0.05]\n"
            "def wrench(r):\n t = pose_trans(p[0,0,0,r[0],r[1],r[2]], p[c[0],c[1],c[2],0,0,0])\n"
            " f = -2.5 * 9.82\n return p[0, 0, f, t[1] * f, -t[0] * f, 0]\nend\n"
            "poses = [p[0,0,0,0,0,0], p[0,0,0,1,0,0], p[0,0,0,0,2,0], p[0,0,0,0.5,0.5,1]]\n"
            "e = estimate_payload(poses, [wrench([0,0,0]), wrench([1,0,0]), wrench([0,2,0]), "
            "wrench([0.5,0.5,1])])\ntextmsg(norm(e.mass - 2.5) < 0.0001)\ntextmsg(norm(e.cog - c) < 0.0001)");
        QCOMPARE(robot.error(), QByteArray());
        QCOMPARE(reported, (QByteArrayList{"True", "True"}));
    }
    void theJacobianDerivativeMatchesItsChange() {
        Robot robot;
        // Compares the derivative with a finite difference of the Jacobian.
        QCOMPARE(
            robot.reported("q = [0.3,-1.2,1.4,-0.9,-1.5,0.2]\nqd = [0.1,0.4,-0.3,0.2,0.5,-0.6]\nh = 0.0001\n"
                           "change = (get_jacobian(q + h * qd) - get_jacobian(q)) / h - "
                           "get_jacobian_time_derivative(q, qd)\nworst = 0\ni = 0\nwhile i < 6:\n"
                           "worst = worst + norm(change[i])\ni = i + 1\nend\ntextmsg(worst < 0.001)\n"
                           "none = get_jacobian_time_derivative(q, [0,0,0,0,0,0])\ntextmsg(norm(none[0]))"),
            (QByteArrayList{"True", "0"}));
    }
    void baseAccelerationIsKept() {
        Robot robot;
        robot.reported("set_base_acceleration([1,2,3])");
        QCOMPARE(robot.reported("textmsg(get_base_acceleration())"), QByteArrayList{"[1,2,3]"});
    }

    // ---- errors
    void aFailingSecondaryProgramIsReportedAsSecondary() {
        Robot robot;
        robot.submit("sleep(1)");
        robot.steps(3);
        robot.plant.programs().submit({Unit::Kind::Secondary, "sec s():\n x = str_sub(\"a\", 5)\nend\n"});
        robot.steps(3);
        QVERIFY(robot.error().startsWith("SECONDARY_PROGRAM_EXCEPTION_XXX: str_sub"));
        QCOMPARE(robot.plant.programs().state(), RuntimeState::Playing);
    }
    void aLoopWithoutTimeStopsTheRobotProtectively() {
        Robot robot;
        robot.submit("while True:\n x = 1\nend");
        robot.steps(30);
        QVERIFY(robot.error().startsWith("Runtime is too much behind"));
        QCOMPARE(robot.plant.safety().mode(), SafetyMode::ProtectiveStop);
        QCOMPARE(robot.plant.programs().state(), RuntimeState::Stopped);
    }
    void infiniteSpeedsAreRefusedByName() {
        Robot robot;
        robot.reported("speedj([1 / 0.0,0,0,0,0,0], 1, 0.1)");
        QCOMPARE(
            robot.error(),
            QByteArray("Type error: speedj argument 'qd' must be a list of six finite numbers, not list"));
        robot.reported("speedl([0,0,0,0,0,0], 0 / 0.0, 0.1)");
        QCOMPARE(robot.error(), QByteArray("Type error: speedl argument 'a' must be a number, not float"));
    }
    void infiniteAccelerationUsesTheMaximum() {
        // The last step of a spline divides by a time of zero. Clients rely on the result.
        Robot robot;
        robot.submit(
            "speedj([0.1,0,0,0,0,0], 1 / 0.0, 0.1)\nspeedl([0,0,0.01,0,0,0], 1 / 0.0, 0.1)\nstopj(4)");
        robot.steps(300);
        QCOMPARE(robot.error(), QByteArray());
        QCOMPARE(robot.plant.safety().mode(), SafetyMode::Normal);
        QCOMPARE(robot.plant.programs().state(), RuntimeState::Stopped);
    }
    void functionsMissingInTheSoftwareDoNotCompile_data() {
        QTest::addColumn<QString>("call");
        QTest::addColumn<QString>("software");
        QTest::addColumn<bool>("known");
        const auto row = [](const char* call, const char* software, bool known) {
            QTest::addRow("%s on %s", call, software) << call << software << known;
        };
        row("optimovej([0,0,0,0,0,0])", "5.20", false);
        row("optimovej([0,0,0,0,0,0])", "10.8", true);
        row("is_frame(\"a\")", "5.25", false);
        row("is_frame(\"a\")", "10.11", true);
        row("force_mode_set_gain_scaling(1)", "3.15", true);  // fails when called
        row("force_mode_set_gain_scaling(1)", "5.0", true);
        row("set_tool_communication(True,115200,0,1,1.5,3.5)", "3.15", false);
        row("ft_rtde_input_enable(False)", "5.8", false);
        row("ft_rtde_input_enable(False)", "3.14", true);
        row("interpreter_mode()", "3.15", false);
        row("interpreter_mode()", "5.10", true);
        row("get_steptime()", "3.15", true);
    }
    void functionsMissingInTheSoftwareDoNotCompile() {
        QFETCH(QString, call);
        QFETCH(QString, software);
        QFETCH(bool, known);
        const QStringList parts = software.split('.');
        Robot robot(running({parts[0].toUInt(), parts[1].toUInt(), 0, 0}));
        robot.reported("if False:\n" + call.toStdString() + "\nend");
        QCOMPARE(robot.error().startsWith("compile_error_name_not_found:"), !known);
    }
};

QTEST_GUILESS_MAIN(TestScriptEquipment)
#include "tst_script_equipment.moc"
