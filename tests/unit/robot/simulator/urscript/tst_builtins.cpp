// SPDX-License-Identifier: MIT
// Built-in functions: reference values, defaults, named arguments, errors.

#include <set>

#include "robot/simulator/urscript/builtin_table.h"
#include "tests/unit/robot/simulator/urscript/script_run.h"

using namespace tiller::simulator::urscript;

namespace {

// All names in the reference, in the same order.
const char* const kReferenceNames =
    "movej movel movep movec optimovej optimovel servoj servoc speedj speedl stopj stopl force_mode "
    "end_force_mode "
    "force_mode_set_damping force_mode_set_gain_scaling force_mode_get_damping force_mode_get_gain_scaling "
    "freedrive_mode freedrive_mode_no_incorrect_payload_check end_freedrive_mode get_freedrive_status "
    "teach_mode "
    "end_teach_mode screw_driving end_screw_driving direct_torque set_pos reset_revolution_counter "
    "set_safety_mode_transition_hardness position_deviation_warning pause_on_error_code "
    "tool_wrench_limit_set "
    "tool_wrench_limit_disable motion_version_set motion_version_get jerk_gain_scaling_set "
    "jerk_gain_scaling_get "
    "path_offset_enable path_offset_disable path_offset_set path_offset_get path_offset_set_alpha_filter "
    "path_offset_set_max_offset conveyor_pulse_decode encoder_enable_pulse_decode "
    "encoder_enable_set_tick_count "
    "encoder_get_tick_count encoder_set_tick_count encoder_unwind_delta_tick_count get_conveyor_tick_count "
    "set_conveyor_tick_count track_conveyor_linear track_conveyor_circular stop_conveyor_tracking "
    "get_target_tcp_pose_along_path get_target_tcp_speed_along_path frame_tracking_enable "
    "frame_tracking_disable "
    "get_actual_joint_positions get_actual_joint_positions_history get_actual_joint_speeds "
    "get_actual_joint_accelerations get_actual_tcp_pose get_actual_tcp_speed get_actual_tool_flange_pose "
    "get_joint_positions get_target_joint_positions get_target_joint_speeds get_target_joint_accelerations "
    "get_target_tcp_pose get_target_tcp_speed get_target_waypoint get_forward_kin get_inverse_kin "
    "get_inverse_kin_has_solution get_jacobian get_jacobian_time_derivative get_mass_matrix "
    "get_coriolis_and_centrifugal_torques get_joint_torques get_joint_temp get_controller_temp get_tool_temp "
    "get_tool_current get_tool_accelerometer_reading get_tcp_force force get_tcp_offset set_tcp "
    "get_target_payload "
    "get_target_payload_cog get_target_payload_inertia set_payload set_payload_mass set_payload_cog "
    "set_target_payload set_payload_from_attached_frames set_mass_properties estimate_payload set_gravity "
    "get_gravity set_base_acceleration get_base_acceleration is_steady is_within_safety_limits tool_contact "
    "get_steptime protective_stop powerdown high_holding_torque_enable high_holding_torque_disable popup "
    "textmsg "
    "sleep sync time str_at str_cat str_empty str_find str_len str_sub to_num to_str set_baselight_off "
    "set_baselight_iec set_baselight_solid get_rtde_value zero_ftsensor assert acos asin atan atan2 cos sin "
    "tan ceil "
    "floor sqrt log pow d2r r2d random norm normalize get_list_length length size make_list inv transpose "
    "binary_list_to_integer integer_to_binary_list interpolate_pose point_dist pose_dist pose_add pose_sub "
    "pose_inv "
    "pose_trans rotvec2rpy rpy2rotvec wrench_trans socket_open socket_close socket_read_binary_integer "
    "socket_read_ascii_float socket_read_byte_list socket_read_string socket_read_line socket_send_byte "
    "socket_send_int socket_send_line socket_send_string socket_get_var socket_set_var "
    "read_input_boolean_register "
    "read_input_integer_register read_input_float_register read_output_boolean_register "
    "read_output_integer_register read_output_float_register write_output_boolean_register "
    "write_output_integer_register write_output_float_register read_port_bit read_port_register "
    "write_port_bit "
    "write_port_register rtde_set_watchdog ft_rtde_input_enable enable_external_ft_sensor "
    "get_standard_digital_in "
    "get_standard_digital_out get_configurable_digital_in get_configurable_digital_out get_tool_digital_in "
    "get_tool_digital_out get_digital_in get_digital_out get_standard_analog_in get_standard_analog_out "
    "get_tool_analog_in get_analog_in get_analog_out get_flag set_flag set_standard_digital_out "
    "set_configurable_digital_out set_tool_digital_out set_digital_out set_standard_analog_out "
    "set_analog_out "
    "set_analog_inputrange set_analog_outputdomain set_standard_analog_input_domain "
    "set_tool_analog_input_domain "
    "set_tool_voltage set_tool_communication set_tool_digital_output_mode set_tool_output_mode "
    "set_runstate_standard_digital_output_to_value set_runstate_configurable_digital_output_to_value "
    "set_runstate_tool_digital_output_to_value set_runstate_standard_analog_output_to_value "
    "set_runstate_gp_boolean_output_to_value set_standard_digital_input_action "
    "set_configurable_digital_input_action set_tool_digital_input_action set_gp_boolean_input_action "
    "set_input_actions_to_default modbus_add_signal modbus_add_rw_signal modbus_delete_signal "
    "modbus_get_signal_status modbus_send_custom_command modbus_set_digital_input_action "
    "modbus_set_output_register modbus_set_output_signal modbus_set_runstate_dependent_choice "
    "modbus_set_signal_update_frequency modbus_get_error modbus_get_time_since_signal_invalid "
    "modbus_reset_connection modbus_set_signal_watchdog rpc_factory interpreter_mode end_interpreter "
    "clear_interpreter request_boolean_from_primary_client request_integer_from_primary_client "
    "request_float_from_primary_client request_string_from_primary_client get_euromap_input "
    "get_euromap_output "
    "set_euromap_output set_euromap_runstate_dependent_choice eip_writer_factory eip_reader_factory "
    "ros_publisher_factory ros_subscriber_factory ros_service_client_factory ros_action_client_factory "
    "add_frame "
    "attach_frame move_frame delete_frame delete_all_frames reset_world_model get_pose convert_pose is_frame "
    "get_frame_parent get_children";

QList<double> numbersOf(const std::string& text) {
    QList<double> out;
    for (const QString& part : QString::fromStdString(text).remove('p').remove('[').remove(']').split(", ")) {
        out.append(part.toDouble());
    }
    return out;
}

}  // namespace

class tst_Builtins : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void everyNameOfTheReferenceIsKnown() {
        for (const QString& name : QString(kReferenceNames).split(' ')) {
            QVERIFY2(findBuiltin(name.toStdString()) >= 0, qPrintable(name));
        }
    }
    void namesAreUnique() {
        std::set<std::string> seen;
        for (const Builtin& b : builtins()) {
            QVERIFY2(seen.insert(b.name).second, b.name.c_str());
        }
    }

    void functionsReturnTheReferenceValues_data() {
        QTest::addColumn<QString>("expression");
        QTest::addColumn<QList<double>>("expected");
        const auto row = [](const char* expression, const QList<double>& expected) {
            QTest::newRow(expression) << expression << expected;
        };
        row("pose_trans(p[.2,.5,.1,1.57,0,0], p[.2,.5,.6,1.57,0,0])", {0.4, -0.0996, 0.60048, 3.14, 0, 0});
        row("pose_add(p[.2,.5,.1,1.57,0,0], p[.2,.5,.6,1.57,0,0])", {0.4, 1.0, 0.7, 3.14, 0, 0});
        row("pose_sub(p[.2,.5,.1,1.57,0,0], p[.2,.5,.6,1.57,0,0])", {0, 0, -0.5, 0, 0, 0});
        row("inv(p[.2,.5,.1,1.57,0,3.14])", {0.19324, 0.41794, -0.29662, 1.23993, 0, 2.47985});
        row("pose_inv(p[.2,.5,.1,1.57,0,3.14])", {0.19324, 0.41794, -0.29662, 1.23993, 0, 2.47985});
        row("rotvec2rpy([3.14,1.57,0])", {-2.80856, -0.16202, 0.9});
        row("rpy2rotvec([3.14,1.57,0])", {2.22153, 0.00177, -2.21976});
        row("norm(p[-.2,.2,-.2,-1.57,0,3.14])", {3.52768});
        row("norm(-5.5)", {5.5});
        row("norm([3,4])", {5});
        row("log(10,4)", {0.60206});
        row("pow(2,10)", {1024});
        row("atan2(1,-1)", {2.356194});
        row("d2r(180)", {3.141593});
        row("r2d(3.14159265358979)", {180});
        row("sqrt(2)", {1.414214});
        row("normalize([0,0,2])", {0, 0, 1});
        row("point_dist(p[.2,.5,.1,1.57,0,3.14], p[.2,.5,.6,0,1.57,3.14])", {0.5});
        row("interpolate_pose(p[0,0,0,0,0,0], p[1,0,0,1,0,0], 0.25)", {0.25, 0, 0, 0.25, 0, 0});
        row("interpolate_pose(p[0,0,0,0,0,0], p[1,0,0,1,0,0], 1.5)", {1.5, 0, 0, 1.5, 0, 0});
        row("wrench_trans(p[1,0,0,0,0,0], [0,0,10,0,0,0])", {0, 0, 10, 0, 10, 0});
        row("wrench_trans(p[0,0,0,0,0,1.5707963268], [1,0,0,0,0,0])", {0, -1, 0, 0, 0, 0});
    }
    void functionsReturnTheReferenceValues() {
        QFETCH(QString, expression);
        QFETCH(QList<double>, expected);
        const std::string text = evaluate(expression.toStdString());
        QVERIFY2(!text.starts_with("error"), text.c_str());
        const QList<double> actual = numbersOf(text);
        QCOMPARE(actual.size(), expected.size());
        for (qsizetype i = 0; i < expected.size(); ++i) {
            QVERIFY2(std::abs(actual[i] - expected[i]) < 1.1e-5, text.c_str());
        }
    }

    void functionsReturnExactValues_data() {
        QTest::addColumn<QString>("expression");
        QTest::addColumn<QString>("expected");
        const auto row = [](const char* expression, const char* expected) {
            QTest::newRow(expression) << expression << expected;
        };
        row("ceil(1.2)", "2");
        row("floor(-1.2)", "-2");
        row("floor(7 / 2) + 1", "4");
        row("length([1,2,3])", "3");
        row("length(\"abcd\")", "4");
        row("get_list_length([1,2])", "2");
        row("size([1,2])", "2");
        row("binary_list_to_integer([True, False, True])", "5");
        row("binary_list_to_integer([])", "0");
        row("binary_list_to_integer(integer_to_binary_list(-7))", "-7");
        row("integer_to_binary_list(1)[0]", "True");
        row("str_at(\"abc\", 1)", "b");
        row("str_at(\"abc\", 3)", "error: str_at: index 3 is out of bounds");
        row("str_sub(\"abcdef\", 2, 3)", "cde");
        row("str_sub(\"abcdef\", 2, 99)", "cdef");
        row("str_sub(\"abcdef\", 2)", "cdef");
        row("str_len(\"abc\")", "3");
        row("str_empty(\"\")", "True");
        row("str_find(\"abcabc\", \"c\")", "2");
        row("str_find(\"abcabc\", \"c\", 3)", "5");
        row("str_find(\"abc\", \"x\")", "-1");
        row("to_num(\" -12\") + 1", "-11");
        row("to_num(\"0x1F\")", "31");
        row("to_num(\"1.5e1\")", "15");
        row("to_num(\"abc\")", "error: to_num: \"abc\" is not a number");
        row("to_str(1.10)", "1.1");
        row("to_str(100)", "100");
        row("to_str(0.0000001)", "0");
        row("acos(2)", "error: Domain error: acos(2)");
        row("sqrt(-1)", "error: Domain error: sqrt(-1)");
        row("log(1, 4)", "error: Domain error: log(1, 4)");
        row("pow(-8, 0.5)", "error: Domain error: pow(-8, 0.5)");
        row("pow(-2, 3)", "-8");
        row("pow(0, -1)", "error: Domain error: pow(0, -1)");
        row("normalize([0,0])", "error: normalize: the length of the vector is zero");
        row("random() < 1 and random() >= 0", "True");
        row("force()", "5");
        row("get_actual_joint_positions_history(1)[0]", "-0.9");
        row("get_actual_joint_positions_history(101)", "error: history is too short");
        row("get_joint_temp(2)", "32");
        row("get_target_payload()", "0");
        row("is_steady()", "True");
        row("get_inverse_kin(p[1,2,3,0,0,0], qnear=[0,0,0,0,0,0])[2]", "3");
        row("get_forward_kin([1,2,3,4,5,6], tcp=p[0,0,0,0,0,0])[5]", "6");
        row("get_rtde_value(\"actual_q\")", "error: get_rtde_value is not simulated");
        row("get_euromap_input(3)",
            "error: get_euromap_input needs a Euromap67 interface, which is not simulated");
        row("motion_version_get()", "1");
        row("read_input_integer_register(48)",
            "error: Range error: read_input_integer_register argument 'address' is 48, allowed is 0 to 47");
    }
    void functionsReturnExactValues() {
        QFETCH(QString, expression);
        QFETCH(QString, expected);
        QCOMPARE(QString::fromStdString(evaluate(expression.toStdString())), expected);
    }

    void argumentsAreCheckedAtTheCall() {
        QCOMPARE(evaluate("1", "if False:\nsin(1, 2)\nend"), "1");
        QCOMPARE(evaluate("sin(1, 2)"), "error: Type error: sin takes at most 1 arguments");
        QCOMPARE(evaluate("sin()"), "error: Type error: sin is missing argument 'f'");
        QCOMPARE(evaluate("sin(x=1)"), "error: Type error: sin has no argument named 'x'");
        QCOMPARE(evaluate("sin(\"a\")"), "error: Type error: sin argument 'f' must be a number, not string");
        QCOMPARE(evaluate("pow(1, base=2)"), "error: Type error: pow got argument 'base' twice");
    }

    void movesCarryTheirArguments() {
        ScriptRun run(
            "def m():\n movej([1,2,3,4,5,6], v = 0.5, a=2)\n movel(p[1,2,3,0,0,0], t=1, r=0.1)\n"
            "movec(p[1,0,0,0,0,0], [1,2,3,4,5,6], mode=1.0)\nend\n");
        run.host.moveFrames = 1;
        QCOMPARE(run.frames(2000), Interpreter::State::Finished);
        QCOMPARE(run.host.motions.size(), 3u);
        const Move& j = std::get<Move>(run.host.motions[0].command);
        QVERIFY(j.kind == Move::Kind::J);
        QCOMPARE(j.velocity, 0.5);
        QCOMPARE(j.acceleration, 2.0);
        QCOMPARE(std::get<tiller::JointPositions>(j.target)[5], 6.0);
        const Move& l = std::get<Move>(run.host.motions[1].command);
        QCOMPARE(l.acceleration, 1.2);
        QCOMPARE(l.velocity, 0.25);
        QCOMPARE(l.duration, 1.0);
        QCOMPARE(l.blend, 0.1);
        const Move& c = std::get<Move>(run.host.motions[2].command);
        QCOMPARE(c.orientationMode, 1);
        QVERIFY(std::holds_alternative<tiller::Pose>(*c.via));
        QVERIFY(std::holds_alternative<tiller::JointPositions>(c.target));
    }
    void servoTakesTheStepTimeByDefault() {
        ScriptRun run;
        run.host.step = 0.008;
        run.load("def m():\n servoj([1,2,3,4,5,6], lookahead_time=0.03, gain=2000)\nend\n");
        run.frames(10);
        const ServoJ& servo = std::get<ServoJ>(run.host.motions.at(0).command);
        QCOMPARE(servo.duration, 0.008);
        QCOMPARE(servo.lookahead, 0.03);
        QCOMPARE(servo.gain, 2000.0);
    }
    void speedsTakeInfiniteAccelerationAndNoTime() {
        ScriptRun run("def m():\n speedj([0,0,0,0,0,0], 1.0 / 0, 1e-15)\n speedl([1,0,0,0,0,0], 0.5)\nend\n");
        QCOMPARE(run.frames(50), Interpreter::State::Finished);
        QVERIFY(std::isinf(std::get<SpeedJ>(run.host.motions[0].command).acceleration));
        const SpeedL& l = std::get<SpeedL>(run.host.motions[1].command);
        QVERIFY(!l.duration);
        QCOMPARE(l.rotationAcceleration, 0.5);
    }
    void badMovesEndTheProgram() {
        QCOMPARE(evaluate("1", "movej([0,0,0,0,0,0], v=0)"),
                 "error: movej: acceleration and velocity must be greater than 0");
        QCOMPARE(evaluate("1", "movej([0,0,0])"),
                 "error: Type error: movej argument 'q' must be a list of six numbers, not list");
    }
    void inverseKinematicsWithoutSolutionEndsTheProgram() {
        ScriptRun run("def m():\nq = get_inverse_kin(p[9,0,0,0,0,0])\nend\n");
        run.host.reachable = false;
        QCOMPARE(run.frames(2), Interpreter::State::Failed);
        QCOMPARE(run.interpreter->error()->line, 2);
        QCOMPARE(run.interpreter->error()->column, 5);
        QVERIFY(run.error().starts_with("get_inverse_kin: no solution"));
    }
    void hostErrorsContainTheirText() {
        ScriptRun run("def m():\nmovej([0,0,0,0,0,0])\nend\n");
        run.host.startError = "target is outside the joint limits";
        QCOMPARE(run.frames(2), Interpreter::State::Failed);
        QCOMPARE(run.error(), "target is outside the joint limits");
    }

    void textMessagesHaveTheirOwnFormat() {
        ScriptRun run(
            "def m():\ntextmsg(p[0.605825,-0.720087,0.233797,-0.01113684,-0.0111357,1.570732])\n"
            "textmsg(\"a = \", 1.50)\ntextmsg([1,2])\nend\n");
        run.frames(2);
        QCOMPARE(run.host.messages[0], "p[0.605825,-0.720087,0.233797,-0.0111368,-0.0111357,1.57073]");
        QCOMPARE(run.host.messages[1], "a = 1.5");
        QCOMPARE(run.host.messages[2], "[1,2]");
    }
    void registersAndPinsReachTheHost() {
        ScriptRun run(
            "def m():\nwrite_output_integer_register(3, read_input_integer_register(4) + 1)\n"
            "write_output_float_register(0, 1)\nwrite_output_boolean_register(127, True)\n"
            "set_digital_out(9, True)\nset_standard_digital_out(2, True)\nset_flag(5, True)\n"
            "set_tool_voltage(24.0)\nset_standard_analog_out(1, 0.5)\nend\n");
        run.host.intIn[4] = 41;
        run.frames(2);
        QCOMPARE(run.host.intOut[3], 42);
        QCOMPARE(run.host.floatOut[0], 1.0);
        QVERIFY(run.host.boolOut[127]);
        QVERIFY(run.host.pins[FakeHost::pinOf(DigitalBank::Tool, 1)]);
        QVERIFY(run.host.pins[2]);
        QVERIFY(run.host.flags[5]);
        QCOMPARE(run.host.calls[0], "voltage 24");
    }
    void payloadDefaultsToTheTcp() {
        ScriptRun run("def m():\nset_tcp(p[0,0,0.2,0,0,0])\nset_payload(1.5)\nend\n");
        run.frames(2);
        QCOMPARE(run.host.load.mass, 1.5);
        QCOMPARE(run.host.load.centreOfGravity.z(), 0.2);
    }
    void versionsHaveTheirBuiltins() {
        const auto exists = [](const char* call, tiller::SoftwareVersion version) {
            CompileOptions options;
            options.version = version;
            return bool(compile(std::string("def m():\n") + call + "\nend\n", options));
        };
        QVERIFY(exists("optimovej([0,0,0,0,0,0])", {5, 21, 0, 0}));
        QVERIFY(!exists("optimovej([0,0,0,0,0,0])", {5, 20, 0, 0}));
        QVERIFY(exists("reset_world_model()", {10, 11, 0, 0}));
        QVERIFY(!exists("reset_world_model()", {5, 22, 0, 0}));
        QVERIFY(exists("get_inverse_kin_has_solution(p[0,0,0,0,0,0])", {3, 15, 0, 0}));
        QVERIFY(exists("movej([0,0,0,0,0,0])", {3, 4, 0, 0}));
    }
};

QTEST_GUILESS_MAIN(tst_Builtins)
#include "tst_builtins.moc"
