// SPDX-License-Identifier: MIT
#pragma once

// The central object through which the user interface monitors and moves a robot. Opens and closes the
// connection, takes control, combines all state into one SessionState per frame, and converts operator input
// into motion. Outputs, services and recording are separate parts of the session. Widgets hold a reference to
// the session and never access the backend directly.

#include <QObject>
#include <QSet>
#include <QString>
#include <QStringList>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "robot/collision/surroundings.h"
#include "robot/core/clock.h"
#include "robot/core/result.h"
#include "robot/script/controller_message.h"
#include "robot/script/step_gate.h"
#include "robot/station/journal/journal.h"
#include "robot/station/link/robot_command.h"
#include "robot/station/link/robot_outputs.h"
#include "robot/station/link/robot_services.h"
#include "robot/station/link/robot_tooling.h"
#include "robot/station/link/sample_batch.h"
#include "robot/station/link/session_recording.h"
#include "robot/station/link/session_state.h"

namespace tiller {

namespace publish {
class Publisher;
}
namespace receive {
class Receiver;
}
namespace control {
struct Freedrive;
struct MotionProgress;
struct PathEntry;
class PreparedPath;
}  // namespace control

struct RobotAddress {
    QString name;  ///< displayed in the robot selector
    QString host;  ///< address or host name
    int portOffset = 0;
    bool simulated = false;
};

/// A limited motion: a jog step, or a move to a waypoint.
struct MoveRequest {
    enum class Kind { MoveJ, MoveL };
    Kind kind = Kind::MoveJ;
    JointPositions q;           ///< MoveJ: target
    Pose pose;                  ///< MoveL: target TCP pose in the base frame
    double speed = 0.25;        ///< MoveJ [rad/s], MoveL [m/s]
    double acceleration = 1.2;  ///< MoveJ [rad/s2], MoveL [m/s2]
    /// For several motions of one button press: starts only if RobotSession::stops() still has this value.
    std::optional<std::uint64_t> stops = {};
    /// True if the target is a position of the project. The project guard of the session can refuse such a
    /// motion.
    bool toProject = false;
};

class RobotSession : public QObject {
    Q_OBJECT

public:
    /// clock  clock for all timeouts and ages in the session; the steady clock except in tests
    explicit RobotSession(const Clock& clock = SteadyClock::shared(), QObject* parent = nullptr);
    ~RobotSession() override;

    const SessionState& state() const;
    /// Receiver for clients with their own update rate; null while disconnected. For display, use
    /// samplesReceived and stateChanged.
    receive::Receiver* receiver() const;
    /// Like receiver(), for another thread. The thread may keep the receiver after the connection has ended.
    std::shared_ptr<const receive::Receiver> sharedReceiver() const;
    /// Passes samples to files and servers. Shared by all recordings of this robot.
    std::shared_ptr<publish::Publisher> publisher() const;
    const RobotAddress& address() const;

    /// Messages, notes and program steps of this robot.
    Journal& journal() { return journal_; }
    const Journal& journal() const { return journal_; }

    // Connection. These functions never block. The result is reported by stateChanged and in the journal.
    void connectTo(const RobotAddress& address);
    void disconnectFromRobot();

    /// Sets the additional fields requested by parts of the window, for this and later robots. Replaces
    /// earlier requests. extraSamplesReceived delivers the fields.
    void followExtraFields(const QStringList& fields);
    /// Receives the additional fields; null if there are none. Like sharedReceiver(), for another thread.
    std::shared_ptr<const receive::Receiver> extraReceiver() const;
    /// Requested or standard fields that this robot does not send, e.g. because of its software version.
    QSet<QString> absentFields() const;

    /// Outputs, registers and the speed slider.
    RobotOutputs& outputs() { return outputs_; }
    const RobotOutputs& outputs() const { return outputs_; }
    /// Power, recovery and programs.
    RobotServices& services() { return services_; }
    /// TCP and payload.
    RobotTooling& tooling() { return tooling_; }
    SessionRecording& recording() { return recording_; }

    /// In monitor-only mode, every command that changes the robot is refused with a message, regardless of
    /// the caller. stop() still works. Control is released before the mode is set.
    void setMonitorOnly(bool on);
    bool isMonitorOnly() const;
    /// Must be called first by every command that changes the robot, here and in the parts of the session. In
    /// monitor-only mode, logs that `command` is refused and returns true.
    bool refusesCommand(const QString& command);

    /// Asks the operator before a change of outputs, registers, gripper or speed slider. If a program of
    /// another client is running, or a Tiller program without hold-to-run, emits changeQuestion() and returns
    /// true, and the caller must not make the change. If nothing is connected to the signal, returns false.
    /// what    name of the change, e.g. "DO 3"
    /// change  makes the change after the operator has agreed
    bool asksBeforeChange(const QString& what, const std::function<void()>& change);
    /// True if asksBeforeChange() would ask now.
    bool mustAskBeforeChange() const;
    /// Call when the operator has agreed. asksBeforeChange() then returns false until the running program
    /// ends or until confirmChanges(false).
    void confirmChanges(bool confirmed = true);

    // Control. The result is reported by stateChanged and in the journal.
    /// Handling of another client's program that is running or paused on the robot.
    enum class ForeignProgram { Ask, Stop };
    /// Uploads the control program, which ends any other program on the robot. Requires RUNNING, and Remote
    /// control if the controller supports it. If `program` is Ask and another program is running or paused,
    /// only emits takeControlQuestion(). If `program` is Ask and there are no robot data, reports the reason.
    void takeControl(ForeignProgram program = ForeignProgram::Ask);
    /// Ends the control program, so that other clients can use the robot.
    void releaseControl();

    /// Takes effect at once. Jogs slow down and end at the safety distance. Moves and paths that would
    /// violate the safety distance are refused. Objects whose position is unknown are reported in a warning;
    /// while there are such objects, moves are refused, but jogs are permitted.
    void setSurroundings(const collision::CellSurroundings& cell);
    /// Checks whether these moves are permitted in sequence from the current arm position.
    /// Errors  NoSolution with a sentence that names the two bodies that would be too close and the position
    ///         on the path, or the object whose position is unknown
    Result<void> permits(std::span<const MoveRequest> moves) const;
    /// Like permits(), for a path of joint positions.
    Result<void> permitsPath(std::span<const JointPositions> way) const;

    // Motion. Pressing a button starts a motion, which needs hold() at least every 100 ms until it is ended.
    // The caller keeps the returned number. After a stop, a motion with this number never moves the arm
    // again.
    using MotionId = std::uint64_t;
    /// guard  called before every move to a position of the project (MoveRequest::toProject, beginPath()),
    ///        and before beginProgram(). Returns why the motion must not start, as a sentence; empty if it
    ///        may start. A refused motion ends with Cancelled and this sentence.
    void setProjectGuard(std::function<QString()> guard) { projectGuard_ = std::move(guard); }
    Result<MotionId> beginJog(const control::JogTarget& target);
    /// Errors  include those of permits(), because every limited motion of a button starts here
    Result<MotionId> beginMove(const MoveRequest& request);
    /// Starts several moves, blended by the controller. The moves are first sent to the controller, which
    /// takes a few tenths of a second. During this time, the motion is active: it can be held, ended and
    /// stopped, but the arm does not move yet. motionProgress() reports why a path could not start.
    /// stops   see MoveRequest::stops
    /// Errors  include those of permits()
    Result<MotionId> beginPath(std::vector<control::PathEntry> path, std::uint64_t stops);
    /// Sends a complete program, runs it instead of the control program, and then takes control again. The
    /// program is an active motion from this call until control is back, and no other motion can start.
    /// Ending the motion ends the program. motionProgress() reports the result.
    /// name     displayed name
    /// script   URScript, one `def`. The robot ends it when this process ends or the connection is lost
    /// holding  Held: needs hold() like every motion, and also ends when the program is paused
    /// stops    see MoveRequest::stops
    /// gate     which steps may begin; the script calls the functions of script::stepGateScript()
    /// variables  variables of the script that the gate can change
    /// Errors   those of permits() that do not depend on the target, and of the project guard
    Result<MotionId> beginProgram(const QString& name, const QString& script, control::Holding holding,
                                  std::uint64_t stops, const script::StepGate& gate = {},
                                  const std::vector<script::GateVariable>& variables = {});
    /// Call when the program of beginProgram() was paused or stopped on the robot, by the teach pendant or
    /// another client. Replaces the last stop with a stop without a cause, because this stop was not
    /// measured.
    void noteStopOnRobot();
    /// Name of the program of beginProgram() that is active without hold-to-run; empty if there is none.
    std::optional<QString> freeProgram() const;
    void setStepGate(MotionId program, const script::StepGate& gate);
    /// Number of stops on this connection, from any cause. See MoveRequest::stops.
    std::uint64_t stops() const;
    /// Progress or result of a move, a path or a program.
    /// Errors  if a path could not start: those of control::Motions::movePath(). If a program could not start
    ///         or did not end normally: those of control::Programs::runScript() except Stopped
    Result<control::MotionProgress> motionProgress(MotionId motion) const;
    /// Starts freedrive, in which the arm can be moved by hand.
    Result<MotionId> beginFreedrive(const control::Freedrive& freedrive);
    /// Keeps the motion active. For a jog, the target may change.
    /// Returns  false if the motion has ended; the button must be pressed again
    bool hold(MotionId motion);
    bool hold(MotionId motion, const control::JogTarget& target);
    void endMotion(MotionId motion, control::StopCause cause);
    /// Stops any motion. A stop by STOP, Esc or Space (identified by the cause) also stops an external
    /// program and cancels taking control. Can be called at any time.
    void stop(control::StopCause cause);
    const control::MotionLimits& limits() const;
    /// Sets the maximum speed of TCP and elbow [m/s], above 0. Takes effect at once. A change stops the
    /// current motion.
    void setSpeedCap(double metresPerSecond);

    /// Processes one frame: fetches the samples since the last frame, creates a new SessionState from the
    /// newest sample and emits it. Called by the frame timer of the session, and directly if a change must be
    /// visible at once. Tests in virtual time call it themselves.
    void refresh();
    /// Frame period [ms].
    static constexpr int kFrameMs = 16;
    /// Closes the connection before the session is destroyed. The destructor waits until the connection is
    /// closed: half a second at most, longer only if a file system blocks.
    void shutDown();

Q_SIGNALS:
    /// A connection to a robot has started. Earlier data belong to another robot or connection.
    void linkBegan();
    /// followExtraFields() has changed the fields and, during a connection, extraReceiver().
    void extraFieldsChanged();
    /// The first data of a connection have arrived, after connecting or reconnecting.
    void connected();
    /// Emitted in each frame with new samples, before the stateChanged that shows the last sample.
    void samplesReceived(const tiller::SampleBatch& batch);
    /// Like samplesReceived(), for the fields of followExtraFields().
    void extraSamplesReceived(const tiller::SampleBatch& batch);
    void stateChanged(const tiller::SessionState& state);
    /// A motion has ended and its stop was measured.
    void motionStopped(const tiller::control::StopMeasurement& measurement);
    /// A command to the robot's service has been executed (`done`), or has failed or was refused.
    void commandDone(tiller::RobotCommand command, bool done);
    /// takeControl() would end a program of another client. If the operator agrees, call it again with
    /// ForeignProgram::Stop.
    void takeControlQuestion();
    /// A change could disturb the running program. If the operator agrees, call confirmChanges() and
    /// `change`.
    void changeQuestion(const QString& what, const std::function<void()>& change);
    /// RobotServices::perform() would start, pause or end an external program. If the operator
    /// agrees, call it again with `confirmed`.
    void commandQuestion(tiller::RobotCommand command);
    /// A complete message from the controller. Messages for the operator are also added to the journal.
    void controllerMessage(const tiller::script::ControllerMessage& message);

private:
    Result<control::MotionProgress> programProgress() const;
    void startPath(MotionId ticket, const Result<control::PreparedPath>& prepared);
    void reportChanges();
    void reportUnmeasuredStop();
    void reportExternalProgram();
    void reportEndOfExternalProgram(bool exists);
    /// Call this when the controller has reported the start of a program.
    void reportReplacement();
    void reportControllerMessages();

    Journal journal_;
    std::unique_ptr<SessionBackend> d_;
    std::function<QString()> projectGuard_ = [] { return QString(); };
    RobotOutputs outputs_;
    RobotServices services_;
    RobotTooling tooling_;
    SessionRecording recording_;
};

}  // namespace tiller
