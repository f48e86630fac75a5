// SPDX-License-Identifier: MIT
#pragma once

// What scripts reach of the simulated robot: the interpreter's Host over the plant. One object serves the
// main program and secondary ones.

#include <array>
#include <bitset>
#include <map>
#include <optional>
#include <string>

#include "robot/simulator/arm/arm.h"
#include "robot/simulator/box/encoders.h"
#include "robot/simulator/box/terminal_rules.h"
#include "robot/simulator/equipment/modbus_device.h"
#include "robot/simulator/host/script_sockets.h"
#include "robot/simulator/urscript/host.h"

namespace tiller::simulator {

class Plant;

class ScriptHost final : public urscript::Host {
public:
    explicit ScriptHost(Plant& plant);
    ~ScriptHost() override;

    /// Once a control period, before the scripts run.
    void beginPeriod();
    /// Once a control period, after the scripts: counts the encoders and moves what they carry.
    void stepConveyors();
    const Encoders& encoders() const { return encoders_; }
    /// A person answers what a program asks for, the oldest question first. False when nothing is asked, or
    /// something of another type.
    bool answerRequest(const urscript::RequestAnswer& answer);
    /// What kind of value the oldest question asks for; nothing when none is open.
    std::optional<urscript::RequestKind> asked() const;

    // MotionHost
    Result<void> startMotion(urscript::ThreadId thread, const urscript::MotionCommand& command) override;
    Result<bool> motionFinished(urscript::ThreadId thread) override;
    void motionAbandoned(urscript::ThreadId thread) override;
    Result<void> forceMode(const urscript::ForceMode& mode) override;
    void endForceMode() override;
    Result<void> setForceModeDamping(double damping) override;
    double forceModeDamping() const override;
    Result<void> setForceModeGainScaling(double scaling) override;
    double forceModeGainScaling() const override;
    Result<void> freedrive(const urscript::Freedrive& mode) override;
    void endFreedrive() override;
    int freedriveStatus() const override;
    Result<void> setJointPositions(const JointPositions& q) override;
    Result<void> resetRevolutionCounter(const JointPositions& qNear) override;
    Result<void> screwDriving(double force, double speedLimit) override;
    Result<void> endScrewDriving() override;

    // SuperpositionHost
    Result<void> enablePathOffset() override;
    Result<void> setPathOffset(const Pose& offset, int type) override;
    Result<Pose> pathOffset(int type) const override;
    Result<void> setPathOffsetFilter(double alpha) override;
    Result<void> setPathOffsetLimits(double translation, double rotation) override;
    Result<void> trackConveyorLinear(const Pose& direction, double ticksPerMeter, int encoder) override;
    Result<void> trackConveyorCircular(const Pose& center, double ticksPerRevolution, bool rotateTool,
                                       int encoder) override;
    Result<double> encoderTicks(int encoder) const override;
    Result<void> setEncoderTicks(int encoder, double ticks) override;
    Result<void> enableEncoder(int encoder, int decoder, int inputA, int inputB) override;
    Result<void> setEncoderRange(int encoder, int rangeId) override;

    // StateHost
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

    // KinematicsHost
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

    // SetupHost
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

    // RegisterHost
    bool boolRegister(urscript::RegisterSide side, int address) const override;
    std::int32_t intRegister(urscript::RegisterSide side, int address) const override;
    double floatRegister(urscript::RegisterSide side, int address) const override;
    void setBoolOutput(int address, bool value) override;
    void setIntOutput(int address, std::int32_t value) override;
    void setFloatOutput(int address, double value) override;
    bool flag(int number) const override;
    void setFlag(int number, bool value) override;
    bool portBit(int address) const override;
    void setPortBit(int address, bool value) override;
    std::int16_t portRegister(int address) const override;
    void setPortRegister(int address, std::int16_t value) override;

    // IoHost
    bool digitalInput(urscript::DigitalBank bank, int n) const override;
    bool digitalOutput(urscript::DigitalBank bank, int n) const override;
    void setDigitalOutput(urscript::DigitalBank bank, int n, bool value) override;
    double analog(urscript::AnalogPort port, int n) const override;
    void setAnalogOutput(int n, double level) override;
    void setAnalogDomain(urscript::AnalogPort port, int n, int domain) override;
    void setToolVoltage(int volts) override;
    void setToolCommunication(const urscript::ToolCommunication& settings) override;
    void setToolOutputMode(int mode) override;
    void setToolDigitalOutputMode(int n, int mode) override;
    void setRunState(urscript::RuledOutput output, int number, int state) override;
    void setFreedriveInput(urscript::RuledInput input, int number, bool freedrive) override;
    void resetInputActions() override;

    // SocketHost
    bool openSocket(std::string_view name, std::string_view address, int port) override;
    ScriptSockets& sockets() { return sockets_; }
    State socketState(std::string_view name) const override;
    void closeSocket(std::string_view name) override;
    bool sendSocket(std::string_view name, std::string_view bytes) override;
    std::string_view receivedBytes(std::string_view name) const override;
    void consumeBytes(std::string_view name, std::size_t count) override;

    // MessageHost
    void textMessage(std::string_view text) override;
    void programLabel(int number, std::string_view text) override;
    int showPopup(const urscript::Popup& popup) override;
    bool popupOpen(int id) const override;
    Result<int> requestValue(urscript::RequestKind kind, std::string_view text) override;
    std::optional<urscript::RequestAnswer> requestedValue(int id) override;

    // ModbusHost
    Result<void> addModbusSignal(const urscript::ModbusSignal& signal) override;
    Result<void> deleteModbusSignal(std::string_view name) override;
    Result<urscript::ModbusStatus> modbusStatus(std::string_view name) const override;
    Result<std::int32_t> modbusError(std::string_view name,
                                     urscript::ModbusErrorSource source) const override;
    Result<double> modbusInvalidTime(std::string_view name) const override;
    Result<void> setModbusOutput(std::string_view name, bool digital,
                                 std::span<const std::int32_t> values) override;
    Result<void> setModbusFrequency(std::string_view name, double hertz) override;
    Result<void> setModbusWatchdog(std::string_view name, double seconds) override;
    Result<void> setModbusFreedrive(std::string_view name, bool freedrive) override;
    Result<void> setModbusRunState(std::string_view name, int state) override;
    Result<void> sendModbusCommand(int function, std::span<const std::uint8_t> data) override;
    bool isModbusConnected() const override;
    ModbusDevice& modbus() { return modbus_; }

    // ProgramHost
    double stepTime() const override;
    std::int64_t controllerTimeNs() const override;
    std::int64_t systemTimeNs() const override;
    Result<void> protectiveStop() override;
    void powerDown() override;
    Result<void> setWatchdog(std::string_view field, double minFrequency,
                             urscript::WatchdogAction action) override;
    void programEnded(urscript::ProgramKind kind) override;

private:
    const arm::ArmState& state() const;
    const DhParameters& dh() const;
    struct Motion {
        arm::MotionId id = 0;
        bool settles = false;  ///< a stop, which waits until the arm has come to rest
        double settled = 0;    ///< [s] since it stands
    };
    bool comesToRest(Motion& motion) const;
    Result<void> begunForces(const arm::ForceModeParameters& parameters);

    Plant& plant_;
    std::map<urscript::ThreadId, Motion> motions_;  ///< unfinished, by thread
    ScriptSockets sockets_;
    Encoders encoders_;
    int trackedEncoder_ = 0;  ///< which of them moves the conveyor that is tracked
    TerminalRules rules_;
    ModbusDevice modbus_;
    bool wasRunning_ = false;
    bool freedriveWanted_ = false;
    Eigen::Vector3d baseAcceleration_ = Eigen::Vector3d::Zero();
    std::bitset<kPorts> portBits_;
    std::array<std::int16_t, kPorts> portRegisters_{};
    struct Request {
        urscript::RequestKind kind;
        std::optional<urscript::RequestAnswer> answer;
    };
    std::map<int, Request> requests_;  ///< by id
    int lastRequest_ = 0;
};

}  // namespace tiller::simulator
