// SPDX-License-Identifier: MIT
#pragma once

// Moves the arm through the control program of robot/control, following the same rules.
//
// Command functions return true on success and false if the robot does not execute them (program not running,
// protective or emergency stop, no connection): see lastError(). Motions return when they are complete,
// unless they are asynchronous.
//
// Arguments are checked before sending: std::invalid_argument for a wrong number of values or NaN,
// std::range_error for a value out of range. Both contain the name of the argument. Ranges of joints and
// their speeds are those of the connected robot. The reachability of a pose is checked before a move starts.
//
// Motions end at their target or with a stop, and also without a heartbeat. A thread of this process sends
// the heartbeat 500 times per second. If the process ends for any reason, is killed or suspended, or the
// connection transmits nothing for 0.1 s, every motion ends, including moves, paths and custom scripts. A
// program that only sleeps does not end its motion. Motions also end after a protective, safeguard or
// emergency stop, and when the program is paused. They never resume automatically: setpoints (speed, servo)
// are refused until servoStop(), speedStop(), jogStop() or another command is called. disconnect() and the
// destructor also stop the arm. The arm moves without this process only if `unattended` is true. ENDS.md
// lists every call.
//
// Differences from ur_rtde: stopJ, stopL, stopScript and triggerProtectiveStop end a motion even while
// another thread waits for it. Stops also end force mode. A move after servoing does not need servoStop(). A
// lost connection is restored only by reconnect(). With setCustomScriptFile(), FLAG_CUSTOM_SCRIPT, or without
// upload while another program is running, commands are sent to that program through ur_rtde's registers. A
// program sent by setCustomScriptFile() contains the heartbeat watchdog. Apart from the watchdog, that
// program determines when its motions end. If it was started elsewhere, all of its behaviour is unknown.

#include <ur_rtde/async_operation_status.h>
#include <ur_rtde/dashboard_enums.h>
#include <ur_rtde/rtde.h>
#include <ur_rtde/rtde_path.h>
#include <ur_rtde/rtde_utility.h>

#include <chrono>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

// Argument limits, with the names of ur_rtde.
#define UR_JOINT_VELOCITY_MAX 3.14  // [rad/s]
#define UR_JOINT_VELOCITY_MIN 0
#define UR_JOINT_ACCELERATION_MAX 40.0  // [rad/s^2]
#define UR_JOINT_ACCELERATION_MIN 0
#define UR_TOOL_VELOCITY_MAX 3.0  // [m/s]
#define UR_TOOL_VELOCITY_MIN 0
#define UR_TOOL_ACCELERATION_MAX 150.0  // [m/s^2]
#define UR_TOOL_ACCELERATION_MIN 0
#define UR_SERVO_LOOKAHEAD_TIME_MAX 0.2   // [s]
#define UR_SERVO_LOOKAHEAD_TIME_MIN 0.03  // [s]
#define UR_SERVO_GAIN_MAX 2000
#define UR_SERVO_GAIN_MIN 100
#define UR_BLEND_MAX 2.0  // [m]
#define UR_BLEND_MIN 0.0

namespace ur_rtde {

struct Versions {
    std::uint32_t major = 0;
    std::uint32_t minor = 0;
    std::uint32_t bugfix = 0;
    std::uint32_t build = 0;
};

/// Threads  any; commands are serialized
class RTDEControlInterface {
public:
    enum Flags : uint16_t {
        FLAG_UPLOAD_SCRIPT = 0x01,          ///< upload the control program
        FLAG_USE_EXT_UR_CAP = 0x02,         ///< serve the control program to the ExternalControl URCap
        FLAG_VERBOSE = 0x04,                ///< print progress on standard output
        FLAG_UPPER_RANGE_REGISTERS = 0x08,  ///< use registers from number 24 on
        FLAG_NO_WAIT = 0x10,                ///< do not wait for the program to start
        FLAG_CUSTOM_SCRIPT = 0x20,          ///< use a user program in place of the control program
        FLAGS_DEFAULT = FLAG_UPLOAD_SCRIPT
    };
    enum RobotStatus {
        ROBOT_STATUS_POWER_ON = 0,
        ROBOT_STATUS_PROGRAM_RUNNING = 1,
        ROBOT_STATUS_TEACH_BUTTON_PRESSED = 2,
        ROBOT_STATUS_POWER_BUTTON_PRESSED = 3
    };
    enum SafetyStatus {
        IS_NORMAL_MODE = 0,
        IS_REDUCED_MODE = 1,
        IS_PROTECTIVE_STOPPED = 2,
        IS_RECOVERY_MODE = 3,
        IS_SAFEGUARD_STOPPED = 4,
        IS_SYSTEM_EMERGENCY_STOPPED = 5,
        IS_ROBOT_EMERGENCY_STOPPED = 6,
        IS_EMERGENCY_STOPPED = 7,
        IS_VIOLATION = 8,
        IS_FAULT = 9,
        IS_STOPPED_DUE_TO_SAFETY = 10
    };
    enum RuntimeState { STOPPING = 0, STOPPED = 1, PLAYING = 2, PAUSING = 3, PAUSED = 4, RESUMING = 5 };
    enum Feature { FEATURE_BASE, FEATURE_TOOL, FEATURE_CUSTOM };

    /// frequency    of the data [Hz]; -1: default of the controller
    /// ur_cap_port  port at which the ExternalControl URCap requests the program
    /// rt_priority  of the receive thread
    /// Throws std::runtime_error if the controller cannot be reached, or std::logic_error if the robot is not
    /// in remote control or the program does not start within 5 s (60 s if it is started manually).
    explicit RTDEControlInterface(std::string hostname, double frequency = -1.0,
                                  uint16_t flags = FLAGS_DEFAULT, int ur_cap_port = 50002,
                                  int rt_priority = RT_PRIORITY_UNDEFINED);
    virtual ~RTDEControlInterface();
    RTDEControlInterface(const RTDEControlInterface&) = delete;
    RTDEControlInterface& operator=(const RTDEControlInterface&) = delete;

    /// Ends the active motion and closes the connection. The program on the robot keeps running (see
    /// stopScript()).
    /// unattended  true: an active move or path continues to its target, as in ur_rtde, and this process can
    ///             no longer stop it. Use this only if no person can be within reach of the arm. Not
    ///             available in ur_rtde
    void disconnect(bool unattended = false);
    /// Returns  false on failure: see lastError(). Does not throw
    bool reconnect();
    /// Reason for the last failure (a call that returned false or threw); empty if there was none. Also
    /// printed once to standard error. Not available in ur_rtde.
    std::string lastError() const;
    bool isConnected();
    /// Version of the controller software; zeros before the first connection.
    const Versions& versions() const;
    /// Serial number of the robot; empty without a dashboard server.
    const std::string& serial_number() const;

    void waitPeriod(const std::chrono::steady_clock::time_point& t_cycle_start);
    std::chrono::steady_clock::time_point initPeriod();

    // ---- the program on the robot
    /// Returns true when the program is running. During a protective or emergency stop, returns true when the
    /// program has been transferred.
    bool reuploadScript();
    /// Runs `script` (lines of URScript) as a function with this name, then restarts the control program.
    /// unattended  false: an inserted watchdog thread ends the script if this process ends or the connection
    ///             is lost; names starting with tiller_heartbeat are reserved. true: the script is sent
    ///             unchanged, and moves the arm even if this process is killed. The argument has the same
    ///             meaning in the next two functions and is not available in ur_rtde
    bool sendCustomScriptFunction(const std::string& function_name, const std::string& script,
                                  bool unattended = false);
    bool sendCustomScript(const std::string& script, bool unattended = false);
    bool sendCustomScriptFile(const std::string& file_path, bool unattended = false);
    /// Replaces the control program with a file, now and in later uploads. Empty: the built-in program.
    void setCustomScriptFile(const std::string& file_path);
    void stopScript();
    bool isProgramRunning();

    // ---- motions and stops
    void stopL(double a = 10.0, bool asynchronous = false);
    void stopJ(double a = 2.0, bool asynchronous = false);
    bool moveJ(const std::vector<double>& q, double speed = 1.05, double acceleration = 1.4,
               bool asynchronous = false);
    /// path  rows of 9: joint positions [rad], speed [rad/s], acceleration [rad/s2], blend radius [m]
    bool moveJ(const std::vector<std::vector<double>>& path, bool asynchronous = false);
    bool moveJ_IK(const std::vector<double>& pose, double speed = 1.05, double acceleration = 1.4,
                  bool asynchronous = false);
    bool moveL(const std::vector<double>& pose, double speed = 0.25, double acceleration = 1.2,
               bool asynchronous = false);
    /// path  rows of 9: pose [m, rad], speed [m/s], acceleration [m/s2], blend radius [m]
    bool moveL(const std::vector<std::vector<double>>& path, bool asynchronous = false);
    bool moveL_FK(const std::vector<double>& q, double speed = 0.25, double acceleration = 1.2,
                  bool asynchronous = false);
    bool movePath(const Path& path, bool asynchronous = false);
    /// Moves with velocity xd until the tool makes contact, and then back to the pose of the first contact.
    /// Does not move if there is already a contact. Software before 5.4 has no contact detection: returns
    /// false without moving.
    /// direction  direction of the contacts in the base frame; zeros: direction of xd
    bool moveUntilContact(const std::vector<double>& xd,
                          const std::vector<double>& direction = {0.0, 0.0, 0.0, 0.0, 0.0, 0.0},
                          double acceleration = 0.5);
    /// Progress of the last asynchronous motion while it is running. Afterwards -1 or -2, alternating with
    /// each operation.
    int getAsyncOperationProgress();
    AsyncOperationStatus getAsyncOperationProgressEx();

    // ---- streams of setpoints
    /// time  minimum time before the next setpoint is read [s]; 0: one control period. As in ur_rtde, the
    ///       motion continues until the next setpoint, a stop, or another end described above
    bool speedJ(const std::vector<double>& qd, double acceleration = 0.5, double time = 0.0);
    bool speedL(const std::vector<double>& xd, double acceleration = 0.25, double time = 0.0);
    bool speedStop(double a = 10.0);
    /// As in ur_rtde, a target far from the arm is passed to the controller, which follows at maximum speed
    /// or triggers a protective stop. control::Motions refuses such targets.
    /// speed, acceleration  ignored by current software
    /// lookahead_time       0.03 ... 0.2 s
    /// gain                 100 ... 2000
    bool servoJ(const std::vector<double>& q, double speed, double acceleration, double time,
                double lookahead_time, double gain);
    bool servoL(const std::vector<double>& pose, double speed, double acceleration, double time,
                double lookahead_time, double gain);
    bool servoC(const std::vector<double>& pose, double speed = 0.25, double acceleration = 1.2,
                double blend = 0.0);
    bool servoStop(double a = 10.0);  ///< deceleration along the path of the tool [m/s2]
    /// speeds  [m/s, rad/s] in the axes of the feature; acc [m/s2]; custom_frame is a pose in the base frame
    bool jogStart(const std::vector<double>& speeds, int feature = FEATURE_BASE, double acc = 0.5,
                  const std::vector<double>& custom_frame = {});
    bool jogStop();

    // ---- force mode and freedrive
    bool forceMode(const std::vector<double>& task_frame, const std::vector<int>& selection_vector,
                   const std::vector<double>& wrench, int type, const std::vector<double>& limits);
    bool forceModeStop();
    bool forceModeSetDamping(double damping);
    bool forceModeSetGainScaling(double scaling);
    bool zeroFtSensor();
    bool setExternalForceTorque(const std::vector<double>& external_force_torque);
    bool ftRtdeInputEnable(bool enable, double sensor_mass = 0.0,
                           const std::vector<double>& sensor_measuring_offset = {0.0, 0.0, 0.0},
                           const std::vector<double>& sensor_cog = {0.0, 0.0, 0.0});
    bool enableExternalFtSensor(bool enable, double sensor_mass = 0.0,
                                const std::vector<double>& sensor_measuring_offset = {0.0, 0.0, 0.0},
                                const std::vector<double>& sensor_cog = {0.0, 0.0, 0.0});
    bool freedriveMode(const std::vector<int>& free_axes = {1, 1, 1, 1, 1, 1},
                       const std::vector<double>& feature = {0.0, 0.0, 0.0, 0.0, 0.0, 0.0});
    bool endFreedriveMode();
    int getFreedriveStatus();
    bool teachMode();
    bool endTeachMode();
    /// Number of control periods since the first contact; 0 without contact.
    int toolContact(const std::vector<double>& direction);
    /// Starts contact detection. An existing contact must be released first. On contact, the current motion
    /// stops and the tool returns to the pose of the first contact, unless a stop occurs. Returns false
    /// before 5.4.
    /// direction  zeros: direction of the tool motion
    bool startContactDetection(const std::vector<double>& direction = {0.0, 0.0, 0.0, 0.0, 0.0, 0.0});
    bool readContactDetection();
    bool stopContactDetection();

    // ---- settings
    bool setPayload(double mass, const std::vector<double>& cog = {});  ///< [kg], [m]; empty cog: unchanged
    bool setTcp(const std::vector<double>& tcp_offset);
    bool setGravity(const std::vector<double>& direction);  ///< [m/s2] in the base frame
    bool setWatchdog(double min_frequency = 10.0);
    bool kickWatchdog();
    bool triggerProtectiveStop();
    /// Sends the request to the dashboard server. Throws the same exceptions as
    /// DashboardClient::unlockProtectiveStop. Does not move the arm.
    void unlockProtectiveStop();

    // ---- queries. If the robot does not respond, functions for which an empty list, 0 or false is a valid
    // result return this value (step time, history, waypoint, contact, inverse kinematics, limits, steady). All
    // other functions throw std::runtime_error.
    double getStepTime();
    std::vector<double> getActualJointPositionsHistory(int steps = 0);
    std::vector<double> getTargetWaypoint();
    std::vector<double> getInverseKinematics(const std::vector<double>& x,
                                             const std::vector<double>& qnear = {},
                                             double max_position_error = 1e-10,
                                             double max_orientation_error = 1e-10);
    bool getInverseKinematicsHasSolution(const std::vector<double>& x, const std::vector<double>& qnear = {},
                                         double max_position_error = 1e-10,
                                         double max_orientation_error = 1e-10);
    std::vector<double> getForwardKinematics(const std::vector<double>& q = {},
                                             const std::vector<double>& tcp_offset = {});
    std::vector<double> poseTrans(const std::vector<double>& p_from, const std::vector<double>& p_from_to);
    bool isPoseWithinSafetyLimits(const std::vector<double>& pose);
    bool isJointsWithinSafetyLimits(const std::vector<double>& q);
    std::vector<double> getJointTorques();
    std::vector<double> getTCPOffset();
    std::vector<double> getActualToolFlangePose();
    bool isSteady();
    uint32_t getRobotStatus();  ///< bits: see RobotStatus

private:
    struct Private;
    std::unique_ptr<Private> d_;
};

}  // namespace ur_rtde
