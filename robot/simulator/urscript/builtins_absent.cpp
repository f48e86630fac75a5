// SPDX-License-Identifier: MIT
// Known names of equipment that is not simulated: programs with them compile, and fail where they get there.

#include "robot/simulator/urscript/builtin.h"

namespace tiller::simulator::urscript {

namespace {

constexpr Since kPolyScopeX{kNever, 0};

constexpr BuiltinRow kRows[] = {
    {"read_port_bit(address)", absent},
    {"read_port_register(address)", absent},
    {"write_port_bit(address, value)", absent},
    {"write_port_register(address, value)", absent},
    {"modbus_add_signal(IP, slave_number, signal_address, signal_type, signal_name, sequential_mode=False)",
     absent},
    {"modbus_add_rw_signal(IP, slave_number, read_address, read_register_count, write_address, "
     "write_register_count, signal_name, sequential_mode=False)",
     absent},
    {"modbus_delete_signal(signal_name)", absent},
    {"modbus_get_signal_status(signal_name, is_secondary_program?)", absent},
    {"modbus_send_custom_command(IP, slave_number, function_code, data)", absent},
    {"modbus_set_digital_input_action(signal_name, action)", absent},
    {"modbus_set_output_register(signal_name, register_value, is_secondary_program?)", absent},
    {"modbus_set_output_signal(signal_name, digital_value, is_secondary_program?)", absent},
    {"modbus_set_runstate_dependent_choice(signal_name, runstate_choice)", absent},
    {"modbus_set_signal_update_frequency(signal_name, update_frequency)", absent},
    {"modbus_get_error(signal_name, error_source=0)", absent},
    {"modbus_get_time_since_signal_invalid(signal_name)", absent},
    {"modbus_reset_connection(connection_id, is_blocking=True)", absent},
    {"modbus_set_signal_watchdog(signal_name, new_timeout_in_sec)", absent},
    {"rpc_factory(type, url)", absent},
    {"interpreter_mode(clearQueueOnEnter=True, clearOnEnd=True)", absent},
    {"end_interpreter()", absent},
    {"clear_interpreter()", absent},
    {"get_euromap_input(port_number)", absent},
    {"get_euromap_output(port_number)", absent},
    {"set_euromap_output(port_number, signal_value)", absent},
    {"set_euromap_runstate_dependent_choice(port_number, runstate_choice)", absent},
    {"eip_writer_factory(...)", absent, kAnyArguments},
    {"eip_reader_factory(...)", absent, kAnyArguments},
    {"ros_publisher_factory(...)", absent, kAnyArguments, kPolyScopeX},
    {"ros_subscriber_factory(...)", absent, kAnyArguments, kPolyScopeX},
    {"ros_service_client_factory(...)", absent, kAnyArguments, kPolyScopeX},
    {"ros_action_client_factory(...)", absent, kAnyArguments, kPolyScopeX},
    {"add_frame(name, pose, ref_name=\"base\")", absent, kPlain, kPolyScopeX},
    {"attach_frame(child, parent)", absent, kPlain, kPolyScopeX},
    {"move_frame(name, pose, ref_name=\"base\")", absent, kPlain, kPolyScopeX},
    {"delete_frame(name)", absent, kPlain, kPolyScopeX},
    {"delete_all_frames()", absent, kPlain, kPolyScopeX},
    {"reset_world_model()", absent, kPlain, kPolyScopeX},
    {"get_pose(name, rel_name, ref_name?)", absent, kPlain, kPolyScopeX},
    {"convert_pose(pose, from_frame, to_frame)", absent, kPlain, kPolyScopeX},
    {"is_frame(name)", absent, kPlain, kPolyScopeX},
    {"get_frame_parent(name)", absent, kPlain, kPolyScopeX},
    {"get_children(name)", absent, kPlain, kPolyScopeX},
};

}  // namespace

std::span<const BuiltinRow> absentBuiltins() {
    return kRows;
}

}  // namespace tiller::simulator::urscript
