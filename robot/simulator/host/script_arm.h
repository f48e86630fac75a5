// SPDX-License-Identifier: MIT
#pragma once

// Functions for programs that read, calculate and configure properties of the arm.

#include <optional>

#include "robot/simulator/arm/arm.h"
#include "robot/simulator/urscript/host.h"

namespace tiller::simulator {

class Plant;

/// Threads  the simulator thread
class ScriptArm : public virtual urscript::StateHost,
                  public virtual urscript::KinematicsHost,
                  public virtual urscript::SetupHost {
public:
    explicit ScriptArm(Plant& plant) : plant_(plant) {}

    JointPositions jointPositions(urscript::Source source) const override;
    JointVelocities jointVelocities(urscript::Source source) const override;
    JointAccelerations jointAccelerations(urscript::Source source) const override;
    Result<JointPositions> jointPositionsHistory(int steps) const override;
    JointTorques externalJointTorques() const override;
    Pose tcpPose(urscript::Source source) const override;
    Twist tcpSpeed(urscript::Source source) const override;
    Pose flangePose() const override;
    Pose targetWaypoint() const override;
    Wrench tcpForce() const override;
    bool isSteady() const override;
    int toolContact(const Eigen::Vector3d& direction) const override;
    double jointTemperature(int joint) const override;
    double controllerTemperature() const override;
    double toolTemperature() const override;
    double toolCurrent() const override;
    Eigen::Vector3d toolAccelerometer() const override;
    Result<FieldValue> rtdeValue(std::string_view field) const override;

    Pose forwardKinematics(const std::optional<JointPositions>& q,
                           const std::optional<Pose>& tcp) const override;
    std::optional<JointPositions> inverseKinematics(const InverseRequest& request) const override;
    bool isWithinSafetyLimits(const urscript::MoveTarget& target) const override;
    Result<Matrix6> jacobian(const std::optional<JointPositions>& q,
                             const std::optional<Pose>& tcp) const override;
    Result<Matrix6> jacobianTimeDerivative(const std::optional<JointPositions>& q,
                                           const std::optional<JointVelocities>& qd,
                                           const std::optional<Pose>& tcp) const override;
    Result<Matrix6> massMatrix(const std::optional<JointPositions>& q, bool includeRotors) const override;
    Result<JointTorques> coriolisTorques(const std::optional<JointPositions>& q,
                                         const std::optional<JointVelocities>& qd) const override;

    Pose tcpOffset() const override;
    Result<void> setTcpOffset(const Pose& flangeToTcp, std::string_view name) override;
    urscript::Payload payload() const override;
    Result<void> setPayload(const urscript::Payload& payload, double transition, bool zeroSensor) override;
    Eigen::Vector3d gravity() const override;
    Result<void> setGravity(const Eigen::Vector3d& gravity) override;
    Eigen::Vector3d baseAcceleration() const override { return baseAcceleration_; }
    Result<void> setBaseAcceleration(const Eigen::Vector3d& acceleration) override;
    void zeroForceSensor() override;
    Result<void> setExternalForceSensor(const urscript::ExternalForceSensor& sensor) override;

private:
    const arm::ArmState& state() const;
    const DhParameters& dh() const;

    Eigen::Vector3d baseAcceleration_ = Eigen::Vector3d::Zero();
    Plant& plant_;
};

}  // namespace tiller::simulator
