// SPDX-License-Identifier: MIT
#pragma once

// The interfaces of a running script to the robot. The interpreter owns threads, variables and time slices.
// It accesses everything outside of the program (arm, registers, I/O, sockets, messages) through these
// interfaces, which a simulated controller implements with its arm.
//
// Conventions for all interfaces: SI units; base frame unless stated otherwise; called only from the thread
// that calls Interpreter::runFrame(); never blocking. Operations that take time are started by one call and
// polled by another, once per frame. An Error ends the program with a runtime exception. The text of the
// exception is the controllerMessage of the error or, if that is empty, the context. Methods with a default
// implementation are for optional equipment.

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "robot/core/joints.h"
#include "robot/core/result.h"
#include "robot/core/spatial.h"
#include "robot/simulator/urscript/payload.h"
#include "robot/simulator/urscript/world_model.h"

namespace tiller::simulator::urscript {

/// Identifies a script thread within one program: 0 is the main body. `run` returns 1, 2, 3 ...
using ThreadId = std::int32_t;

/// Error for functions that a host does not support.
Error notSimulated(std::string_view what);
/// Error whose text becomes the text of the runtime exception.
Error scriptError(std::string text);

// ---- motion commands

/// Target of a move: joint positions [rad] or a TCP pose in the base frame. The host converts the target:
/// forward kinematics for movel, inverse kinematics near the current joint positions for movej.
using MoveTarget = std::variant<JointPositions, Pose>;

/// movej, movel, movep, movec, optimovej, optimovel.
struct Move {
    enum class Kind { J, L, P, C, OptimoveJ, OptimoveL };
    Kind kind = Kind::J;
    MoveTarget target;
    std::optional<MoveTarget> via;  ///< movec only; only the position of a pose is used
    double acceleration = 0;  ///< [rad/s2] leading axis (J), [m/s2] (L, P, C), fraction (0,1] (Optimove)
    double velocity = 0;      ///< [rad/s], [m/s], fraction (0,1]
    double duration = 0;      ///< [s]; 0: not given; overrides acceleration and velocity
    double blend = 0;         ///< [m]
    int orientationMode = 0;  ///< movec: 0 unconstrained, 1 fixed relative to the arc
};

struct ServoJ {
    JointPositions q;
    double duration = 0.002;  ///< [s]
    double lookahead = 0.1;   ///< [s]
    double gain = 300;
};

struct ServoC {
    MoveTarget target;
    double acceleration = 1.2, velocity = 0.25, blend = 0;
};

struct SpeedJ {
    JointVelocities qd;
    double acceleration = 0;         ///< [rad/s2], may be 0, very large or infinite
    std::optional<double> duration;  ///< [s]; empty: until the speed is reached, at least one frame
};

struct SpeedL {
    Twist xd;
    double acceleration = 0;          ///< [m/s2]
    double rotationAcceleration = 0;  ///< [rad/s2]
    std::optional<double> duration;
};

struct StopJ {
    double deceleration = 0;  ///< [rad/s2] leading axis
};

struct StopL {
    double deceleration = 0, rotationDeceleration = 0;  ///< [m/s2], [rad/s2]
};

struct DirectTorque {
    JointTorques torque;               ///< torque without gravity
    bool frictionCompensation = true;  ///< friction_comp, for the form with two arguments
    std::optional<Vector6> viscous;    ///< scales 0..1, for the form with three arguments
    std::optional<Vector6> coulomb;
};

/// path_offset_disable, stop_conveyor_tracking: ends the superposition. The command is complete at
/// standstill.
struct StopSuperposition {
    double deceleration = 20;  ///< [rad/s2]
};

using MotionCommand =
    std::variant<Move, ServoJ, ServoC, SpeedJ, SpeedL, StopJ, StopL, DirectTorque, StopSuperposition>;

struct ForceMode {
    Pose taskFrame;
    std::array<bool, 6> compliant{};
    Wrench wrench;  ///< wrench in the task frame
    int type = 2;
    Vector6 limits = Vector6::Zero();
};

struct Freedrive {
    std::array<bool, 6> freeAxes{true, true, true, true, true, true};
    Pose feature;              ///< feature relative to the base if `tool` is false
    bool tool = false;         ///< the feature is the tool
    bool checkPayload = true;  ///< false for freedrive_mode_no_incorrect_payload_check()
};

/// Starts motions and reports their completion. The interpreter ensures that only one thread at a time has an
/// unfinished command.
class MotionHost {
public:
    virtual ~MotionHost() = default;

    /// Starts `command` for `thread`. An earlier command may still move the arm, even if its thread has been
    /// killed. An error ends the program, e.g. no inverse solution, or target outside of the joint range.
    virtual Result<void> startMotion(ThreadId thread, const MotionCommand& command) = 0;
    /// Polled at the beginning of each following frame. Returns true when the calling thread may continue: at
    /// standstill at the target, in the blend zone, after the duration (in program time, which is longer if
    /// the speed slider is below 100 %), or at standstill after a stop.
    virtual Result<bool> motionFinished(ThreadId thread) = 0;
    /// Called if the thread was killed or has ended with an unfinished command. The host continues the motion
    /// for 20 ms, so that another thread can issue a command, and then decelerates the arm.
    virtual void motionAbandoned(ThreadId thread) = 0;

    virtual Result<void> forceMode(const ForceMode& mode) = 0;  ///< may be called every frame
    virtual void endForceMode() = 0;
    virtual Result<void> setForceModeDamping(double damping) = 0;
    virtual double forceModeDamping() const = 0;
    virtual Result<void> setForceModeGainScaling(double scaling) = 0;
    virtual double forceModeGainScaling() const = 0;

    virtual Result<void> freedrive(const Freedrive& mode) = 0;  ///< also for teach_mode(); may be repeated
    virtual void endFreedrive() = 0;
    virtual int freedriveStatus() const { return 0; }

    virtual Result<void> screwDriving(double force, double speedLimit);
    virtual Result<void> endScrewDriving();
    virtual Result<void> setJointPositions(const JointPositions& q);  ///< set_pos
    virtual Result<void> resetRevolutionCounter(const JointPositions& qNear);
};

/// Offsets superposed on a path: path_offset_* and conveyor tracking. Optional.
class SuperpositionHost {
public:
    virtual ~SuperpositionHost() = default;
    virtual Result<void> enablePathOffset();
    virtual Result<void> setPathOffset(const Pose& offset, int type);
    virtual Result<Pose> pathOffset(int type) const;
    virtual Result<void> setPathOffsetFilter(double alpha);
    virtual Result<void> setPathOffsetLimits(double translation, double rotation);
    virtual Result<void> trackConveyorLinear(const Pose& direction, double ticksPerMeter, int encoder);
    virtual Result<void> trackConveyorCircular(const Pose& center, double ticksPerRevolution, bool rotateTool,
                                               int encoder);
    virtual Result<double> encoderTicks(int encoder) const;
    virtual Result<void> setEncoderTicks(int encoder, double ticks);
    virtual Result<void> enableEncoder(int encoder, int decoder, int inputA, int inputB);
    virtual Result<void> setEncoderRange(int encoder, int rangeId);
};

// ---- robot state

enum class Source { Actual, Target };

/// Current values of the arm, constant within a frame.
class StateHost {
public:
    virtual ~StateHost() = default;

    virtual JointPositions jointPositions(Source) const = 0;
    virtual JointVelocities jointVelocities(Source) const = 0;
    virtual JointAccelerations jointAccelerations(Source) const = 0;
    /// Joint positions `steps` control periods ago; 0 = now. Returns an error beyond the buffer of several
    /// seconds.
    virtual Result<JointPositions> jointPositionsHistory(int steps) const = 0;
    virtual JointTorques externalJointTorques() const = 0;  ///< get_joint_torques

    virtual Pose tcpPose(Source) const = 0;
    virtual Twist tcpSpeed(Source) const = 0;
    virtual Pose flangePose() const = 0;      ///< actual pose, without the TCP offset
    virtual Pose targetWaypoint() const = 0;  ///< target of the active move, or the target TCP pose
    virtual Wrench tcpForce() const = 0;
    virtual bool isSteady() const = 0;
    /// Number of control periods back to the last period before a contact along `direction` (zero: any
    /// direction); 0: no contact.
    virtual int toolContact(const Eigen::Vector3d& direction) const = 0;

    virtual double jointTemperature(int joint) const = 0;   ///< [deg C], joint 0..5
    virtual double controllerTemperature() const = 0;       ///< [deg C]
    virtual double toolTemperature() const = 0;             ///< [deg C]
    virtual double toolCurrent() const = 0;                 ///< [A]
    virtual Eigen::Vector3d toolAccelerometer() const = 0;  ///< [m/s2]

    using FieldValue =
        std::variant<bool, std::int32_t, double, std::vector<double>, std::vector<std::int32_t>>;
    /// Value of an RTDE output field, delayed by one control period.
    virtual Result<FieldValue> rtdeValue(std::string_view field) const;
};

/// Kinematics and dynamics of the calibrated arm. Defaults: active TCP for an empty `tcp`, current joint
/// positions for an empty `q`.
class KinematicsHost {
public:
    virtual ~KinematicsHost() = default;

    virtual Pose forwardKinematics(const std::optional<JointPositions>& q,
                                   const std::optional<Pose>& tcp) const = 0;
    struct InverseRequest {
        Pose pose;
        std::optional<JointPositions> qNear;  ///< empty: current joint positions
        double maxPositionError = 1e-10;      ///< [m]
        double maxOrientationError = 1e-10;   ///< [rad]
        std::optional<Pose> tcp;
    };
    /// Returns the solution nearest to qNear; empty if the pose is unreachable.
    virtual std::optional<JointPositions> inverseKinematics(const InverseRequest& request) const = 0;
    virtual bool isWithinSafetyLimits(const MoveTarget& target) const = 0;

    virtual Result<Matrix6> jacobian(const std::optional<JointPositions>& q,
                                     const std::optional<Pose>& tcp) const;
    virtual Result<Matrix6> jacobianTimeDerivative(const std::optional<JointPositions>& q,
                                                   const std::optional<JointVelocities>& qd,
                                                   const std::optional<Pose>& tcp) const;
    virtual Result<Matrix6> massMatrix(const std::optional<JointPositions>& q, bool includeRotors) const;
    virtual Result<JointTorques> coriolisTorques(const std::optional<JointPositions>& q,
                                                 const std::optional<JointVelocities>& qd) const;
};

struct ExternalForceSensor {
    bool enabled = false;
    double mass = 0;                                            ///< [kg]
    Eigen::Vector3d measuringOffset = Eigen::Vector3d::Zero();  ///< [m] from the flange
    Eigen::Vector3d centreOfGravity = Eigen::Vector3d::Zero();  ///< [m] from the flange
    bool viaRtde =
        true;  ///< ft_rtde_input_enable; false: enable_external_ft_sensor (torques of opposite sign)
};

/// Mounting of the arm and equipment on the arm. The settings are kept between programs.
class SetupHost {
public:
    virtual ~SetupHost() = default;
    virtual Pose tcpOffset() const = 0;
    virtual Result<void> setTcpOffset(const Pose& flangeToTcp, std::string_view name) = 0;
    virtual Payload payload() const = 0;
    /// Sets the payload. `transition`: time to change linearly from the old payload [s]. `zeroSensor`: for
    /// the older functions, which also zero the force/torque reading.
    virtual Result<void> setPayload(const Payload& payload, double transition, bool zeroSensor) = 0;
    virtual Eigen::Vector3d gravity() const = 0;  ///< [m/s2]; 0 0 9.82 when upright
    virtual Result<void> setGravity(const Eigen::Vector3d& gravity) = 0;
    virtual Eigen::Vector3d baseAcceleration() const { return Eigen::Vector3d::Zero(); }
    virtual Result<void> setBaseAcceleration(const Eigen::Vector3d& acceleration);
    virtual void zeroForceSensor() = 0;
    virtual Result<void> setExternalForceSensor(const ExternalForceSensor& sensor) = 0;
    /// Settings that a simulation may ignore, identified by builtin name, with their numbers, e.g.
    /// "position_deviation_warning", "set_baselight_solid", "motion_version_set". The default implementation
    /// accepts them without effect.
    virtual Result<void> applySetting(std::string_view builtin, std::span<const double> values);
};

// ---- registers and I/O

enum class RegisterSide { Input, Output };

/// General purpose registers. The caller checks the addresses: bool 0..127, int and float 0..47.
class RegisterHost {
public:
    virtual ~RegisterHost() = default;
    virtual bool boolRegister(RegisterSide, int address) const = 0;
    virtual std::int32_t intRegister(RegisterSide, int address) const = 0;
    virtual double floatRegister(RegisterSide, int address) const = 0;
    virtual void setBoolOutput(int address, bool value) = 0;
    virtual void setIntOutput(int address, std::int32_t value) = 0;
    virtual void setFloatOutput(int address, double value) = 0;
    virtual bool flag(int number) const = 0;  ///< 0..32, kept between programs
    virtual void setFlag(int number, bool value) = 0;
    /// The registers of the controller's own Modbus server, addresses 0..kPorts - 1.
    static constexpr int kPorts = 512;
    virtual bool portBit(int address) const;
    virtual void setPortBit(int address, bool value);
    virtual std::int16_t portRegister(int address) const;
    virtual void setPortRegister(int address, std::int16_t value);
};

enum class DigitalBank { Standard, Configurable, Tool };             ///< pin numbers: 0..7, 0..7, 0..1
enum class AnalogPort { StandardInput, StandardOutput, ToolInput };  ///< pin numbers: 0..1 for each port

struct ToolCommunication {
    bool enabled = false;
    int baudRate = 115200, parity = 0, stopBits = 1;
    double rxIdleChars = 1.5, txIdleChars = 3.5;
};

/// Outputs that can follow the program state, and inputs that can act as a freedrive button.
enum class RuledOutput { Standard, Configurable, Tool, Analog, Register };
enum class RuledInput { Standard, Configurable, Tool, Register };

/// Pins. The caller checks the numbers.
class IoHost {
public:
    virtual ~IoHost() = default;
    virtual bool digitalInput(DigitalBank, int n) const = 0;
    virtual bool digitalOutput(DigitalBank, int n) const = 0;
    virtual void setDigitalOutput(DigitalBank, int n, bool value) = 0;
    virtual double analog(AnalogPort, int n) const = 0;               ///< [A] or [V], depending on the domain
    virtual void setAnalogOutput(int n, double level) = 0;            ///< 0..1 of the range
    virtual void setAnalogDomain(AnalogPort, int n, int domain) = 0;  ///< 0: 4-20 mA, 1: 0-10 V
    virtual void setToolVoltage(int volts) = 0;                       ///< 0, 12 or 24
    virtual void setToolCommunication(const ToolCommunication& settings) = 0;
    virtual void setToolOutputMode(int mode) = 0;                ///< 0 digital outputs, 1 dual-pin power
    virtual void setToolDigitalOutputMode(int n, int mode) = 0;  ///< 1 NPN, 2 PNP, 3 push-pull
    /// state  0 keep, 1 low when no program runs, 2 high when no program runs, 3 high only while a program
    /// runs
    virtual void setRunState(RuledOutput, int number, int state) = 0;
    virtual void setFreedriveInput(RuledInput, int number, bool freedrive) = 0;
    virtual void resetInputActions() = 0;
};

// ---- sockets

/// TCP client sockets of the program, identified by their names in the script. All sockets are closed when
/// the program ends.
class SocketHost {
public:
    virtual ~SocketHost() = default;
    enum class State { Closed, Connecting, Open };

    /// Closes an open socket with this name and starts to connect. Returns false if the attempt fails at
    /// once.
    virtual bool openSocket(std::string_view name, std::string_view address, int port) = 0;
    /// Open until either side closes the connection. Bytes received before that can still be read.
    virtual State socketState(std::string_view name) const = 0;
    virtual void closeSocket(std::string_view name) = 0;  ///< unknown names are ignored
    /// Sends all bytes. Returns false if the socket is not open.
    virtual bool sendSocket(std::string_view name, std::string_view bytes) = 0;
    /// Bytes received but not yet consumed. Valid until the next call of this interface.
    virtual std::string_view receivedBytes(std::string_view name) const = 0;
    virtual void consumeBytes(std::string_view name, std::size_t count) = 0;
};

// ---- messages and program

struct Popup {
    std::string text, title;
    bool warning = false, error = false, blocking = false;
};

/// Type of the value that a program requests from a primary client.
enum class RequestedType { Boolean, Integer, Float, String };
using RequestAnswer = std::variant<bool, std::int32_t, double, std::string>;

/// Messages to operators and primary clients.
class MessageHost {
public:
    virtual ~MessageHost() = default;
    virtual void textMessage(std::string_view text) = 0;               ///< primary type 0
    virtual void programLabel(int number, std::string_view text) = 0;  ///< primary type 1, `$ 1 "name"`
    virtual int showPopup(const Popup& popup) = 0;                     ///< returns an ID, primary type 2
    virtual bool popupOpen(int id) const = 0;  ///< polled once per frame by blocking popups
    virtual Result<int> requestValue(RequestedType kind, std::string_view text);  ///< an ID, primary type 9
    virtual std::optional<RequestAnswer> requestedValue(int id);
};

/// A signal of a Modbus device. The controller periodically reads it, or writes and reads it.
struct ModbusSignal {
    enum class Kind { Input, Coil, InputRegister, Register };
    std::string name;
    std::string device;  ///< IP address
    Kind kind = Kind::Input;
    int address = 0;
    int count = 1;      ///< number of inputs, coils or registers
    bool list = false;  ///< the status is a list of `count` values
    int writeAddress = 0;
    int writeCount = 1;

    bool isDigital() const { return kind == Kind::Input || kind == Kind::Coil; }
    bool isOutput() const { return kind == Kind::Coil || kind == Kind::Register; }
};
struct ModbusStatus {
    std::vector<std::int32_t> values;  ///< 0 or 1, or 0..65535
    bool digital = false;
    bool list = false;
};
enum class ModbusErrorSource { Combined, Device, Connection };

/// The controller as client of Modbus devices. Optional. Signals are kept when the program ends. All
/// functions return an error for an unknown signal name.
class ModbusHost {
public:
    virtual ~ModbusHost() = default;
    virtual Result<void> addModbusSignal(const ModbusSignal& signal);  ///< replaces a signal of the same name
    virtual Result<void> deleteModbusSignal(std::string_view name);
    /// Returns the last values read. Error: no values have been read within the signal's watchdog time.
    virtual Result<ModbusStatus> modbusStatus(std::string_view name) const;
    virtual Result<std::int32_t> modbusError(std::string_view name, ModbusErrorSource source) const;
    virtual Result<double> modbusInvalidTime(std::string_view name) const;  ///< [s], 0: valid
    /// Sets an output. If `values` has fewer elements than the output, the remaining elements do not change.
    /// Error: the signal is not an output, or has a different type.
    virtual Result<void> setModbusOutput(std::string_view name, bool digital,
                                         std::span<const std::int32_t> values);
    virtual Result<void> setModbusFrequency(std::string_view name,
                                            double hertz);  ///< 0 or less: not cyclic
    virtual Result<void> setModbusWatchdog(std::string_view name, double seconds);
    virtual Result<void> setModbusFreedrive(std::string_view name, bool freedrive);
    virtual Result<void> setModbusRunState(std::string_view name, int state);  ///< as IoHost::setRunState
    virtual Result<void> sendModbusCommand(int function, std::span<const std::uint8_t> data);
    virtual bool isModbusConnected() const { return true; }
};

enum class WatchdogAction { Pause, Stop, Ignore };
enum class ProgramKind { Main, Secondary };

/// The controller that runs the program.
class ProgramHost {
public:
    virtual ~ProgramHost() = default;
    virtual double stepTime() const = 0;                ///< [s] 0.002 or 0.008; length of one frame
    virtual std::int64_t controllerTimeNs() const = 0;  ///< monotonic, since the start of the controller
    virtual std::int64_t systemTimeNs() const = 0;      ///< UTC since 1970
    /// Notifies the safety system at once. The program continues to the end of its frame, so the host must
    /// also call Interpreter::pause().
    virtual Result<void> protectiveStop() = 0;
    virtual void powerDown() = 0;
    virtual Result<void> setWatchdog(std::string_view field, double minFrequency, WatchdogAction action) = 0;
    /// Called exactly once for each interpreter that has run, also after errors and stop(). Main program:
    /// decelerates, ends force mode and freedrive, removes watchdogs, closes sockets. Secondary program: no
    /// effect.
    virtual void programEnded(ProgramKind kind) = 0;
};

/// The named frames, which are preserved between programs.
class WorldHost {
public:
    virtual ~WorldHost() = default;
    WorldModel& world() { return world_; }

private:
    WorldModel world_;
};

/// All interfaces of a script. They are virtual bases, so that a host can be composed of classes that each
/// implement one or more interfaces.
class Host : public virtual MotionHost,
             public virtual SuperpositionHost,
             public virtual StateHost,
             public virtual KinematicsHost,
             public virtual SetupHost,
             public virtual RegisterHost,
             public virtual IoHost,
             public virtual SocketHost,
             public virtual MessageHost,
             public virtual ModbusHost,
             public virtual ProgramHost,
             public virtual WorldHost {
public:
    ArmFrames armFrames() const { return {flangePose(), tcpPose(Source::Actual)}; }
    Result<Pose> convertPose(const Pose& pose, const std::string& from, const std::string& to) {
        return world().convert(pose, from, to, armFrames());
    }
};

}  // namespace tiller::simulator::urscript
