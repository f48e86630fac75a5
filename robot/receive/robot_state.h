// SPDX-License-Identifier: MIT
#pragma once

// Typed access to the values of a sample, e.g. joint positions and modes. The class is a view that does not
// own the values.

#include <cstdint>
#include <optional>
#include <string_view>

#include "robot/core/joints.h"
#include "robot/core/modes.h"
#include "robot/core/spatial.h"
#include "robot/receive/sample.h"

namespace tiller::receive {

/// Bits of robot_status_bits. Source: RTDE guide.
enum class RobotStatusBit : std::uint32_t {
    PowerOn = 1U << 0,
    ProgramRunning = 1U << 1,
    FreedriveButton = 1U << 2,
    PowerButton = 1U << 3,
};

/// Bits of safety_status_bits. Source: RTDE guide.
enum class SafetyStatusBit : std::uint32_t {
    Normal = 1U << 0,
    Reduced = 1U << 1,
    ProtectiveStopped = 1U << 2,
    Recovery = 1U << 3,
    SafeguardStopped = 1U << 4,
    SystemEmergencyStopped = 1U << 5,
    RobotEmergencyStopped = 1U << 6,
    EmergencyStopped = 1U << 7,
    Violation = 1U << 8,
    Fault = 1U << 9,
    StoppedDueToSafety = 1U << 10,
    ThreePositionEnabling = 1U << 11,
};

/// Missing values (no packet yet, a field that was not requested, or a field that the robot does not send)
/// are returned as NaN, bit fields and integers as empty optionals, and single bits as false. Missing modes
/// have the most restrictive value (Disconnected, Undefined, Stopped, PowerOff). All motion commands refuse
/// NaN, so a target computed from missing data is not executed. To wait for data, use
/// Receiver::waitForData(). The sample must outlive this object.
/// Threads  one at a time. Real-time: yes (one hash look-up per call)
class RobotState {
public:
    explicit RobotState(const Sample& sample) : sample_(&sample) {}
    explicit RobotState(const Sample&&) = delete;

    /// True if the sample contains the field.
    bool has(std::string_view field) const { return !sample_->field(field).empty(); }
    /// One component of a field, or the fallback if missing.
    double number(std::string_view field, std::size_t component = 0, double fallback = kAbsent) const;

    double timestamp() const { return number("timestamp"); }  ///< time since the start of the controller [s]

    JointPositions q() const { return JointPositions(vector6("actual_q")); }                    ///< [rad]
    JointVelocities qd() const { return JointVelocities(vector6("actual_qd")); }                ///< [rad/s]
    JointPositions targetQ() const { return JointPositions(vector6("target_q")); }              ///< [rad]
    JointVelocities targetQd() const { return JointVelocities(vector6("target_qd")); }          ///< [rad/s]
    JointAccelerations targetQdd() const { return JointAccelerations(vector6("target_qdd")); }  ///< [rad/s2]
    JointTorques targetTorque() const { return JointTorques(vector6("target_moment")); }        ///< [Nm]
    Vector6 jointCurrent() const { return vector6("actual_current"); }                          ///< [A]
    Vector6 targetCurrent() const { return vector6("target_current"); }                         ///< [A]
    Vector6 jointTemperature() const { return vector6("joint_temperatures"); }                  ///< [degC]
    Vector6 jointVoltage() const { return vector6("actual_joint_voltage"); }                    ///< [V]
    std::array<JointMode, 6> jointModes() const;  ///< Base to wrist 3.

    Pose tcpPose() const { return pose("actual_TCP_pose"); }        ///< T_base_tcp
    Pose targetTcpPose() const { return pose("target_TCP_pose"); }  ///< T_base_tcp
    Pose tcpOffset() const { return pose("tcp_offset"); }           ///< T_flange_tcp
    /// TCP velocity in the base frame [m/s, rad/s].
    Twist tcpSpeed() const { return Twist::fromVector(vector6("actual_TCP_speed")); }
    /// Target TCP velocity in the base frame [m/s, rad/s].
    Twist targetTcpSpeed() const { return Twist::fromVector(vector6("target_TCP_speed")); }
    /// Force and torque at the TCP in the base frame [N, Nm].
    Wrench tcpForce() const { return Wrench::fromVector(vector6("actual_TCP_force")); }
    /// Reading of the force sensor in the flange frame, not zeroed and including the payload [N, Nm].
    Wrench rawWrench() const { return Wrench::fromVector(vector6("ft_raw_wrench")); }

    RobotMode robotMode() const;        ///< DISCONNECTED if missing.
    SafetyMode safetyMode() const;      ///< UNDEFINED if missing.
    RuntimeState runtimeState() const;  ///< STOPPED if missing.
    /// For single bits, use is().
    std::optional<std::uint32_t> robotStatusBits() const { return bits32("robot_status_bits"); }
    /// For single bits, use is().
    std::optional<std::uint32_t> safetyStatusBits() const { return bits32("safety_status_bits"); }
    bool is(RobotStatusBit bit) const {  ///< False if missing.
        return (robotStatusBits().value_or(0) & static_cast<std::uint32_t>(bit)) != 0;
    }
    bool is(SafetyStatusBit bit) const {  ///< False if missing.
        return (safetyStatusBits().value_or(0) & static_cast<std::uint32_t>(bit)) != 0;
    }

    double speedScaling() const { return number("speed_scaling"); }         ///< 0 ... 1
    double speedSlider() const { return number("target_speed_fraction"); }  ///< 0 ... 1

    /// Bits 0-7 standard, 8-15 configurable, 16-17 tool.
    std::optional<std::uint64_t> digitalInputs() const { return bits64("actual_digital_input_bits"); }
    /// Same bit numbers as digitalInputs().
    std::optional<std::uint64_t> digitalOutputs() const { return bits64("actual_digital_output_bits"); }
    double analogInput(int channel) const;   ///< Channel 0 or 1 [mA or V, see analogIoTypes()].
    double analogOutput(int channel) const;  ///< Channel 0 or 1 [mA or V].
    /// Bits AI0, AI1, AO0, AO1: 0 = current, 1 = voltage.
    std::optional<std::uint32_t> analogIoTypes() const { return bits32("analog_io_types"); }

    double payloadMass() const { return number("payload"); }  ///< [kg]
    Eigen::Vector3d payloadCentreOfGravity() const;           ///< flange frame [m]

    /// Empty if missing.
    std::optional<int> outputIntRegister(int number) const;
    double outputDoubleRegister(int number) const;  ///< NaN if missing.

private:
    Vector6 vector6(std::string_view field) const;
    Pose pose(std::string_view field) const;
    std::optional<std::uint32_t> bits32(std::string_view field) const;
    std::optional<std::uint64_t> bits64(std::string_view field) const;

    const Sample* sample_;
};

}  // namespace tiller::receive
