// SPDX-License-Identifier: MIT
#pragma once

// Takes control of the arm, stops the arm and releases control. Motions are started with motions.h. The
// controller uploads the control program once and sends commands through RTDE registers. Every failure
// (released key, blocked user interface, crashed process, unplugged cable) stops the arm.
//
// There is one command slot: the last command wins and nothing is queued. The ID of a motion is also its
// epoch. Every stop increments the epoch, so that no earlier command can move the arm afterwards. A Held
// motion ends if it is not refreshed for 100 ms. No motion resumes automatically.

#include <QString>
#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "robot/control/control_status.h"
#include "robot/control/motion_types.h"
#include "robot/core/clock.h"
#include "robot/core/deadline.h"
#include "robot/core/result.h"
#include "robot/core/robot_model.h"
#include "robot/core/text.h"
#include "robot/core/version.h"
#include "robot/receive/data_age.h"

namespace tiller::collision {
class CollisionCheck;
}

namespace tiller::control {

/// General purpose registers used by the control program.
enum class RegisterRange : std::uint8_t {
    Lower,  ///< 0-23: all software versions; may be used by a fieldbus
    Upper,  ///< 24-47: intended for external clients; software 3.9 / 5.3 and later
};

/// Force mode parameters; empty: the robot's setting. Source: URScript force_mode_set_damping,
/// force_mode_set_gain_scaling
struct ForceSettings {
    std::optional<double> damping;      ///< 0 ... 1
    std::optional<double> gainScaling;  ///< 0 ... 2
};

struct ControllerOptions {
    Text host = QStringLiteral("127.0.0.1");
    int portOffset = 0;   ///< added to the ports 30001 and 30004
    int primaryPort = 0;  ///< 0: 30001 + portOffset
    int rtdePort = 0;     ///< 0: 30004 + portOffset
    const Clock* clock = &SteadyClock::shared();
    RegisterRange registers = RegisterRange::Upper;
    int priority = 85;  ///< SCHED_FIFO priority; 0: unchanged
    /// CPUs of the control thread, counted from 0; empty: chosen by the system. At a real-time priority, use
    /// only the CPU of the receiver thread, because waking up on another CPU takes longer.
    std::vector<int> cpus = {};
    MotionLimits limits = {};
    /// Model used by the limiter until the controller has reported the dimensions of the arm.
    RobotModelId model = RobotModelId::UR5e;
    /// Maximum age of the data and maximum response time. If either is exceeded, the active motion ends; a
    /// move with a longer timeout (MoveParameters::heartbeatTimeout) ends after that timeout. While the data are too
    /// old, status() reports no control. The robot always ends a motion after 100 ms without a heartbeat, or
    /// after the timeout of the move. Without hold-to-run operation, a larger value may be used to tolerate
    /// short delays of this PC that do not affect the heartbeat.
    std::chrono::milliseconds dataTimeout = receive::kMaxDataAge;
    /// If no data arrive for this time, the connection is closed and control is lost (ControlLoss::LinkLost).
    /// The controller does not wait for a TCP error, because there is none after a power failure or if the
    /// peer has discarded the connection. The effective timeout is at least `dataTimeout`, the timeout of the
    /// active move (MoveParameters::heartbeatTimeout), and 2 s while a control program is being sent (takeControl(),
    /// paths, functions). 0: no timeout.
    std::chrono::milliseconds connectionTimeout{450};
    /// True: a paused control program may be resumed (joinProgram()); earlier commands are discarded. If
    /// false, or if force mode, freedrive or teach mode might continue during the pause, the program is
    /// stopped.
    bool keepPaused = false;
    /// Transfers the control program to the robot. Empty: the program is sent through the primary interface.
    std::function<Result<void>(const QString& program, const Deadline& deadline)> deliver = {};
    /// False: takeControl() does not wait for the program, because the program is started later by other
    /// means.
    bool awaitProgram = true;
    /// Applied at the start of the control program.
    ForceSettings force = {};
    /// Additional RTDE outputs to receive on the control connection: see CycleState::packet. takeControl()
    /// fails with FieldUnknown if a name is not an RTDE output. Packets omit outputs that the robot does not
    /// have.
    std::vector<std::string> fields = {};
};

/// Owns the thread "control" (SCHED_FIFO at ControllerOptions::priority if permitted). takeControl() starts
/// the thread; release(), loss of the connection, or the destructor ends it. The inputs of the thread are the
/// epoch (an atomic word), the newest command (a triple buffer) and the time of the last refresh. Its output
/// is the status (a seqlock). The thread reads and writes the RTDE socket and answers each packet with one
/// input package. If the stream stalls, a timer still sends stops.
class Controller {
public:
    explicit Controller(const ControllerOptions& options);
    ~Controller();
    Controller(const Controller&) = delete;
    Controller& operator=(const Controller&) = delete;

    /// Connects, sets up the registers, uploads the control program and waits for its response. Returns at
    /// once if already in control. After a loss of control, only this call or joinProgram() restores it.
    /// Errors   HostUnreachable, ConnectionRefused, Timeout, Cancelled, RegisterInUse, FieldUnknown,
    ///          UnsafeState, RemoteControlRequired, ScriptError, ProtocolError, LinkLost; InvalidArgument and
    ///          LimitExceeded for invalid ControllerOptions::limits; FieldUnknown for
    ///          ControllerOptions::fields, listing the names that are not RTDE outputs
    /// Threads  any but the control thread; one at a time. Blocks: until the deadline
    Result<void> takeControl(const Deadline& deadline);

    /// Takes control of a running control program without sending one: either the program of a client that
    /// has called leave(), or the program of this controller after a pause.
    /// Errors   as for takeControl(); NotInControl if the running program is not a control program
    /// Threads  as for takeControl()
    Result<void> joinProgram(const Deadline& deadline);

    /// Closes the connection and leaves the control program running for another client (joinProgram()).
    /// supervision  Heartbeat: the active motion ends. Unattended: an active move or path continues to its
    ///              target without a client that could stop it; all other motions and force mode end
    /// Threads      as for release(). Blocks: as for release()
    void leave(Supervision supervision = Supervision::Heartbeat);

    /// Ends the active motion and the control program, and closes the connection. Cancels waiting calls
    /// (takeControl() and all functions that send programs) through the token of their deadline.
    /// Threads  any but the control thread. Blocks: 250 ms at most, even if the robot does not respond; the
    ///          robot decelerates by itself
    void release();

    // Threads of all following functions: any. They never block. Callers may wait about 100 ns for each other
    // while copying a command; stop() does not wait.

    /// Ends the active motion and force mode. After this call returns, no earlier command can move the arm.
    /// Returns  the epoch of this stop. When ControllerStatus::restingEpoch reaches this value, the control
    ///          program has confirmed standstill
    std::uint64_t stop(StopCause cause = StopCause::ApiCall);
    /// Number of stops so far, from any source. Ending or replacing a single motion does not count. Read this
    /// value before preparing a motion that must not start after a stop: see Motions.
    std::uint64_t stops() const;
    /// Ends this motion. Does not affect later motions.
    /// Returns  false if the motion has already ended
    bool end(MotionId motion, StopCause cause);

    MotionState motionState(MotionId motion) const;  ///< Phase, and the cause after the end.
    /// Threads  any with a real-time priority below that of the control thread. A thread with a higher
    ///          priority on the same CPU could preempt a write and then wait forever for its completion
    ControllerStatus status() const;
    MotionLimits limits() const;  ///< Includes the current speed cap [m/s].
    /// Joint limits, read from the configuration of the arm when control is taken.
    JointLimits jointLimits() const;
    /// Local port of the connection; 0 if not connected.
    /// Threads  any. Blocks: never
    std::uint16_t localPort() const;
    bool isConnected() const;  ///< True if the connection is open, with or without control.
    /// Sets the speed cap of TCP and elbow [m/s]; initially ControllerOptions::limits, 0.25 by default. A
    /// change ends the active motion (StopCause::SelectionChanged), so that the cap of a motion never
    /// changes.
    /// Errors   InvalidArgument (NaN, or not above 0), LimitExceeded (above 3 m/s: probably in mm/s)
    Result<void> setSpeedCap(double metresPerSecond);
    /// Sets the objects that jogs must not approach: the arm itself, its tool and its environment. Jogs slow
    /// down and end at the safety distance. Motion away from an object remains possible. Null: no check.
    /// Moves, paths and streams are not checked: see collision::CollisionCheck::obstruction.
    /// Threads  any; one at a time. Blocks: never
    void setCollisionCheck(std::shared_ptr<const collision::CollisionCheck> check);
    const ControllerOptions& options() const;  ///< The options of the constructor.
    /// Software version of the robot at the last takeControl(); zeros before.
    SoftwareVersion version() const;

    struct Private;

private:
    friend struct ControllerAccess;
    std::unique_ptr<Private> d_;
};

}  // namespace tiller::control
