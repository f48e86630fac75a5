// SPDX-License-Identifier: MIT
#include "robot/simulator/host/script_arm.h"

#include "robot/kinematics/arm_kinematics.h"
#include "robot/rtde/fields.h"
#include "robot/simulator/plant/plant.h"
#include "robot/simulator/plant/rtde_values.h"

namespace tiller::simulator {

const arm::ArmState& ScriptArm::state() const {
    return plant_.arm().state();
}
const DhParameters& ScriptArm::dh() const {
    return plant_.arm().model().dh;
}

// ---- measured values ------------------------------------------------------------------------------------

JointPositions ScriptArm::jointPositions(urscript::Source source) const {
    return source == urscript::Source::Actual ? state().actualQ : state().targetQ;
}
JointVelocities ScriptArm::jointVelocities(urscript::Source source) const {
    return source == urscript::Source::Actual ? state().actualQd : state().targetQd;
}
JointAccelerations ScriptArm::jointAccelerations(urscript::Source) const {
    return state().targetQdd;  // the arm has no acceleration measurement
}

Result<JointPositions> ScriptArm::jointPositionsHistory(int steps) const {
    if (const auto q = plant_.arm().jointHistory(steps)) {
        return *q;
    }
    return urscript::scriptError(
        "get_actual_joint_positions_history: the history is shorter than this number of steps");
}

JointTorques ScriptArm::externalJointTorques() const {
    return state().externalTorque;
}
Pose ScriptArm::tcpPose(urscript::Source source) const {
    return source == urscript::Source::Actual ? state().actualTcpPose : state().targetTcpPose;
}
Twist ScriptArm::tcpSpeed(urscript::Source source) const {
    return source == urscript::Source::Actual ? state().actualTcpSpeed : state().targetTcpSpeed;
}
Pose ScriptArm::flangePose() const {
    return state().actualFlangePose;
}
Pose ScriptArm::targetWaypoint() const {
    return plant_.arm().motion().targetWaypoint();
}
Wrench ScriptArm::tcpForce() const {
    return plant_.telemetry().tcpForce;
}
bool ScriptArm::isSteady() const {
    return state().isSteady();
}
int ScriptArm::toolContact(const Eigen::Vector3d& direction) const {
    return plant_.arm().toolContact(direction);
}
double ScriptArm::jointTemperature(int joint) const {
    return state().jointTemperature[joint];
}
double ScriptArm::controllerTemperature() const {
    return 24.0;  // as reported in MasterboardData
}
double ScriptArm::toolTemperature() const {
    return state().toolTemperature;
}
double ScriptArm::toolCurrent() const {
    return state().toolCurrent;
}
Eigen::Vector3d ScriptArm::toolAccelerometer() const {
    return state().toolAccelerometer;
}

Result<urscript::StateHost::FieldValue> ScriptArm::rtdeValue(std::string_view name) const {
    const rtde::Field* field = rtde::findOutput(name);
    const auto source = field == nullptr ? std::nullopt : fieldSource(*field);
    if (!source) {
        return urscript::scriptError("unknown RTDE output: " + std::string(name));
    }
    std::array<double, 6> values{};
    source->read(plant_.telemetry(), source->number, values.data());
    const auto end = values.begin() + static_cast<std::ptrdiff_t>(source->components);
    switch (field->type) {
        case rtde::DataType::Bool:
            return FieldValue(values[0] != 0);
        case rtde::DataType::Double:
            return FieldValue(values[0]);
        case rtde::DataType::Vector3D:
        case rtde::DataType::Vector6D:
            return FieldValue(std::vector<double>(values.begin(), end));
        case rtde::DataType::Vector6Int32:
        case rtde::DataType::Vector6UInt32: {
            std::vector<std::int32_t> numbers;
            for (auto it = values.begin(); it != end; ++it) {
                numbers.push_back(static_cast<std::int32_t>(*it));
            }
            return FieldValue(std::move(numbers));
        }
        default:
            return FieldValue(static_cast<std::int32_t>(static_cast<std::int64_t>(values[0])));
    }
}

// ---- kinematics -----------------------------------------------------------------------------------------

Pose ScriptArm::forwardKinematics(const std::optional<JointPositions>& q,
                                  const std::optional<Pose>& tcp) const {
    return kinematics::forwardTcp(dh(), q.value_or(state().actualQ), tcp.value_or(plant_.arm().tcp()));
}

std::optional<JointPositions> ScriptArm::inverseKinematics(const InverseRequest& request) const {
    return kinematics::inverseNearest(dh(), request.pose, request.tcp.value_or(plant_.arm().tcp()),
                                      request.qNear.value_or(state().actualQ));
}

bool ScriptArm::isWithinSafetyLimits(const urscript::MoveTarget& target) const {
    if (const auto* q = std::get_if<JointPositions>(&target)) {
        return q->values.cwiseAbs().maxCoeff() <= kJointPositionLimit;
    }
    InverseRequest request;
    request.pose = std::get<Pose>(target);
    return inverseKinematics(request).has_value();
}

Result<Matrix6> ScriptArm::jacobian(const std::optional<JointPositions>& q,
                                    const std::optional<Pose>& tcp) const {
    return kinematics::jacobian(dh(), q.value_or(state().actualQ), tcp.value_or(plant_.arm().tcp()));
}

Result<Matrix6> ScriptArm::jacobianTimeDerivative(const std::optional<JointPositions>& q,
                                                  const std::optional<JointVelocities>& qd,
                                                  const std::optional<Pose>& tcp) const {
    constexpr double kStep = 1e-5;  // step of the central differences [s]; accurate to 1e-9
    const Vector6 at = q.value_or(state().actualQ).values;
    const Vector6 way = kStep * qd.value_or(state().actualQd).values;
    const Pose tool = tcp.value_or(plant_.arm().tcp());
    return Matrix6((kinematics::jacobian(dh(), JointPositions(at + way), tool) -
                    kinematics::jacobian(dh(), JointPositions(at - way), tool)) /
                   (2 * kStep));
}

Result<Matrix6> ScriptArm::massMatrix(const std::optional<JointPositions>& q, bool includeRotors) const {
    return plant_.arm().massMatrix(q.value_or(state().actualQ), includeRotors);
}

Result<JointTorques> ScriptArm::coriolisTorques(const std::optional<JointPositions>& q,
                                                const std::optional<JointVelocities>& qd) const {
    return plant_.arm().coriolisTorques(q.value_or(state().actualQ), qd.value_or(state().actualQd));
}

// ---- set-up ---------------------------------------------------------------------------------------------

Pose ScriptArm::tcpOffset() const {
    return plant_.arm().tcp();
}

Result<void> ScriptArm::setTcpOffset(const Pose& flangeToTcp, std::string_view) {
    plant_.arm().setTcp(flangeToTcp);
    return {};
}

urscript::Payload ScriptArm::payload() const {
    const arm::Payload& now = plant_.arm().payload();
    return {now.mass, now.centreOfGravity, now.inertia};
}

Result<void> ScriptArm::setPayload(const urscript::Payload& payload, double transition, bool zeroSensor) {
    plant_.arm().setPayload({payload.mass, payload.centreOfGravity, payload.inertia}, transition);
    if (zeroSensor) {
        plant_.arm().zeroForceSensor();
    }
    return {};
}

Eigen::Vector3d ScriptArm::gravity() const {
    return plant_.arm().gravity();
}

Result<void> ScriptArm::setGravity(const Eigen::Vector3d& gravity) {
    plant_.arm().setGravity(gravity);
    return {};
}

// The value is only stored, because the simulated base does not move.
Result<void> ScriptArm::setBaseAcceleration(const Eigen::Vector3d& acceleration) {
    baseAcceleration_ = acceleration;
    return {};
}

void ScriptArm::zeroForceSensor() {
    plant_.arm().zeroForceSensor();
}

Result<void> ScriptArm::setExternalForceSensor(const urscript::ExternalForceSensor& sensor) {
    plant_.setExternalSensorInUse(sensor.enabled && sensor.viaRtde);
    // Loss of the sensor data pauses the program unless the program has selected another action.
    constexpr double kMinFrequency = 10.0;
    const auto action =
        sensor.enabled && sensor.viaRtde ? urscript::WatchdogAction::Pause : urscript::WatchdogAction::Ignore;
    return plant_.watchdogs().set("external_force_torque", kMinFrequency, action);
}

}  // namespace tiller::simulator
