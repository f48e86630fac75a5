// SPDX-License-Identifier: MIT
#pragma once

// State of the simulated arm after each control period: the values that RTDE and the primary interface
// report. Plain data in SI units. Vectors are in the base frame unless a name states otherwise. `target`
// values come from the motion generator, `actual` values from the simulated drives and sensors.

#include <Eigen/Core>
#include <cstdint>

#include "robot/core/joints.h"
#include "robot/core/spatial.h"

namespace tiller::simulator::arm {

/// Payload set on the controller: mass [kg], centre of gravity in the flange frame [m], and inertia about the
/// centre of gravity Ixx, Iyy, Izz, Ixy, Ixz, Iyz [kg m2].
struct Payload {
    double mass = 0;
    Eigen::Vector3d centreOfGravity = Eigen::Vector3d::Zero();
    Vector6 inertia = Vector6::Zero();

    friend bool operator==(const Payload&, const Payload&) = default;
};

/// Power state of the joints. The arm moves only in Running; in the other two states, the brakes hold it.
enum class DriveState : std::uint8_t {
    Off,      ///< no joint power: no voltage, no current
    Braked,   ///< powered, brakes applied: robot mode IDLE
    Running,  ///< powered, brakes released, position control
};

/// Reason for a reduced speed scaling, with the numbers used by RTDE.
enum class TimeScaleSource : std::int32_t {
    Other = -1,
    NoProgram = 0,
    NotScaled = 1,
    ToolSpeed = 8,
    JointSpeed = 10,
};

struct ArmState {
    // joints
    JointPositions targetQ;                         ///< target_q [rad]
    JointVelocities targetQd;                       ///< target_qd [rad/s]
    JointAccelerations targetQdd;                   ///< target_qdd [rad/s2]
    JointPositions actualQ;                         ///< actual_q [rad]
    JointVelocities actualQd;                       ///< actual_qd [rad/s]
    Vector6 targetCurrent = Vector6::Zero();        ///< target_current [A]
    Vector6 actualCurrent = Vector6::Zero();        ///< actual_current [A]
    Vector6 actualCurrentWindow = Vector6::Zero();  ///< actual_current_window [A]
    Vector6 jointControlOutput = Vector6::Zero();   ///< joint_control_output [A]
    JointTorques targetMoment;                      ///< target_moment [Nm]
    JointTorques actualMoment;                      ///< actual_current_as_torque [Nm]
    JointTorques
        externalTorque;  ///< get_joint_torques(): actual torque minus the expected torque of the model [Nm]
    Vector6 jointTemperature = Vector6::Zero();  ///< joint_temperatures [degC]
    Vector6 jointVoltage = Vector6::Zero();      ///< actual_joint_voltage [V]
    double positionDeviationRatio{};  ///< joint_position_deviation_ratio; 1 causes a protective stop

    // tool: values of the TCP in the base frame, unless noted otherwise
    Pose targetTcpPose;           ///< target_TCP_pose
    Twist targetTcpSpeed;         ///< target_TCP_speed
    Twist targetTcpAcceleration;  ///< target_TCP_acceleration [m/s2, rad/s2]
    Pose actualTcpPose;           ///< actual_TCP_pose
    Twist actualTcpSpeed;         ///< actual_TCP_speed
    Twist actualTcpAcceleration;  ///< actual_TCP_acceleration [m/s2, rad/s2]
    Pose actualFlangePose;        ///< pose of the flange in the base frame
    Wrench tcpForce;              ///< actual_TCP_force: external force on the tool, base axes
    double tcpForceScalar{};      ///< tcp_force_scalar [N]
    Wrench ftRawWrench;           ///< ft_raw_wrench: flange frame, neither compensated nor zeroed
    Wrench wrenchFromCurrents;    ///< wrench_calc_from_currents: base axes at the TCP
    Eigen::Vector3d toolAccelerometer =
        Eigen::Vector3d::Zero();  ///< actual_tool_accelerometer, tool frame [m/s2]
    Eigen::Vector3d elbowPosition = Eigen::Vector3d::Zero();  ///< elbow_position, base frame [m]
    Eigen::Vector3d elbowVelocity = Eigen::Vector3d::Zero();  ///< elbow_velocity, base frame [m/s]
    Wrench targetBaseWrench;  ///< target_base_wrench: force and torque at the base, base axes
    double momentum{};        ///< actual_momentum [kg m/s]

    // supply
    double mainVoltage{};      ///< actual_main_voltage [V]
    double robotVoltage{};     ///< actual_robot_voltage [V]
    double robotCurrent{};     ///< actual_robot_current [A]
    double toolCurrent{};      ///< [A]
    double toolTemperature{};  ///< tool_temperature [degC]
    double energyConsumed{};   ///< actual_robot_energy_consumed [J]
    double energyBraked{};     ///< actual_robot_braking_energy_dissipated [J]
    /// collision_detection_ratio: contact force relative to the force that stops the arm; 1 causes a
    /// protective stop.
    double collisionRatio{};

    // motion
    /// speed_scaling: factor 0..1 by which the trajectory limiter, a pause or a resume slows the motion. Does
    /// not include the speed slider.
    double speedScaling = 1;
    TimeScaleSource scaledBy =
        TimeScaleSource::NotScaled;  ///< reason for a scaling below 1, time_scale_source
    double speedFraction = 1;        ///< setting of the speed slider (target_speed_fraction), 0..1
    double standstillTime{};         ///< time since the target velocity became zero [s]
    std::uint64_t controlStep{};     ///< control periods since construction

    /// is_steady(): at rest for 0.5 s.
    bool isSteady() const { return standstillTime >= 0.5; }
    /// True while the target does not move.
    bool isStandstill() const { return standstillTime > 0; }
};

}  // namespace tiller::simulator::arm
