// SPDX-License-Identifier: MIT
#pragma once

// Response of the drives and sensors of the arm to a target: encoders with a small lag and noise, motor
// currents, the force/torque sensor at the flange, temperatures, power supply.

#include <cstdint>

#include "robot/simulator/arm/arm_geometry.h"
#include "robot/simulator/arm/arm_state.h"
#include "robot/simulator/arm/dynamics.h"
#include "robot/simulator/arm/environment.h"
#include "robot/simulator/arm/joint_limits.h"

namespace tiller::simulator::arm {

/// Small and fast seeded noise source. The noise is bounded, with mean 0 and the given standard deviation
/// (sum of four uniform values).
class Noise {
public:
    explicit Noise(std::uint64_t seed) : state_(seed * 0x9E3779B97F4A7C15ull + 0x1234567ull) {}
    double operator()(double standardDeviation);
    Eigen::Vector3d vector(double standardDeviation);
    /// Turns the noise on or off. If the noise is off, every value is 0.
    void setOn(bool on) { scale_ = on ? 1 : 0; }

private:
    double uniform();
    std::uint64_t state_;
    double scale_ = 1;
};

class Sensors {
public:
    Sensors(const ArmGeometry& geometry, double period, std::uint64_t seed, bool ideal);

    void setNoise(bool on) { noise_.setOn(on); }
    void setGravity(const Eigen::Vector3d& gravity);
    const Eigen::Vector3d& gravity() const { return gravity_; }
    void setPayload(const Payload& payload);
    const Payload& payload() const { return payload_; }
    /// Uses the current force reading as the zero point.
    void zeroForce();
    void place(const Vector6& q);

    /// Updates the members of `state` that depend on the new target.
    void update(const JointTarget& target, DriveState drive, const Environment& environment, ArmState& state);

    Dynamics& dynamics() { return model_; }
    /// External force on the TCP that the controller does not expect: hand, contact, unknown load.
    const Wrench& unexplained() const { return unexplained_; }
    double contactForce() const { return contact_; }
    /// The joint torques [Nm] that correspond to unexplained().
    Vector6 unexplainedTorques() const;
    /// Index of a joint that cannot hold its load even at standstill; -1: no overload.
    int overloadedJoint();

private:
    void updateKinematics(const JointTarget& target, ArmState& state);
    void updateBase(const JointTarget& target, ArmState& state);
    void updateForces(const Environment& environment, DriveState drive, ArmState& state);
    void updateDrives(DriveState drive, ArmState& state);
    void updateSupply(DriveState drive, ArmState& state);
    Eigen::Vector3d accelerationOf(const Eigen::Vector3d& point) const;
    Wrench loadOnFlange(const Payload& load) const;

    const ArmGeometry& geometry_;
    double period_;
    bool ideal_;
    Noise noise_;
    Dynamics model_;  // dynamics with the configured payload
    Dynamics real_;   // dynamics with the actual load
    Payload payload_;
    Payload load_;
    bool loadHangs_ = false;  // the actual load differs from the configured payload
    Eigen::Vector3d gravity_{0, 0, 9.82};

    Vector6 q_ = Vector6::Zero();  // actual joint positions
    Vector6 qd_ = Vector6::Zero();
    Vector6 qdd_ = Vector6::Zero();
    Vector6 needed_ = Vector6::Zero();  // actual joint torques
    Posture target_;
    Posture actual_;
    Twist targetTwist_;
    Twist actualTwist_;
    Eigen::Vector3d linear_ = Eigen::Vector3d::Zero();  // momentum of the target motion
    Eigen::Vector3d angular_ = Eigen::Vector3d::Zero();
    Eigen::Vector3d tcpAcceleration_ = Eigen::Vector3d::Zero();  // TCP acceleration of the target motion
    Eigen::Vector3d tcpTurning_ = Eigen::Vector3d::Zero();
    Wrench atFlange_;     // external force and load, flange frame
    Wrench external_;     // external wrench on the flange without load, flange frame; input of the dynamics
    Wrench unexplained_;  // base axes at the TCP
    Wrench compensated_;  // flange frame, before zeroing
    Wrench zero_;         // flange frame
    Wrench offset_;       // offset of the raw sensor
    double contact_ = 0;
    bool first_ = true;
};

}  // namespace tiller::simulator::arm
