// SPDX-License-Identifier: MIT
// TCP, payload, gravity, force sensor.

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "robot/simulator/urscript/builtin_table.h"
#include "robot/simulator/urscript/call.h"

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

// Returns the rows of six numbers of a matrix or of a list of poses, as returned by get_tcp_force().
std::vector<Vector6> rowsAt(const Call& c, std::size_t i) {
    std::vector<Vector6> out;
    if (c.args[i].is(Value::Type::Matrix) && c.args[i].matrix().cols == 6) {
        for (std::size_t r = 0; r < c.args[i].matrix().rows; ++r) {
            out.emplace_back(Eigen::Map<const Vector6>(c.args[i].matrix().numbers.data() + 6 * r));
        }
    } else if (c.args[i].is(Value::Type::List)) {
        for (const Value& v : c.args[i].list().values) {
            if (!v.is(Value::Type::Pose)) {
                c.badArgument(i, "a list of poses");
            }
            out.emplace_back(Eigen::Map<const Vector6>(v.pose().data()));
        }
    }
    if (out.size() < 4 ||
        !std::all_of(out.begin(), out.end(), [](const Vector6& v) { return v.allFinite(); })) {
        c.badArgument(i, "a list of at least four elements");
    }
    return out;
}

// Estimates mass and centre of gravity by least squares from wrenches in base orientation about the flange: F
// = -m g, and tau = (R cog) x F = -[F]x R cog.
Status estimatePayload(Call& c) {
    const std::vector<Vector6> poses = rowsAt(c, 0);
    const std::vector<Vector6> wrenches = rowsAt(c, 1);
    const Eigen::Vector3d g = c.host.gravity();
    if (poses.size() != wrenches.size() || g.norm() < 1e-6) {
        fault(
            "estimate_payload: the number of wrenches must equal the number of poses, and gravity must not "
            "be zero");
    }
    double mass = 0;
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < poses.size(); ++i) {
        const Eigen::Vector3d force = wrenches[i].head<3>();
        mass -= force.dot(g) / g.squaredNorm() / static_cast<double>(poses.size());
        Eigen::Matrix3d cross;
        cross << 0, -force.z(), force.y(), force.z(), 0, -force.x(), -force.y(), force.x(), 0;
        const Eigen::Matrix3d A = -cross * rotationMatrix(poses[i].tail<3>());
        normal += A.transpose() * A;
        right += A.transpose() * wrenches[i].tail<3>();
    }
    const Eigen::FullPivLU<Eigen::Matrix3d> lu(normal);
    if (!lu.isInvertible()) {
        fault("estimate_payload: the poses must have different orientations");
    }
    const Eigen::Vector3d cog = lu.solve(right);
    StructData data;
    data.members.emplace_back("mass", mass);
    data.members.emplace_back("cog", Value::floats(cog.data(), 3));
    c.result = Value::structure(std::move(data));
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

constexpr BuiltinRow kSetupRows[] = {
    {"get_tcp_offset()", getTcpOffset, kPlain, {{0, 0, 6}}},
    {"set_tcp(pose, tcp_name=\"\")", setTcp},
    {"get_target_payload()", targetPayload, kPlain, kSeries5},
    {"get_target_payload_cog()", targetPayloadCog, kPlain, kSeries5},
    {"get_target_payload_inertia()", targetPayloadInertia, kPlain, kAfter2019},
    {"set_payload(m, cog?)", setPayload},
    {"set_payload_mass(m)", setPayloadMass},
    {"set_payload_cog(cog)", setPayloadCog},
    {"set_target_payload(m, cog, inertia?, transition_time=0)", setTargetPayload, kPlain, {{10}}},
    {"estimate_payload(poses, wrenches)", estimatePayload, kPlain, kAfter2019},
    {"set_gravity(d)", setGravity},
    {"get_gravity()", getGravity, kPlain, {{17}}},
    {"set_base_acceleration(a)", setBaseAcceleration, kPlain, kAfter2019},
    {"get_base_acceleration()", getBaseAcceleration, kPlain, {{17}}},
    {"zero_ftsensor()", zeroFtSensor},
    {"ft_rtde_input_enable(enable, sensor_mass=0.0, sensor_measuring_offset?, sensor_cog?)",
     ftRtdeInputEnable,
     kPlain,
     {{9}}},
    {"enable_external_ft_sensor(enable, sensor_mass=0.0, sensor_measuring_offset?, sensor_cog?)",
     enableExternalFtSensor},
    {"high_holding_torque_enable()", setting, kPlain, kAfter2019},
    {"high_holding_torque_disable()", setting, kPlain, kAfter2019},
    {"set_baselight_off()", setting, kPlain, kAfter2019},
    {"set_baselight_iec()", setting, kPlain, kAfter2019},
    {"set_baselight_solid(r, g, b)", setting, kPlain, kAfter2019},
};

}  // namespace

std::span<const BuiltinRow> setupBuiltins() {
    return kSetupRows;
}

}  // namespace tiller::simulator::urscript
