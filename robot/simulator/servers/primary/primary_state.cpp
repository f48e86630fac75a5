// SPDX-License-Identifier: MIT
#include "robot/simulator/servers/primary/primary_state.h"

#include <span>

#include "robot/simulator/net/byte_writer.h"

namespace tiller::simulator::primary {

namespace {

constexpr unsigned kRobotState = 16;
/// Manufacturer-specific field of MasterboardData and SafetyData.
constexpr std::uint32_t kInternalWord = 1475618907;

/// The manual lists these additions for "newer software" than the recorded 5.8. The first version, 5.10, is
/// an assumption.
bool isNewer(const Telemetry& now) {
    return now.software >= SoftwareVersion{5, 10, 0, 0};
}

/// True for versions in which the masterboard data have one more byte. Clients refuse packages of another
/// size. Source: urcl reads all 75 bytes of software 3.14; ur_modern_driver reads 74 bytes of 3.2 and fails
/// with 3.10 and 5.4.
bool hasSafetyStatus(const SoftwareVersion& software) {
    return software >= (software.isCb3() ? SoftwareVersion{3, 10, 0, 0} : SoftwareVersion{5, 4, 0, 0});
}

/// False for older software, in which type 5 was a different package, which clients ignore. Source: urx.
bool hasKinematics(const SoftwareVersion& software) {
    return software >= SoftwareVersion{3, 6, 0, 0};
}

template <class Body>
void part(ByteWriter& out, unsigned type, Body body) {
    const std::size_t length = out.openLength();
    out.u8(type);
    body();
    out.closeLength(length);
}

std::span<const double, 6> six(const Vector6& v) {
    return std::span<const double, 6>(v.data(), 6);
}

void modeData(ByteWriter& out, const Telemetry& now) {
    part(out, 0, [&] {
        out.u64(now.timestampNs());
        const bool connected = now.robotMode != RobotMode::Disconnected;
        out.flag(connected).flag(connected).flag(now.powered);
        out.flag(now.emergencyStopped).flag(now.protectiveStopped);
        out.flag(now.programRunning() && !now.programPaused).flag(now.programPaused);
        out.u8(static_cast<unsigned>(now.robotMode));
        out.u8(now.freedrive ? 1 : now.forceMode ? 2 : 0);
        out.f64(now.speedSlider).f64(now.speedScaling);
        if (now.software >= SoftwareVersion{3, 2, 0, 0}) {
            out.f64(1.0);
        }
        if (now.software >= SoftwareVersion{3, 5, 0, 0}) {
            out.u8(0);
        }
    });
}

void jointData(ByteWriter& out, const Telemetry& now) {
    part(out, 1, [&] {
        const arm::ArmState& arm = *now.arm;
        for (int i = 0; i < kJointCount; ++i) {
            out.f64(arm.actualQ[i]).f64(arm.targetQ[i]).f64(arm.actualQd[i]);
            out.f32(arm.actualCurrent[i]).f32(arm.jointVoltage[i]);
            out.f32(arm.jointTemperature[i]).f32(0);
            out.u8(static_cast<unsigned>(now.jointMode));
        }
    });
}

void cartesianInfo(ByteWriter& out, const Telemetry& now) {
    part(out, 4, [&] {
        out.f64s(now.arm->actualTcpPose.array());
        if (now.software >= SoftwareVersion{3, 2, 0, 0}) {
            out.f64s(now.tcpOffset.array());
        }
    });
}

void kinematicsInfo(ByteWriter& out, const Telemetry& now) {
    part(out, 5, [&] {
        for (int i = 0; i < kJointCount; ++i) {
            out.u32(0xFFFFFFFFU);
        }
        const DhParameters& dh = now.model->dh;
        out.f64s(dh.theta).f64s(dh.a).f64s(dh.d).f64s(dh.alpha);
        out.u32(0);
    });
}

void calibrationData(ByteWriter& out, const Telemetry& now) {
    part(out, 9, [&] { out.f64s(six(now.arm->ftRawWrench.vector())); });
}

void masterboardData(ByteWriter& out, const Telemetry& now) {
    part(out, 3, [&] {
        const Pins& pins = *now.pins;
        out.u32(static_cast<std::uint32_t>(pins.digitalInputs));
        out.u32(static_cast<std::uint32_t>(pins.digitalOutputs));
        out.u8(pins.analogInputDomains[0]).u8(pins.analogInputDomains[1]);
        out.f64(pins.analogInputs[0]).f64(pins.analogInputs[1]);
        out.u8(pins.analogOutputDomains[0]).u8(pins.analogOutputDomains[1]);
        out.f64(pins.analogOutput(0)).f64(pins.analogOutput(1));
        out.f32(24).f32(now.arm->robotVoltage).f32(now.arm->robotCurrent).f32(0);
        out.u8(static_cast<unsigned>(now.safetyMode));
        out.flag(now.reduced).u8(0);
        out.u32(kInternalWord);
        if (now.software >= SoftwareVersion{3, 2, 0, 0}) {
            // Mode selector: 0 for MANUAL, otherwise 1. A robot without a selector also reports 1
            // (unconfirmed).
            out.u8(now.operationalMode == OperationalMode::Manual ? 0 : 1);
            out.flag(now.safetyStatus != SafetyMode::SystemThreePositionEnablingStop);
        }
        if (hasSafetyStatus(now.software)) {
            out.u8(1);
        }
    });
}

void toolData(ByteWriter& out, const Telemetry& now) {
    part(out, 2, [&] {
        const Pins& pins = *now.pins;
        out.u8(pins.toolAnalogDomains[0]).u8(pins.toolAnalogDomains[1]);
        out.f64(pins.toolAnalogInputs[0]).f64(pins.toolAnalogInputs[1]);
        out.f32(now.powered ? 48 : 0).u8(static_cast<unsigned>(pins.toolVoltage));
        out.f32(now.arm->toolCurrent).f32(now.arm->toolTemperature);
        out.u8(static_cast<unsigned>(now.powered ? JointMode::Running : JointMode::PowerOff));
    });
}

int controllerBoxType(const RobotModel& model) {
    switch (model.robotType) {
        case 2:
            return 5;
        case 3:
            return 6;
        case 4:
            return 16;
        default:
            return 4;
    }
}

void configurationData(ByteWriter& out, const Telemetry& now) {
    part(out, 6, [&] {
        for (int i = 0; i < kJointCount; ++i) {
            out.f64(-kJointPositionLimit).f64(kJointPositionLimit);
        }
        for (const double speed : now.model->maxJointSpeed) {
            out.f64(speed + 0.2).f64(kJointAccelerationLimit);
        }
        out.f64(1.0471975511965976).f64(1.3962634015954636).f64(0.25).f64(1.2).f64(0.25);
        const DhParameters& dh = now.model->dh;
        out.f64s(dh.a).f64s(dh.d).f64s(dh.alpha).f64s(dh.theta);
        out.i32(6).i32(controllerBoxType(*now.model)).i32(now.model->robotType);
        out.i32(now.model->isCb3() ? 2 : 3);
        if (isNewer(now)) {
            // Types of the control box and the tool flange. Reserved fields in older software.
            const bool isKnown = now.software >= (now.software.isPolyScopeX() ? SoftwareVersion{10, 13, 0, 0}
                                                                              : SoftwareVersion{5, 26, 0, 0});
            out.u16(isKnown ? 5 : 0).u16(isKnown ? 1 : 0);
        }
    });
}

void forceModeData(ByteWriter& out, const Telemetry& now) {
    part(out, 7, [&] { out.f64s(six(now.tcpForce.vector())).f64(0); });
}

void smallParts(ByteWriter& out, const Telemetry& now) {
    part(out, 8, [&] { out.flag(now.freedriveButton).flag(true).flag(false).u8(1); });
    part(out, 10, [&] { out.u32(kInternalWord).u8(1).u8(1).f64(0).f64(0).f64(0).f64(0); });
    if (!now.software.isCb3()) {  // not available on the CB3 tool connector
        part(out, 11, [&] {
            const Pins::ToolCommunication& tool = now.pins->toolCommunication;
            out.flag(tool.enabled).i32(tool.baudRate).i32(tool.parity).i32(tool.stopBits);
            out.f32(tool.rxIdleChars).f32(tool.txIdleChars);
        });
        part(out, 12, [&] {
            out.u8(static_cast<unsigned>(now.pins->toolOutputMode));
            for (const auto mode : now.pins->toolDigitalOutputModes) {
                out.u8(static_cast<unsigned>(mode));
            }
        });
    }
    if (isNewer(now)) {
        part(out, 13, [&] { out.u8(0).u8(0); });  // no singularity nearby
    }
}

}  // namespace

std::vector<std::uint8_t> robotState(const Telemetry& now, bool first) {
    std::vector<std::uint8_t> bytes;
    bytes.reserve(1400);
    ByteWriter out(bytes);
    const std::size_t length = out.openLength();
    out.u8(kRobotState);
    modeData(out, now);
    jointData(out, now);
    cartesianInfo(out, now);
    if (first && hasKinematics(now.software)) {
        kinematicsInfo(out, now);
    }
    calibrationData(out, now);
    masterboardData(out, now);
    toolData(out, now);
    if (first) {
        configurationData(out, now);
    }
    forceModeData(out, now);
    smallParts(out, now);
    out.closeLength(length);
    return bytes;
}

}  // namespace tiller::simulator::primary
