// SPDX-License-Identifier: MIT
#pragma once

// Takes control of the arm, stops it and gives control back; motions.h moves it. Uploads our control program
// once, tells it through RTDE registers what to do, and makes sure that whatever goes wrong (a key let go, a
// hung interface, a dead process, a cut cable) ends in standstill.
//
// The rules, in short: one slot, the last command wins, nothing is queued. Every motion has a number that is
// also its epoch; every stop moves the epoch on, so that nothing commanded before a stop can move the arm
// after it. A held motion whose holder falls silent for 100 ms ends. Nothing resumes by itself.

#include <QString>
#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "robot/control/control_status.h"
#include "robot/control/motion_types.h"
#include "robot/core/clock.h"
#include "robot/core/deadline.h"
#include "robot/core/result.h"
#include "robot/core/robot_model.h"
#include "robot/core/text.h"
#include "robot/core/version.h"

namespace tiller::collision {
class CollisionCheck;
}

namespace tiller::control {

/// Which general purpose registers the control program talks through.
enum class RegisterRange : std::uint8_t {
    Lower,  ///< 0-23: every software version; a fieldbus on the robot may own them
    Upper,  ///< 24-47: meant for programs like this one; from software 3.9 / 5.3
};

/// How lively force mode is; left out: as the robot has it. Source: URScript force_mode_set_damping,
/// force_mode_set_gain_scaling
struct ForceSettings {
    std::optional<double> damping;      ///< 0 ... 1
    std::optional<double> gainScaling;  ///< 0 ... 2
};

struct ControllerOptions {
    Text host = QStringLiteral("127.0.0.1");
    int portOffset = 0;   ///< added to 30001 and 30004
    int primaryPort = 0;  ///< 0: 30001 + portOffset
    int rtdePort = 0;     ///< 0: 30004 + portOffset
    const Clock* clock = &SteadyClock::shared();
    RegisterRange registers = RegisterRange::Upper;
    int priority = 85;  ///< SCHED_FIFO; 0 = leave the thread as it is
    /// The control thread stays on these CPUs, counted from 0; empty: where the system puts it. At a
    /// real-time priority one is best, the receiver's: being woken up on another one takes longer.
    std::vector<int> cpus = {};
    MotionLimits limits = {};
    /// Used for the limiter until, or unless, the controller has told its own dimensions.
    RobotModelId model = RobotModelId::UR5e;
    /// Data older than this, or a command unanswered for longer, end the active motion; a move with a longer
    /// silence of its own (MoveParameters::silence) ends after that. While the data are older than this,
    /// status() reports no control. The robot ends the motion after 100 ms without a heartbeat, or after that
    /// silence, in any case and by its own time; a program without a person at a key may leave it to the
    /// robot, so that a hiccup of this computer that the robot did not notice ends nothing.
    std::chrono::milliseconds dataTimeout{100};
    /// Without data for so long the connection counts as dead: it is closed and control is lost
    /// (ControlLoss::LinkLost). Neither the end of the TCP connection nor an error is waited for, because
    /// neither comes after a power cut or from a controller that has forgotten the connection. Never sooner
    /// than `dataTimeout`, or than the silence of the move under way; 0: only when the connection ends.
    std::chrono::milliseconds connectionTimeout{450};
    /// True: a control program that was paused may be played again (joinProgram()), without what it was told
    /// before. False, and where force mode, freedrive or teach mode might go on in the pause: it is stopped.
    bool keepPaused = false;
    /// How the control program gets to the robot. Empty: sent to the primary interface.
    std::function<Result<void>(const QString& program, const Deadline& deadline)> deliver = {};
    /// False: takeControl() does not wait for the program to run, which somebody else starts some time later.
    bool awaitProgram = true;
    /// What the control program sets when it begins.
    ForceSettings force = {};
};

/// Thread: one, named "control", SCHED_FIFO at ControllerOptions::priority where permitted; started by
/// takeControl(), ended by release(), by the loss of the connection and by the destructor. Into it cross
/// the epoch (an atomic word), the newest command (a triple buffer) and the time of the last refresh; out of
/// it the status (a seqlock). It reads and writes the descriptor of the RTDE socket itself and answers each
/// received data package with one input package; when the stream stalls, a timer takes over so that a stop
/// still goes out.
class Controller {
public:
    explicit Controller(const ControllerOptions& options);
    ~Controller();
    Controller(const Controller&) = delete;
    Controller& operator=(const Controller&) = delete;

    /// Connects, sets the registers up, uploads the control program and waits until it answers. Does nothing
    /// when it already does. After any loss of control this is the only way back.
    /// Errors   HostUnreachable, ConnectionRefused, Timeout, Cancelled, RegisterInUse, FieldUnknown,
    ///          UnsafeState, RemoteControlRequired, ScriptError, ProtocolError, LinkLost; InvalidArgument and
    ///          LimitExceeded naming what is wrong in ControllerOptions::limits
    /// Threads  any but the control thread; one at a time. Blocks: until the deadline
    Result<void> takeControl(const Deadline& deadline);

    /// Takes control through the control program that runs already: of a client that has gone (leave()), or
    /// ours after a pause. Sends none.
    /// Errors   as takeControl(); NotInControl when the program that runs is none of ours
    /// Threads  as takeControl()
    Result<void> joinProgram(const Deadline& deadline);

    /// Closes the connection and leaves the control program running for another client (joinProgram()).
    /// supervision  Heartbeat: stops what moves. Unattended: a move or path under way continues to its target
    ///              with no client to stop it; everything else that moves the arm is ended, force mode too
    /// Threads  and blocking as release()
    void leave(Supervision supervision = Supervision::Heartbeat);

    /// Stops what moves, ends the control program and closes the connection. Cancels a call that is waiting
    /// (takeControl() and all that sends programs), through its deadline's token.
    /// Threads  any but the control thread. Blocks: 250 ms at most, whatever the peer does; the arm brakes on
    ///          by itself
    void release();

    // All of the following: threads any; never block (callers wait for each other's copy of a command, some
    // 100 ns; stop() not even for that).

    /// Ends whatever is active, force mode too. When it returns, no command given before can move the arm any
    /// more.
    /// Returns  the epoch of this stop: once ControllerStatus::restingEpoch has reached it, the control program
    ///          has confirmed that it moves nothing
    std::uint64_t stop(StopCause cause = StopCause::ApiCall);
    /// How many stops there were, by whomever; the end of one motion, or its giving way to another, is none. Who
    /// reads it before he prepares a motion can have it begin only if none came meanwhile: see Motions.
    std::uint64_t stops() const;
    /// Ends this motion; another one goes on.
    /// Returns  false when it had ended already
    bool end(MotionId motion, StopCause cause);

    MotionState motionState(MotionId motion) const;  ///< Active, or how it ended.
    /// Threads  any whose real-time priority is below the control thread's: on its CPU one above it could
    ///          interrupt the writing, and wait for ever for its end
    ControllerStatus status() const;
    MotionLimits limits() const;  ///< With the speed cap as it is now [m/s].
    /// What the joints of this arm can: by its own configuration once control has been taken.
    JointLimits jointLimits() const;
    /// The port of this end of the connection; 0 when there is none.
    /// Threads  any. Blocks: never
    std::uint16_t localPort() const;
    bool isConnected() const;  ///< Whether there is a connection, in control or not.
    /// From now on TCP and elbow get no faster than this [m/s]; 0.25 unless ControllerOptions::limits said
    /// otherwise. Another cap than before ends whatever is active (StopCause::SelectionChanged): nothing goes
    /// on under a cap it was not begun with.
    /// Errors   InvalidArgument (not a number, or none above 0), LimitExceeded (above 3 m/s: millimetres?)
    Result<void> setSpeedCap(double metresPerSecond);
    /// From now on every jog slows down and ends at the safety distance from whatever this check knows: the arm
    /// itself, its tool and its surroundings. Motion away from it stays free. Null: there is nothing to keep away from.
    /// Moves, paths and streams are not checked: see collision::CollisionCheck::obstruction.
    /// Threads  any; one at a time. Blocks: never
    void setCollisionCheck(std::shared_ptr<const collision::CollisionCheck> check);
    /// From the connection of the last takeControl(); zeros before.
    SoftwareVersion version() const;

    struct Private;

private:
    friend struct ControllerAccess;
    std::unique_ptr<Private> d_;
};

}  // namespace tiller::control
