// SPDX-License-Identifier: MIT
#pragma once

// A sample read with types: joint positions as joint positions, modes as modes. It only looks, and holds no
// values of its own.

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

/// No data is never a number. What is not there (no packet yet, a field that is not followed, one that the
/// robot does not send) reads as NaN; words of bits and integers, which know no NaN, are empty optionals;
/// modes are the most cautious one (Disconnected, Undefined, Stopped, PowerOff) and single bits false. Every
/// command that moves the arm refuses NaN, so a target computed from nothing goes nowhere. To be sure of data
/// first: Receiver::waitForData(). The sample must outlive it.
/// Threads  any one. Real-time: yes (a hash look-up per call)
class RobotState {
public:
    explicit RobotState(const Sample& sample) : sample_(&sample) {}
    explicit RobotState(const Sample&&) = delete;

    /// The sample holds that field.
    bool has(std::string_view field) const { return !sample_->field(field).empty(); }
    /// One number of a field, or the fallback.
    double number(std::string_view field, std::size_t component = 0, double fallback = kAbsent) const;

    double timestamp() const { return number("timestamp"); }  ///< [s] since the controller started

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

    Pose tcpPose() const { return pose("actual_TCP_pose"); }                                 ///< T_base_tcp
    Pose targetTcpPose() const { return pose("target_TCP_pose"); }                           ///< T_base_tcp
    Pose tcpOffset() const { return pose("tcp_offset"); }                                    ///< T_flange_tcp
    Twist tcpSpeed() const { return Twist::fromVector(vector6("actual_TCP_speed")); }        ///< base frame
    Twist targetTcpSpeed() const { return Twist::fromVector(vector6("target_TCP_speed")); }  ///< [m/s, rad/s]
    Wrench tcpForce() const { return Wrench::fromVector(vector6("actual_TCP_force")); }      ///< base frame
    Wrench rawWrench() const { return Wrench::fromVector(vector6("ft_raw_wrench")); }        ///< flange frame

    RobotMode robotMode() const;        ///< DISCONNECTED when absent.
    SafetyMode safetyMode() const;      ///< UNDEFINED when absent.
    RuntimeState runtimeState() const;  ///< STOPPED when absent.
    /// See is().
    std::optional<std::uint32_t> robotStatusBits() const { return bits32("robot_status_bits"); }
    /// See is().
    std::optional<std::uint32_t> safetyStatusBits() const { return bits32("safety_status_bits"); }
    bool is(RobotStatusBit bit) const {  ///< False when absent.
        return (robotStatusBits().value_or(0) & static_cast<std::uint32_t>(bit)) != 0;
    }
    bool is(SafetyStatusBit bit) const {  ///< False when absent.
        return (safetyStatusBits().value_or(0) & static_cast<std::uint32_t>(bit)) != 0;
    }

    double speedScaling() const { return number("speed_scaling"); }         ///< 0 ... 1
    double speedSlider() const { return number("target_speed_fraction"); }  ///< 0 ... 1

    /// Bits 0-7 standard, 8-15 configurable, 16-17 tool.
    std::optional<std::uint64_t> digitalInputs() const { return bits64("actual_digital_input_bits"); }
    /// Numbered as the inputs.
    std::optional<std::uint64_t> digitalOutputs() const { return bits64("actual_digital_output_bits"); }
    double analogInput(int channel) const;   ///< 0 or 1 [mA or V, as analogIoTypes() says]
    double analogOutput(int channel) const;  ///< 0 or 1 [mA or V]
    /// Bits AI0, AI1, AO0, AO1: 0 current, 1 voltage.
    std::optional<std::uint32_t> analogIoTypes() const { return bits32("analog_io_types"); }

    double payloadMass() const { return number("payload"); }  ///< [kg]
    Eigen::Vector3d payloadCentreOfGravity() const;           ///< [m]

    /// Registers the receiver was asked to follow.
    std::optional<int> outputIntRegister(int number) const;
    double outputDoubleRegister(int number) const;  ///< NaN when absent.

private:
    Vector6 vector6(std::string_view field) const;
    Pose pose(std::string_view field) const;
    std::optional<std::uint32_t> bits32(std::string_view field) const;
    std::optional<std::uint64_t> bits64(std::string_view field) const;

    const Sample* sample_;
};

}  // namespace tiller::receive
