// SPDX-License-Identifier: MIT
// Known functions for equipment that is not simulated. Programs that contain them compile, but fail when they
// call them.

#include "robot/simulator/urscript/builtin_table.h"
#include "robot/simulator/urscript/call.h"

namespace tiller::simulator::urscript {

namespace {

constexpr const char* kEuromap = "a Euromap67 interface";
constexpr const char* kEtherNetIp = "an EtherNet/IP scanner";
constexpr const char* kRos = "a ROS network";

constexpr BuiltinRow kAbsentRows[] = {
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
    return kAbsentRows;
}

}  // namespace tiller::simulator::urscript
