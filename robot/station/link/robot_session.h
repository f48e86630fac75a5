// SPDX-License-Identifier: MIT
#pragma once

// The central object through which the user interface monitors and moves a robot. It opens and closes the
// connection, takes control, combines all state into one SessionState per frame, and converts operator input
// into motion; outputs, services and recording are parts of it. Widgets hold a reference to it and never
// access the backend directly.

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
#include "robot/station/link/robot_command.h"
#include "robot/station/link/robot_outputs.h"
#include "robot/station/link/robot_services.h"
#include "robot/station/link/robot_tooling.h"
#include "robot/station/link/sample_batch.h"
#include "robot/station/link/session_recording.h"
#include "robot/station/link/session_state.h"

namespace tiller {

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
    QString name;  ///< shown in the robot selector
    QString host;  ///< address or host name
    int portOffset = 0;
    bool simulated = false;
};

enum class Severity { Info, Warning, Error };
/// The originator of the action in a message.
enum class Origin { Tiller, Operator, Robot };

/// A limited motion: a step, or a move to a waypoint.
struct MoveRequest {
    enum class Kind { MoveJ, MoveL };
    Kind kind = Kind::MoveJ;
    JointPositions q;           ///< MoveJ: target
    Pose pose;                  ///< MoveL: target TCP pose in the base frame
    double speed = 0.25;        ///< MoveJ [rad/s], MoveL [m/s]
    double acceleration = 1.2;  ///< MoveJ [rad/s2], MoveL [m/s2]
    /// For motions of one press: the motion starts only if no further stop has occurred since.
    std::optional<std::uint64_t> stops = {};
    /// The target is a position of the project: the motion does not start while the project guard of the
    /// session objects.
    bool toProject = false;
};

class RobotSession : public QObject {
    Q_OBJECT

public:
    /// clock  for all timeouts and ages in the session; the steady clock except in tests
    explicit RobotSession(const Clock& clock = SteadyClock::shared(), QObject* parent = nullptr);
    ~RobotSession() override;

    const SessionState& state() const;
    /// For clients with their own update rate; null while disconnected. For display use samplesReceived and
    /// stateChanged.
    receive::Receiver* receiver() const;
    /// The same for another thread, which may keep it slightly longer than the connection exists.
    std::shared_ptr<const receive::Receiver> sharedReceiver() const;
    /// The address of the current or last connection.
    const RobotAddress& address() const;

    // Connection. Never blocks; the result is reported by stateChanged and message.
    void connectTo(const RobotAddress& address);
    void disconnectFromRobot();

    /// Additional fields requested by parts of the window, for this and later robots; replaces earlier requests.
    /// They are delivered by extraSamplesReceived.
    void followExtraFields(const QStringList& fields);
    /// Fields that this robot does not send: requested ones, and fields missing in its software.
    QSet<QString> absentFields() const;

    /// Outputs, registers and the speed slider.
    RobotOutputs& outputs() { return outputs_; }
    const RobotOutputs& outputs() const { return outputs_; }
    /// Power, recovery and programs.
    RobotServices& services() { return services_; }
    /// TCP and payload.
    RobotTooling& tooling() { return tooling_; }
    SessionRecording& recording() { return recording_; }

    /// In monitor-only mode every command that changes the robot is refused with a message, whatever the
    /// caller; stop() still works. Control is released first.
    void setMonitorOnly(bool on);
    bool isMonitorOnly() const;
    /// Every command that changes the robot checks this first, here and in the parts of the session. In monitor-only mode
    /// it reports that `command` is refused and returns true.
    bool refusesCommand(const QString& command);

    // Control. The result is reported by stateChanged and message.
    /// Handling of a program of another client that runs or is paused on the robot.
    enum class ForeignProgram { Ask, Stop };
    /// Uploads the control script; needs RUNNING, and Remote control where the controller has it. This ends any other
    /// program on the robot: unless `program` is Stop, takeControl() then emits takeControlQuestion() and does nothing
    /// else. Without data of the robot it emits the reason as a message and does nothing else.
    void takeControl(ForeignProgram program = ForeignProgram::Ask);
    /// Ends the control program; the robot is free for others.
    void releaseControl();

    /// Takes effect immediately: jogs slow down and end at the safety distance; moves and paths that would
    /// come closer are refused.
    /// Warns about objects whose position is unknown; moves are refused until there are none, jogs are not.
    void setSurroundings(const collision::CellSurroundings& cell);
    /// Checks whether these moves, executed in sequence from the position of the arm, are permitted.
    /// Errors  NoSolution with a sentence: the two bodies that would come too close, and where
    Result<void> permits(std::span<const MoveRequest> moves) const;
    /// The same for a path of joint positions.
    Result<void> permitsPath(std::span<const JointPositions> way) const;

    // Motion. A press starts a motion, which needs hold() at least every 100 ms until it is ended. The caller
    // keeps the returned number; a number that has been stopped never moves the arm again.
    using MotionId = std::uint64_t;
    /// guard  called before every move to a position of the project (MoveRequest::toProject, beginPath());
    /// returns the reason why it must not start, as a sentence; empty if it may. A refused move ends with
    /// Cancelled and that sentence
    void setProjectGuard(std::function<QString()> guard) { projectGuard_ = std::move(guard); }
    Result<MotionId> beginJog(const control::JogTarget& target);
    /// Errors  also those of permits(), because every bounded motion of every key passes through here
    Result<MotionId> beginMove(const MoveRequest& request);
    /// Several moves, blended by the controller. They are first sent to the controller, which takes some
    /// tenths of a second. Meanwhile the motion counts as active: it can be held, ended and stopped, but
    /// nothing moves yet. motionProgress() reports why a path could not start.
    /// stops   as MoveRequest::stops
    /// Errors  also those of permits()
    Result<MotionId> beginPath(std::vector<control::PathEntry> path, std::uint64_t stops);
    /// Number of stops on this connection, by any cause: see MoveRequest::stops.
    std::uint64_t stops() const;
    /// Progress or result of a move or a path.
    /// Errors  why a path could not start: those of control::Motions::movePath()
    Result<control::MotionProgress> motionProgress(MotionId motion) const;
    /// Starts freedrive: the arm can be guided by hand.
    Result<MotionId> beginFreedrive(const control::Freedrive& freedrive);
    /// Keeps the motion alive; a jog may change its target during the motion.
    /// Returns  false if the motion has been stopped: a new press is required
    bool hold(MotionId motion);
    bool hold(MotionId motion, const control::JogTarget& target);
    void endMotion(MotionId motion, control::StopCause cause);
    /// Stops any motion, whatever started it. STOP, Esc and Space (identified by the cause) also stop an
    /// external program and cancel taking control. Can be called at any time.
    void stop(control::StopCause cause);
    const control::MotionLimits& limits() const;
    /// Maximum speed of TCP and elbow [m/s], above 0. Takes effect immediately; a change stops the current
    /// motion.
    void setSpeedCap(double metresPerSecond);

    /// Processes one frame: fetches the samples since the last one, creates a new SessionState from the
    /// newest one and emits it. Called by the frame timer of the session, and directly where a change must be
    /// visible immediately; tests in virtual time call it themselves.
    void refresh();
    /// Frame period [ms].
    static constexpr int kFrameMs = 16;
    /// Closes the connection and waits until it is closed; used at program end.
    /// Blocks: half a second at most, longer only if a file system does
    void shutDown();

Q_SIGNALS:
    /// A connection to a robot begins: earlier data belong to another robot or connection.
    void linkBegan();
    /// The first data of a connection have arrived: of a new one, or because the robot has reconnected.
    void connected();
    /// In each frame with new samples, before the stateChanged that shows the last of them.
    void samplesReceived(const tiller::SampleBatch& batch);
    /// The same for the fields of followExtraFields().
    void extraSamplesReceived(const tiller::SampleBatch& batch);
    void stateChanged(const tiller::SessionState& state);
    /// A motion ended and its stop was measured.
    void motionStopped(const tiller::control::StopMeasurement& measurement);
    /// A message that the operator can read again later.
    /// detail  meaning of the text and suggested action, as sentences; may be empty
    void message(tiller::Severity severity, const QString& text,
                 tiller::Origin origin = tiller::Origin::Tiller, const QString& detail = {});
    /// The operator added a note about a moment. Recordings store it at that time.
    /// utcNs  time of the moment [ns since 1970]
    void noteAdded(const QString& text, qint64 utcNs);
    /// The robot's service has answered a command, or could not be reached.
    void commandDone(tiller::RobotCommand command, bool done);
    /// takeControl() would end a program of another client. Repeat it with ForeignProgram::Stop if the operator agrees.
    void takeControlQuestion();
    /// RobotServices::perform(PowerOff) would end a program of another client. Repeat it confirmed if the operator agrees.
    void powerOffQuestion();
    /// A message of the controller, complete; it is also emitted as message.
    void controllerMessage(const tiller::script::ControllerMessage& message);

private:
    void startPath(MotionId ticket, const Result<control::PreparedPath>& prepared);
    void reportChanges();
    void reportControllerMessages();

    std::unique_ptr<SessionBackend> d_;
    std::function<QString()> projectGuard_ = [] { return QString(); };
    RobotOutputs outputs_;
    RobotServices services_;
    RobotTooling tooling_;
    SessionRecording recording_;
};

}  // namespace tiller
