// SPDX-License-Identifier: MIT
#pragma once

// A Robotiq gripper at the robot's wrist, controlled through the socket of its URCap on the controller.
//
// Errors: std::runtime_error if there is no connection, if the connection breaks, or if the URCap does not
// respond within 2 s.

#include <ur_rtde/rtde.h>

#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace ur_rtde {

/// Positions, speeds and forces are in the units of setUnit(), initially normalized (0 ... 1). Position 1 is
/// open, 0 is closed. Values are clamped to the range of the gripper. A negative speed or force selects the
/// preset of setSpeed() or setForce(). The initial presets are full speed and minimum force.
/// Threads  one at a time
class RobotiqGripper {
public:
    enum eStatus { RESET = 0, ACTIVATING = 1, ACTIVE = 3 };
    enum eObjectStatus { MOVING = 0, STOPPED_OUTER_OBJECT = 1, STOPPED_INNER_OBJECT = 2, AT_DEST = 3 };
    enum class ConnectionState : std::uint8_t { DISCONNECTED = 0, CONNECTED = 1 };
    enum eMoveMode { START_MOVE, WAIT_FINISHED };
    enum eUnit { UNIT_DEVICE, UNIT_NORMALIZED, UNIT_PERCENT, UNIT_MM };
    enum eMoveParameter { POSITION, SPEED, FORCE };
    enum ePostionId { OPEN = 0, CLOSE = 1 };
    enum eFaultCode {
        NO_FAULT = 0x00,
        FAULT_ACTION_DELAYED = 0x05,
        FAULT_ACTIVATION_BIT = 0x07,
        FAULT_TEMPERATURE = 0x08,
        FAULT_COMM = 0x09,
        FAULT_UNDER_VOLTAGE = 0x0A,
        FAULT_EMCY_RELEASE_ACTIVE = 0x0B,
        FAULT_INTERNAL = 0x0C,
        FAULT_ACTIVATION = 0x0D,
        FAULT_OVERCURRENT = 0x0E,
        FAULT_EMCY_RELEASE_FINISHED = 0x0F
    };
    enum eUnitConversion { TO_DEVICE_UNIT, FROM_DEVICE_UNIT };

    explicit RobotiqGripper(const std::string& Hostname, int Port = 63352, bool verbose = false);
    virtual ~RobotiqGripper();
    RobotiqGripper(const RobotiqGripper&) = delete;
    RobotiqGripper& operator=(const RobotiqGripper&) = delete;

    void connect(uint32_t timeout_ms = 2000);
    void disconnect();
    bool isConnected() const;

    /// Resets and activates the gripper, which opens and closes once. Returns when the gripper is ready.
    void activate(bool auto_calibrate = false);
    /// Closes and opens the empty gripper to determine its end positions.
    void autoCalibrate(float Speed = -1.0);
    bool isActive();

    float getOpenPosition() const;
    float getClosedPosition() const;
    float getCurrentPosition();
    bool isOpen();
    bool isClosed();

    /// Returns  the object status (eObjectStatus). With START_MOVE, the call returns at the start of the
    ///          motion
    int move(float Position, float Speed = -1.0, float Force = -1.0, eMoveMode MoveMode = START_MOVE);
    int open(float Speed = -1.0, float Force = -1.0, eMoveMode MoveMode = START_MOVE);
    int close(float Speed = -1.0, float Force = -1.0, eMoveMode MoveMode = START_MOVE);
    /// Opens or closes slowly in any state. The gripper must then be activated again.
    void emergencyRelease(ePostionId Direction, eMoveMode MoveMode = WAIT_FINISHED);
    int faultStatus();  ///< eFaultCode

    void setUnit(eMoveParameter Param, eUnit Unit);
    /// Stroke of the gripper for UNIT_MM; initially 40.
    void setPositionRange_mm(int Range);
    /// Sets the preset for moves without this value, clamped to the range of the gripper.
    /// Returns  the resulting preset
    float setSpeed(float Speed);
    float setForce(float Force);

    eObjectStatus objectDetectionStatus();
    eObjectStatus waitForMotionComplete();

    // Sets variables of the URCap: ACT, GTO, ATR, ARD, FOR, SPE, POS, STA, PRE, OBJ, FLT.
    bool setVars(const std::vector<std::pair<std::string, int>> Vars);
    bool setVar(const std::string& Var, int Value);
    int getVar(const std::string& var);
    std::vector<int> getVars(const std::vector<std::string>& Vars);
    /// End positions in device units, 0 (open) ... 255 (closed).
    void getNativePositionRange(int& MinPosition, int& MaxPosition);
    void setNativePositionRange(int MinPosition, int MaxPosition);

private:
    struct Private;
    std::unique_ptr<Private> d_;
};

}  // namespace ur_rtde
