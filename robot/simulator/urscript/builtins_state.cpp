// SPDX-License-Identifier: MIT
// Current state and sensor values of the robot.

#include "robot/simulator/urscript/builtin_table.h"
#include "robot/simulator/urscript/call.h"

namespace tiller::simulator::urscript {

namespace {

template <Source source>
Status jointPositions(Call& c) {
    c.result = jointList(c.host.jointPositions(source).values);
    return Status::Done;
}
template <Source source>
Status jointSpeeds(Call& c) {
    c.result = jointList(c.host.jointVelocities(source).values);
    return Status::Done;
}
template <Source source>
Status jointAccelerations(Call& c) {
    c.result = jointList(c.host.jointAccelerations(source).values);
    return Status::Done;
}
template <Source source>
Status tcpPose(Call& c) {
    c.result = c.host.tcpPose(source);
    return Status::Done;
}

Value poseOf(const Vector6& v) {
    return std::array<double, 6>{v[0], v[1], v[2], v[3], v[4], v[5]};
}

template <Source source>
Status tcpSpeed(Call& c) {
    c.result = poseOf(c.host.tcpSpeed(source).vector());
    return Status::Done;
}

Status history(Call& c) {
    const std::int32_t steps = c.integer(0);
    if (steps < 0) {
        fault("get_actual_joint_positions_history: steps must not be negative");
    }
    const Result<JointPositions> q = c.host.jointPositionsHistory(steps);
    if (!q.ok()) {
        fault(q.error());
    }
    c.result = jointList(q->values);
    return Status::Done;
}

Status flangePose(Call& c) {
    c.result = c.host.flangePose();
    return Status::Done;
}
Status targetWaypoint(Call& c) {
    c.result = c.host.targetWaypoint();
    return Status::Done;
}
Status jointTorques(Call& c) {
    c.result = jointList(c.host.externalJointTorques().values);
    return Status::Done;
}
Status tcpForce(Call& c) {
    c.result = poseOf(c.host.tcpForce().vector());
    return Status::Done;
}
Status force(Call& c) {
    c.result = c.host.tcpForce().force.norm();
    return Status::Done;
}
Status jointTemperature(Call& c) {
    c.result = c.host.jointTemperature(c.integerIn(0, 0, 5));
    return Status::Done;
}
Status controllerTemperature(Call& c) {
    c.result = c.host.controllerTemperature();
    return Status::Done;
}
Status toolTemperature(Call& c) {
    c.result = c.host.toolTemperature();
    return Status::Done;
}
Status toolCurrent(Call& c) {
    c.result = c.host.toolCurrent();
    return Status::Done;
}
Status toolAccelerometer(Call& c) {
    c.result = Value::floats(c.host.toolAccelerometer().data(), 3);
    return Status::Done;
}
Status isSteady(Call& c) {
    c.result = c.host.isSteady();
    return Status::Done;
}

Status toolContact(Call& c) {
    const std::vector<double> direction = c.numbers(0);
    if (direction.size() != 6 && direction.size() != 3) {
        c.badArgument(0, "a list of six numbers");
    }
    c.result = std::int32_t{c.host.toolContact({direction[0], direction[1], direction[2]})};
    return Status::Done;
}

Status rtdeValue(Call& c) {
    const Result<StateHost::FieldValue> value = c.host.rtdeValue(c.string(0));
    if (!value.ok()) {
        fault(value.error());
    }
    c.result = std::visit(
        [](const auto& v) -> Value {
            using T = std::decay_t<decltype(v)>;
            if constexpr (std::is_same_v<T, std::vector<double>>) {
                return Value::floats(v.data(), v.size());
            } else if constexpr (std::is_same_v<T, std::vector<std::int32_t>>) {
                return Value::ints(v.data(), v.size());
            } else {
                return v;
            }
        },
        *value);
    return Status::Done;
}

constexpr BuiltinRow kStateRows[] = {
    {"get_actual_joint_positions()", jointPositions<Source::Actual>},
    {"get_actual_joint_positions_history(steps=0)", history, kPlain, {{4, 0, kNever}}},
    {"get_actual_joint_speeds()", jointSpeeds<Source::Actual>},
    {"get_actual_joint_accelerations()", jointAccelerations<Source::Actual>, kPlain, kAfter515},
    {"get_actual_tcp_pose()", tcpPose<Source::Actual>},
    {"tool_pose()", tcpPose<Source::Actual>},
    {"get_actual_tcp_speed()", tcpSpeed<Source::Actual>},
    {"get_actual_tool_flange_pose()", flangePose},
    {"get_joint_positions()", jointPositions<Source::Actual>},
    {"get_target_joint_positions()", jointPositions<Source::Target>},
    {"get_target_joint_speeds()", jointSpeeds<Source::Target>},
    {"get_target_joint_accelerations()", jointAccelerations<Source::Target>, kPlain, kAfter515},
    {"get_target_tcp_pose()", tcpPose<Source::Target>},
    {"get_target_tcp_speed()", tcpSpeed<Source::Target>},
    {"get_target_tcp_pose_along_path()", tcpPose<Source::Target>, kPlain, kAfter2019},
    {"get_target_tcp_speed_along_path()", tcpSpeed<Source::Target>, kPlain, kAfter2019},
    {"get_target_waypoint()", targetWaypoint, kPlain, kTargetWaypointSince},
    {"get_joint_torques()", jointTorques},
    {"get_tcp_force()", tcpForce},
    {"force()", force},
    {"get_joint_temp(j)", jointTemperature},
    {"get_controller_temp()", controllerTemperature},
    {"get_tool_temp()", toolTemperature, kPlain, {{17}}},
    {"get_tool_current()", toolCurrent},
    {"get_tool_accelerometer_reading()", toolAccelerometer},
    {"is_steady()", isSteady},
    {"tool_contact(direction)", toolContact, kPlain, {{4, 0, kNever}}},
    {"get_rtde_value(key)", rtdeValue, kPlain, kAfter515},
};

}  // namespace

std::span<const BuiltinRow> stateBuiltins() {
    return kStateRows;
}

}  // namespace tiller::simulator::urscript
