// SPDX-License-Identifier: MIT
// Known names of equipment that is not simulated: programs with them compile, and fail where they get there.

#include "robot/simulator/urscript/builtin.h"

namespace tiller::simulator::urscript {

namespace {

constexpr const char* kModbus = "a Modbus device";
constexpr const char* kEuromap = "a Euromap67 interface";
constexpr const char* kEtherNetIp = "an EtherNet/IP scanner";
constexpr const char* kRos = "a ROS network";

constexpr BuiltinRow kRows[] = {
    {"modbus_add_signal(IP, slave_number, signal_address, signal_type, signal_name, sequential_mode=False)",
     absent,
     kPlain,
     {},
     kModbus},
    {"modbus_add_rw_signal(IP, slave_number, read_address, read_register_count, write_address, "
     "write_register_count, signal_name, sequential_mode=False)",
     absent,
     kPlain,
     {},
     kModbus},
    {"modbus_delete_signal(signal_name)", absent, kPlain, {}, kModbus},
    {"modbus_get_signal_status(signal_name, is_secondary_program?)", absent, kPlain, {}, kModbus},
    {"modbus_send_custom_command(IP, slave_number, function_code, data)", absent, kPlain, {}, kModbus},
    {"modbus_set_digital_input_action(signal_name, action)", absent, kPlain, {}, kModbus},
    {"modbus_set_output_register(signal_name, register_value, is_secondary_program?)",
     absent,
     kPlain,
     {},
     kModbus},
    {"modbus_set_output_signal(signal_name, digital_value, is_secondary_program?)",
     absent,
     kPlain,
     {},
     kModbus},
    {"modbus_set_runstate_dependent_choice(signal_name, runstate_choice)", absent, kPlain, {}, kModbus},
    {"modbus_set_signal_update_frequency(signal_name, update_frequency)", absent, kPlain, {}, kModbus},
    {"modbus_get_error(signal_name, error_source=0)", absent, kPlain, {}, kModbus},
    {"modbus_get_time_since_signal_invalid(signal_name)", absent, kPlain, {}, kModbus},
    {"modbus_reset_connection(connection_id, is_blocking=True)", absent, kPlain, {}, kModbus},
    {"modbus_set_signal_watchdog(signal_name, new_timeout_in_sec)", absent, kPlain, {}, kModbus},
    {"get_euromap_input(port_number)", absent, kPlain, {}, kEuromap},
    {"get_euromap_output(port_number)", absent, kPlain, {}, kEuromap},
    {"set_euromap_output(port_number, signal_value)", absent, kPlain, {}, kEuromap},
    {"set_euromap_runstate_dependent_choice(port_number, runstate_choice)", absent, kPlain, {}, kEuromap},
    {"eip_writer_factory(...)", absent, kAnyArguments, {}, kEtherNetIp},
    {"eip_reader_factory(...)", absent, kAnyArguments, {}, kEtherNetIp},
    {"ros_publisher_factory(...)", absent, kAnyArguments, kPolyScopeX, kRos},
    {"ros_subscriber_factory(...)", absent, kAnyArguments, kPolyScopeX, kRos},
    {"ros_service_client_factory(...)", absent, kAnyArguments, kPolyScopeX, kRos},
    {"ros_action_client_factory(...)", absent, kAnyArguments, kPolyScopeX, kRos},
};

}  // namespace

std::span<const BuiltinRow> absentBuiltins() {
    return kRows;
}

}  // namespace tiller::simulator::urscript
