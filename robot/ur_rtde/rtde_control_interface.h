// SPDX-License-Identifier: MIT
#pragma once

// Moves the arm, through the control program of robot/control and by its rules.
//
// Functions that command something return true on success, motions unless asynchronous when they are done,
// and false when the robot does not (program not running, protective or emergency stop, no connection):
// lastError() says why.
//
// Arguments are checked before anything is sent: std::invalid_argument for a wrong number of values or a
// value that is not a number, std::range_error for one out of range, both naming the argument. Ranges of
// joints and their speeds are the connected robot's own. Whether the arm can reach a pose is looked at before
// a move begins.
//
// What ends a motion, beyond its own end and the stops: a thread of this process sends a heartbeat 500 times a
// second. When the process ends for whatever reason, is killed or stopped, or the link sends nothing for 0.1 s,
// every motion ends: moves, paths and custom scripts too; a program that merely sleeps keeps its motion. The same
// after a protective, safeguard or emergency stop, and when the program is paused. Nothing of it comes back by
// itself: set points (speed, servo) are refused until servoStop(), speedStop(), jogStop() or another command has
// been called. disconnect() and the destructor stop the arm as well. Only where `unattended` is given as true
// does the arm move on without this process. ENDS.md lists every call.
//
// Beyond what ur_rtde does: stopJ, stopL, stopScript and triggerProtectiveStop overtake a motion another thread
// is waiting for; stops end force mode too; a move after servoing needs no servoStop(); a lost connection is not
// taken up again without reconnect(). With setCustomScriptFile(), FLAG_CUSTOM_SCRIPT, or without upload where
// another program runs, commands go to that program by ur_rtde's registers. A program sent by setCustomScriptFile()
// contains the heartbeat watchdog; what else ends a motion, and everything in a program started elsewhere, is up
// to that program.

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

// The limits of arguments, by the names programs know.
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

/// Threads  any; commands are carried out one after the other.
class RTDEControlInterface {
public:
    enum Flags : uint16_t {
        FLAG_UPLOAD_SCRIPT = 0x01,   ///< upload the control program
        FLAG_USE_EXT_UR_CAP = 0x02,  ///< hand it to the ExternalControl URCap instead, which asks for it
        FLAG_VERBOSE = 0x04,         ///< say on standard output what is done
        FLAG_UPPER_RANGE_REGISTERS = 0x08,  ///< use registers from 24 on
        FLAG_NO_WAIT = 0x10,                ///< do not wait for the program to run
        FLAG_CUSTOM_SCRIPT = 0x20,          ///< a program of the user's does what the control program does
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

    /// frequency    of the data [Hz]; -1: the controller's own
    /// ur_cap_port  where the ExternalControl URCap asks for the program
    /// rt_priority  of the thread that receives
    /// Throws std::runtime_error when the controller cannot be reached, std::logic_error when the robot is
    /// not in remote control or the program does not start: within 5 s, one that is started by hand within 60
    /// s.
    explicit RTDEControlInterface(std::string hostname, double frequency = -1.0,
                                  uint16_t flags = FLAGS_DEFAULT, int ur_cap_port = 50002,
                                  int rt_priority = RT_PRIORITY_UNDEFINED);
    virtual ~RTDEControlInterface();
    RTDEControlInterface(const RTDEControlInterface&) = delete;
    RTDEControlInterface& operator=(const RTDEControlInterface&) = delete;

    /// Stops what moves and ends the connection; the program on the robot keeps running (see stopScript()).
    /// unattended  true: a move or path under way continues to its end, as with ur_rtde, and nothing in this
    ///             process can stop it any more. Use it only where no person can be in reach of the arm. Beyond
    ///             what ur_rtde has
    void disconnect(bool unattended = false);
    /// Returns  false when it did not work: lastError() says why. Never throws on that account
    bool reconnect();
    /// Why the last call that returned false or threw did; empty when none has. Also said on standard error,
    /// once. Beyond what ur_rtde has.
    std::string lastError() const;
    bool isConnected();
    /// Of the controller's software; zeros before the first connection.
    const Versions& versions() const;
    /// Of the robot; empty where there is no dashboard server to ask.
    const std::string& serial_number() const;

    void waitPeriod(const std::chrono::steady_clock::time_point& t_cycle_start);
    std::chrono::steady_clock::time_point initPeriod();

    // ---- the program on the robot
    /// Returns true when it runs; during a protective or emergency stop when it was handed over.
    bool reuploadScript();
    /// Runs `script` (lines of URScript) as a function of this name, then the control program again.
    /// unattended  false: a watchdog thread in the script ends it when this process ends or the link is lost;
    ///             names beginning with tiller_heartbeat belong to it. true: the script is sent as it is, and
    ///             moves the arm on after this process was killed. Beyond what ur_rtde has. The same for the
    ///             two below
    bool sendCustomScriptFunction(const std::string& function_name, const std::string& script,
                                  bool unattended = false);
    bool sendCustomScript(const std::string& script, bool unattended = false);
    bool sendCustomScriptFile(const std::string& file_path, bool unattended = false);
    /// Replaces the control program by a file's, at once and in every later upload; empty: by the built-in
    /// one.
    void setCustomScriptFile(const std::string& file_path);
    void stopScript();
    bool isProgramRunning();

    // ---- moves and their end
    void stopL(double a = 10.0, bool asynchronous = false);
    void stopJ(double a = 2.0, bool asynchronous = false);
    bool moveJ(const std::vector<double>& q, double speed = 1.05, double acceleration = 1.4,
               bool asynchronous = false);
    /// path  rows of 9: joint positions, speed, acceleration, blend radius
    bool moveJ(const std::vector<std::vector<double>>& path, bool asynchronous = false);
    bool moveJ_IK(const std::vector<double>& pose, double speed = 1.05, double acceleration = 1.4,
                  bool asynchronous = false);
    bool moveL(const std::vector<double>& pose, double speed = 0.25, double acceleration = 1.2,
               bool asynchronous = false);
    /// path  rows of 9: pose, speed, acceleration, blend radius
    bool moveL(const std::vector<std::vector<double>>& path, bool asynchronous = false);
    bool moveL_FK(const std::vector<double>& q, double speed = 0.25, double acceleration = 1.2,
                  bool asynchronous = false);
    bool movePath(const Path& path, bool asynchronous = false);
    /// Moves with speed xd until the tool touches something, then back to where it did; not at all when it
    /// does already. Returns false, without moving, on software before 5.4, which feels no contact. direction
    /// which contacts count, in the base frame; zeros: those in the direction of xd
    bool moveUntilContact(const std::vector<double>& xd,
                          const std::vector<double>& direction = {0.0, 0.0, 0.0, 0.0, 0.0, 0.0},
                          double acceleration = 0.5);
    /// Of the last asynchronous motion: its progress while it runs, else -1 or -2, taking turns.
    int getAsyncOperationProgress();
    AsyncOperationStatus getAsyncOperationProgressEx();

    // ---- streams of set points
    /// time  how long the set point is held before the next one is looked at [s]; 0: a control period. The arm
    ///       goes on afterwards, as with ur_rtde: until a new set point, a stop, or an end as above
    bool speedJ(const std::vector<double>& qd, double acceleration = 0.5, double time = 0.0);
    bool speedL(const std::vector<double>& xd, double acceleration = 0.25, double time = 0.0);
    bool speedStop(double a = 10.0);
    /// A target far from the arm is handed on as it is, as ur_rtde does: what happens then is up to the
    /// controller, which follows as fast as it may or stops protectively. control::Motions refuses it. speed,
    /// acceleration  not used by current software. lookahead_time 0.03 ... 0.2 s, gain 100 ... 2000
    bool servoJ(const std::vector<double>& q, double speed, double acceleration, double time,
                double lookahead_time, double gain);
    bool servoL(const std::vector<double>& pose, double speed, double acceleration, double time,
                double lookahead_time, double gain);
    bool servoC(const std::vector<double>& pose, double speed = 0.25, double acceleration = 1.2,
                double blend = 0.0);
    bool servoStop(double a = 10.0);  ///< along the line of the tool [m/s2]
    /// speeds  [m/s, rad/s] along the axes of the feature; acc [m/s2]; custom_frame a pose in the base frame
    bool jogStart(const std::vector<double>& speeds, int feature = FEATURE_BASE, double acc = 0.5,
                  const std::vector<double>& custom_frame = {});
    bool jogStop();

    // ---- force and hands
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
    /// Number of controller steps back to the contact, 0 for none.
    int toolContact(const std::vector<double>& direction);
    /// Looks for contact from when there is none; the motion under way then stops and goes back to where the
    /// contact began, and any stop ends that too. direction  zeros: the direction the tool moves in. Returns
    /// false on software before 5.4.
    bool startContactDetection(const std::vector<double>& direction = {0.0, 0.0, 0.0, 0.0, 0.0, 0.0});
    bool readContactDetection();
    bool stopContactDetection();

    // ---- settings
    bool setPayload(double mass, const std::vector<double>& cog = {});  ///< [kg], [m]; no cog: it stays
    bool setTcp(const std::vector<double>& tcp_offset);
    bool setGravity(const std::vector<double>& direction);  ///< [m/s2] in the base frame
    bool setWatchdog(double min_frequency = 10.0);
    bool kickWatchdog();
    bool triggerProtectiveStop();
    /// Asks the dashboard server for it. Throws as DashboardClient::unlockProtectiveStop; nothing moves by
    /// it.
    void unlockProtectiveStop();

    // ---- queries. When the robot does not answer: an empty list, 0 or false from those that answer with as
    // much where there is nothing to say (step time, history, waypoint, contact, inverse kinematics, limits,
    // steady); std::runtime_error from the others
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
    uint32_t getRobotStatus();  ///< bits, see RobotStatus

private:
    struct Private;
    std::unique_ptr<Private> d_;
};

}  // namespace ur_rtde
