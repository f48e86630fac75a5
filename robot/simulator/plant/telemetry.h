// SPDX-License-Identifier: MIT
#pragma once

// All values of the robot that clients can receive, at the end of one control period. The RTDE, primary and
// realtime encoders read them. Refers to data of Plant and is valid until the next step.

#include <array>
#include <cstdint>

#include "robot/core/modes.h"
#include "robot/core/robot_model.h"
#include "robot/core/spatial.h"
#include "robot/core/version.h"
#include "robot/simulator/arm/arm_state.h"
#include "robot/simulator/plant/pins.h"
#include "robot/simulator/plant/registers.h"
#include "robot/simulator/plant/safety_system.h"

namespace tiller::simulator {

struct Telemetry {
    const arm::ArmState* arm = nullptr;
    const Registers* registers = nullptr;
    const Pins* pins = nullptr;
    const RobotModel* model = nullptr;  ///< as reported by the controller
    std::uint64_t identity = 0;         ///< changes with `model`
    std::uint64_t boots = 0;            ///< changes each time the services restart
    SoftwareVersion software;
    bool bitsAsIntegers = false;  ///< port 30003: digital inputs and outputs as integers

    std::uint64_t tick = 0;
    double timestamp = 0;      ///< [s] since the controller started
    double executionTime = 0;  ///< [ms] of the real-time thread; simulated, not measured

    RobotMode robotMode = RobotMode::PowerOff;
    SafetyMode safetyMode = SafetyMode::Normal;
    SafetyMode safetyStatus = SafetyMode::Normal;
    OperationalMode operationalMode = OperationalMode::None;
    std::uint32_t safetyStatusBits = 1;
    RuntimeState runtimeState = RuntimeState::Stopped;
    bool programPaused = false;
    bool powered = false;
    bool protectiveStopped = false;
    bool emergencyStopped = false;
    bool reduced = false;
    bool freedriveButton = false;
    bool freedrive = false;
    bool forceMode = false;
    JointMode jointMode = JointMode::PowerOff;

    double speedSlider = 1;
    double speedScaling = 0;  ///< 0 while no program runs
    arm::TimeScaleSource timeScaleSource = arm::TimeScaleSource::NoProgram;
    std::uint32_t scriptLine = 0;
    std::array<std::int32_t, 2> encoders{};  ///< counts of the conveyor encoders

    Pose tcpOffset;
    arm::Payload payload;
    Eigen::Vector3d gravity = Eigen::Vector3d::Zero();
    Wrench tcpForce;  ///< [N, Nm] including an external sensor

    bool programRunning() const { return runtimeState != RuntimeState::Stopped; }
    /// Value of robot_status_bits. Source: RTDE guide.
    std::uint32_t robotStatusBits() const {
        return (powered ? 1U : 0U) | (programRunning() && !programPaused ? 2U : 0U) |
               (freedriveButton ? 4U : 0U);
    }
    std::uint64_t timestampNs() const { return static_cast<std::uint64_t>(timestamp * 1e9); }
};

}  // namespace tiller::simulator
