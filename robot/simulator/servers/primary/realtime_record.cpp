// SPDX-License-Identifier: MIT
#include "robot/simulator/servers/primary/realtime_record.h"

#include <span>

#include "robot/simulator/net/byte_writer.h"

namespace tiller::simulator {

namespace {

void six(ByteWriter& out, const Vector6& v) {
    out.f64s(std::span<const double, 6>(v.data(), 6));
}
void three(ByteWriter& out, const Eigen::Vector3d& v) {
    out.f64s(std::span<const double, 3>(v.data(), 3));
}
void unused(ByteWriter& out, int count) {
    for (int i = 0; i < count; ++i) {
        out.f64(0);
    }
}

/// Writes the digital inputs or outputs as a double, like all other fields, or as a 64-bit integer, as in the
/// vendor's table. BehaviourOptions::realtimeBits selects the format.
void bits(ByteWriter& out, const Telemetry& now, std::uint64_t pins) {
    if (now.bitsAsIntegers) {
        out.u64(pins);
    } else {
        out.f64(static_cast<double>(pins));
    }
}

}  // namespace

std::size_t realtimeRecordSize(const SoftwareVersion& software) {
    struct Step {
        SoftwareVersion cb3, eSeries;
        std::size_t size;
    };
    constexpr SoftwareVersion kNever{99, 0, 0, 0};
    static constexpr Step kSteps[] = {
        {kNever, {5, 10, 0, 0}, 1220},       {{3, 14, 0, 0}, {5, 9, 0, 0}, 1140},
        {{3, 10, 0, 0}, {5, 4, 0, 0}, 1116}, {{3, 5, 0, 0}, {5, 0, 0, 0}, 1108},
        {{3, 2, 0, 0}, kNever, 1060},
    };
    for (const Step& step : kSteps) {
        if (software >= (software.isCb3() ? step.cb3 : step.eSeries)) {
            return step.size;
        }
    }
    return 1044;
}

void writeRealtimeRecord(const Telemetry& now, std::vector<std::uint8_t>& into) {
    into.clear();
    ByteWriter out(into);
    const arm::ArmState& arm = *now.arm;
    const std::size_t size = realtimeRecordSize(now.software);
    out.u32(static_cast<std::uint32_t>(size)).f64(now.timestamp);
    six(out, arm.targetQ.values);
    six(out, arm.targetQd.values);
    six(out, arm.targetQdd.values);
    six(out, arm.targetCurrent);
    six(out, arm.targetMoment.values);
    six(out, arm.actualQ.values);
    six(out, arm.actualQd.values);
    six(out, arm.actualCurrent);
    six(out, arm.jointControlOutput);
    out.f64s(arm.actualTcpPose.array());
    six(out, arm.actualTcpSpeed.vector());
    six(out, now.tcpForce.vector());
    out.f64s(arm.targetTcpPose.array());
    six(out, arm.targetTcpSpeed.vector());
    bits(out, now, now.pins->digitalInputs);
    six(out, arm.jointTemperature);
    out.f64(now.executionTime);
    unused(out, 1);
    out.f64(static_cast<double>(now.robotMode));
    six(out, Vector6::Constant(static_cast<double>(now.jointMode)));
    out.f64(static_cast<double>(now.safetyMode));
    unused(out, 6);
    three(out, arm.toolAccelerometer);
    unused(out, 6);
    out.f64(now.speedScaling).f64(arm.momentum);
    unused(out, 2);
    out.f64(arm.mainVoltage).f64(arm.robotVoltage).f64(arm.robotCurrent);
    six(out, arm.jointVoltage);
    bits(out, now, now.pins->digitalOutputs);
    out.f64(static_cast<double>(now.runtimeState));
    three(out, arm.elbowPosition);
    three(out, arm.elbowVelocity);
    out.f64(static_cast<double>(now.safetyStatus));
    unused(out, 3);
    out.f64(now.payload.mass);
    three(out, now.payload.centreOfGravity);
    six(out, now.payload.inertia);
    into.resize(size);  // older software has shorter records
}

}  // namespace tiller::simulator
