// SPDX-License-Identifier: MIT
#pragma once

// The simulated arm. It accepts motion commands, is stepped once per control period, and provides its state.
// It is deterministic (seeded noise) and uses no threads, sockets or URScript. step() does not allocate
// memory.
//
//     Arm arm(robotModel(RobotModelId::UR5e));
//     arm.setDriveState(DriveState::Running);
//     const MotionStart move = arm.motion().moveJ(target, {1.4, 1.05});
//     while (arm.motion().progress(move.id) == MotionProgress::Running) arm.step();

#include <cstdint>
#include <memory>
#include <optional>

#include "robot/core/joints.h"
#include "robot/core/robot_model.h"
#include "robot/core/spatial.h"
#include "robot/simulator/arm/arm_state.h"
#include "robot/simulator/arm/compliance.h"
#include "robot/simulator/arm/environment.h"
#include "robot/simulator/arm/motion.h"
#include "robot/simulator/arm/motion_types.h"
#include "robot/simulator/arm/superposition.h"

namespace tiller::simulator::arm {

struct ArmOptions {
    double period = 0;       ///< control period [s]; 0: 0.002, or 0.008 for CB3 models
    std::uint64_t seed = 1;  ///< seed of the sensor noise
    bool ideal = false;      ///< no noise and no tracking lag: actual equals target
    /// Start position, the same as in the manufacturer's simulator. Source: recorded primary packet.
    JointPositions start{-1.6007, -1.7271, -2.2030, -0.8080, 1.5951, -0.0310};
};

class Arm {
public:
    explicit Arm(const RobotModel& model, const ArmOptions& options = {});
    ~Arm();
    Arm(const Arm&) = delete;
    Arm& operator=(const Arm&) = delete;

    void step();
    double period() const;
    const RobotModel& model() const;
    const ArmState& state() const;

    Motion& motion();          ///< moves, servo, speed, stops
    Compliance& compliance();  ///< force mode, freedrive
    /// Path offset and conveyor tracking. Start them only while neither force mode nor freedrive is active.
    Superposition& superposition();
    Environment& environment();  ///< actual environment: load, hand, surfaces, boxes

    // power and program time
    /// Sets the power state of the joints. Leaving Running stops the motion at once (brakes) and discards all
    /// commands.
    void setDriveState(DriveState state);
    DriveState driveState() const;
    /// Sets the speed slider, 0..1 (clamped). The value is ramped internally.
    void setSpeedFraction(double fraction);
    /// Pauses: decelerates on the path and freezes program time. resume() continues from there.
    void hold();
    void resume();
    bool isHeld() const;
    void setReadings(const Readings& readings);
    /// Ends all motion: discards all commands, ends force mode and freedrive, and stops in joint space with
    /// `deceleration` [rad/s2] of the leading axis. Used for stops of the program and stops of category 1.
    void abort(double deceleration = 10.0);

    /// Ends path offset or conveyor tracking and decelerates all joints with `deceleration` [rad/s2] of the
    /// leading axis. The program continues from the resulting position.
    MotionStart endPathOffset(double deceleration);
    MotionStart endConveyorTracking(double deceleration);
    /// Limits the TCP speed of programmed motion [m/s], as in reduced mode. Empty: only the joints limit the
    /// speed.
    void setToolSpeedLimit(const std::optional<double>& limit);
    /// Simulates a protective stop detected by the arm.
    void raiseProtectiveStop(StopReason reason);

    /// The protective stop triggered by the arm; empty after it has been cleared.
    const std::optional<ProtectiveStop>& protectiveStop() const;
    void clearProtectiveStop();
    /// Returns each warning once; empty without a new warning.
    std::optional<MotionWarning> takeWarning();

    // tool and mounting
    void setTcp(const Pose& T_flange_tcp);
    const Pose& tcp() const;
    /// Sets the configured payload, which is also the actual load unless environment().setLoad() has set
    /// another load.
    /// transition  time over which the payload changes linearly [s]
    void setPayload(const Payload& payload, double transition = 0);
    const Payload& payload() const;
    /// Sets gravity as measured by an accelerometer at the base [m/s2]; [0, 0, 9.82] when upright.
    void setGravity(const Eigen::Vector3d& gravity);
    const Eigen::Vector3d& gravity() const;
    /// Sets the reading of an external force sensor for force mode, base axes at the TCP [N, Nm]. Empty:
    /// force mode uses the internal sensor.
    void setExternalForce(const std::optional<Wrench>& wrench);
    /// External force on the tool that the controller does not expect [N]: hand, contact, unknown load.
    double unexplainedForce() const;
    /// zero_ftsensor(): uses the current reading as the zero point.
    void zeroForceSensor();
    /// set_pos(): moves the arm to q at once, at rest, and discards all commands.
    void setJointPositions(const JointPositions& q);

    // history and model
    /// Joint positions `steps` control periods ago (0 = now); empty beyond the last 10 s.
    std::optional<JointPositions> jointHistory(int steps) const;
    /// tool_contact(): number of control periods back to the last period before the contact; 0: no contact.
    /// direction  in base axes; zero: any direction
    int toolContact(const Eigen::Vector3d& direction) const;
    /// rotors  whether to include the inertia of the motors, as seen by the joints
    Matrix6 massMatrix(const JointPositions& q, bool rotors = false) const;
    JointTorques coriolisTorques(const JointPositions& q, const JointVelocities& qd) const;

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace tiller::simulator::arm
