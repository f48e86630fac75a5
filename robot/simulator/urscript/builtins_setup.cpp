// SPDX-License-Identifier: MIT
// TCP, payload, gravity, force sensor.

#include <cmath>

#include "robot/simulator/urscript/builtin.h"

namespace tiller::simulator::urscript {

namespace {

double massAt(const Call& c, std::size_t i) {
    const double mass = c.finite(i);
    if (mass < 0) {
        fault(c.name() + ": mass must not be negative");
    }
    return mass;
}

Eigen::Vector3d finiteThree(const Call& c, std::size_t i) {
    const Eigen::Vector3d v = c.three(i);
    if (!v.allFinite()) {
        c.badArgument(i, "a list of three finite numbers");
    }
    return v;
}

Status getTcpOffset(Call& c) {
    c.result = c.host.tcpOffset();
    return Status::Done;
}
Status setTcp(Call& c) {
    const Pose tcp = c.pose(0);
    if (!tcp.allFinite()) {
        c.badArgument(0, "a pose of finite numbers");
    }
    c.check(c.host.setTcpOffset(tcp, c.string(1)));
    return Status::Done;
}

Status setPayload(Call& c) {
    Payload payload;
    payload.mass = massAt(c, 0);
    payload.centreOfGravity = c.given(1) ? finiteThree(c, 1) : c.host.tcpOffset().position;
    c.check(c.host.setPayload(payload, 0, true));
    return Status::Done;
}
Status setPayloadMass(Call& c) {
    Payload payload;
    payload.mass = massAt(c, 0);
    payload.centreOfGravity = c.host.payload().centreOfGravity;
    c.check(c.host.setPayload(payload, 0, true));
    return Status::Done;
}
Status setPayloadCog(Call& c) {
    Payload payload = c.host.payload();
    payload.centreOfGravity = finiteThree(c, 0);
    c.check(c.host.setPayload(payload, 0, false));
    return Status::Done;
}
Status setTargetPayload(Call& c) {
    Payload payload;
    payload.mass = massAt(c, 0);
    payload.centreOfGravity = finiteThree(c, 1);
    if (c.given(2)) {
        const std::array<double, 6> inertia = c.six(2);
        for (std::size_t i = 0; i < 6; ++i) {
            if (!(std::abs(inertia[i]) <= 133) || (i < 3 && inertia[i] < 0)) {
                fault("set_target_payload: inertia is out of range");
            }
        }
        payload.inertia = Eigen::Map<const Vector6>(inertia.data());
    }
    const double transition = c.finite(3);
    if (transition < 0) {
        fault("set_target_payload: transition_time must not be negative");
    }
    c.check(c.host.setPayload(payload, transition, false));
    return Status::Done;
}
Status targetPayload(Call& c) {
    c.result = c.host.payload().mass;
    return Status::Done;
}
Status targetPayloadCog(Call& c) {
    c.result = Value::floats(c.host.payload().centreOfGravity.data(), 3);
    return Status::Done;
}
Status targetPayloadInertia(Call& c) {
    c.result = jointList(c.host.payload().inertia);
    return Status::Done;
}

Status setGravity(Call& c) {
    c.check(c.host.setGravity(finiteThree(c, 0)));
    return Status::Done;
}
Status getGravity(Call& c) {
    c.result = Value::floats(c.host.gravity().data(), 3);
    return Status::Done;
}
Status setBaseAcceleration(Call& c) {
    c.check(c.host.setBaseAcceleration(finiteThree(c, 0)));
    return Status::Done;
}
Status getBaseAcceleration(Call& c) {
    c.result = Value::floats(c.host.baseAcceleration().data(), 3);
    return Status::Done;
}

Status zeroFtSensor(Call& c) {
    c.host.zeroForceSensor();
    return Status::Done;
}

void externalSensor(Call& c, bool viaRtde) {
    ExternalForceSensor sensor;
    sensor.enabled = c.boolean(0);
    sensor.mass = massAt(c, 1);
    if (c.given(2)) {
        sensor.measuringOffset = finiteThree(c, 2);
    }
    if (c.given(3)) {
        sensor.centreOfGravity = finiteThree(c, 3);
    }
    sensor.viaRtde = viaRtde;
    c.check(c.host.setExternalForceSensor(sensor));
}
Status ftRtdeInputEnable(Call& c) {
    externalSensor(c, true);
    return Status::Done;
}
Status enableExternalFtSensor(Call& c) {
    externalSensor(c, false);
    return Status::Done;
}

constexpr BuiltinRow kRows[] = {
    {"get_tcp_offset()", getTcpOffset},
    {"set_tcp(pose, tcp_name=\"\")", setTcp},
    {"get_target_payload()", targetPayload},
    {"get_target_payload_cog()", targetPayloadCog},
    {"get_target_payload_inertia()", targetPayloadInertia},
    {"set_payload(m, cog?)", setPayload},
    {"set_payload_mass(m)", setPayloadMass},
    {"set_payload_cog(cog)", setPayloadCog},
    {"set_target_payload(m, cog, inertia?, transition_time=0)", setTargetPayload, kPlain, {10, 0}},
    {"set_payload_from_attached_frames()", absent, kPlain, {kNever, 0}},
    {"set_mass_properties(frame, m, cog, inertia)", absent, kPlain, {kNever, 0}},
    {"estimate_payload(poses, wrenches)", absent},
    {"set_gravity(d)", setGravity},
    {"get_gravity()", getGravity, kPlain, {17, 0}},
    {"set_base_acceleration(a)", setBaseAcceleration},
    {"get_base_acceleration()", getBaseAcceleration, kPlain, {17, 0}},
    {"zero_ftsensor()", zeroFtSensor},
    {"ft_rtde_input_enable(enable, sensor_mass=0.0, sensor_measuring_offset?, sensor_cog?)",
     ftRtdeInputEnable,
     kPlain,
     {9, 0}},
    {"enable_external_ft_sensor(enable, sensor_mass=0.0, sensor_measuring_offset?, sensor_cog?)",
     enableExternalFtSensor},
    {"high_holding_torque_enable()", setting},
    {"high_holding_torque_disable()", setting},
    {"set_baselight_off()", setting},
    {"set_baselight_iec()", setting},
    {"set_baselight_solid(r, g, b)", setting},
};

}  // namespace

std::span<const BuiltinRow> setupBuiltins() {
    return kRows;
}

}  // namespace tiller::simulator::urscript
