// SPDX-License-Identifier: MIT
#pragma once

// State of a session while connected and between frames. Private to robot/station/link.

#include <QElapsedTimer>
#include <QTimer>
#include <array>
#include <atomic>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "robot/control/abandoned_program.h"
#include "robot/control/controller.h"
#include "robot/control/jog.h"
#include "robot/control/motions.h"
#include "robot/control/stop_confirmation.h"
#include "robot/dashboard/service_worker.h"
#include "robot/io/outputs.h"
#include "robot/publish/publisher.h"
#include "robot/receive/receiver.h"
#include "robot/recording/recorder.h"
#include "robot/script/message_limiter.h"
#include "robot/script/primary_client.h"
#include "robot/script/script_client.h"
#include "robot/station/executor/serial_executor.h"
#include "robot/station/link/detail/external_program_stopper.h"
#include "robot/station/link/detail/extra_field_stream.h"
#include "robot/station/link/detail/link_history.h"
#include "robot/station/link/detail/move_guard.h"
#include "robot/station/link/robot_session.h"

namespace tiller {

/// A path that is being sent to the robot. The number of its motion is not known before it starts, so the
/// path has its own number.
struct PathStart {
    enum class Phase {
        Sending,
        Ready,  ///< starts with the next hold(), which proves that the button is held
        Begun,
        Failed
    };
    control::MotionId ticket = control::kNoMotion;  ///< number of the newest path
    Phase phase = Phase::Failed;
    control::PreparedPath prepared;
    control::Motion motion;  ///< valid after the start
    Error error;             ///< why the path did not start
    int sending = 0;         ///< number of paths being sent, including cancelled ones

    /// Path numbers are above all motion numbers of the controller.
    static constexpr control::MotionId kFirstTicket = control::MotionId(1) << 62;
};

/// A program of a project that is being sent or is running. It has its own number, like a path.
struct ProgramRun {
    /// Shared with the thread that sends the program.
    struct Shared {
        std::atomic<std::int64_t> heldNs{0};  ///< time of the last hold
        std::mutex mutex;                     ///< protects the following members
        control::Motion motion;               ///< valid after the start
        bool isStarted = false;
        std::optional<control::StopCause> cancelled;  ///< cause that prevents the start of the program
        script::StepGate gate;
    };
    control::MotionId ticket = control::kNoMotion;
    QString name;
    control::Holding holding = control::Holding::Held;
    std::shared_ptr<Shared> shared;
    std::optional<Result<void>> outcome;  ///< empty until the program has ended
    bool hasStalled = false;              ///< the window hung shortly before the program ended

    bool isRunning() const { return shared != nullptr && !outcome; }
    /// Returns  false if the program has ended or must not start
    bool hold(std::int64_t nowNs);
    void end(control::StopCause cause);
    /// Prevents the start of a program that is being sent.
    void cancelStart(control::StopCause cause);
    void setGate(const script::StepGate& gate);

    /// Program numbers are above all path numbers.
    static constexpr control::MotionId kFirstTicket = control::MotionId(1) << 63;
};

/// All connections to one robot. Destroyed on the worker, because joining threads takes time.
struct RobotLink {
    std::shared_ptr<receive::Receiver> receiver;
    receive::Subscription stream;  ///< every sample, fetched once per frame
    std::uint64_t lost = 0;        ///< samples lost by the stream up to the last frame
    std::shared_ptr<control::Controller> controller;
    control::Jog jog;                                  ///< the newest jog
    control::Motion move;                              ///< the newest move or freedrive
    control::MotionId freedrive = control::kNoMotion;  ///< the newest freedrive
    PathStart path;                                    ///< the newest path
    ProgramRun program;                                ///< the newest program
    std::shared_ptr<io::Outputs> outputs;
    std::unique_ptr<dashboard::ServiceWorker> service;
    std::unique_ptr<dashboard::ServiceWorker> watch;  ///< sends queries; separate from commands
    std::unique_ptr<ExternalProgramStopper> foreignStop;
    std::unique_ptr<script::PrimaryClient> primary;
    script::MessageLimiter messageLimiter;  ///< limits the number of messages from `primary`
};

struct SessionBackend {
    explicit SessionBackend(const Clock& c) : clock(&c) {}

    const Clock* clock;
    SessionState state;
    RobotAddress address;
    std::uint64_t generation = 0;  ///< number of the connection; replies on earlier connections are ignored
    /// Numbers of the next path and the next program. They do not restart with a connection, so that a button
    /// of an earlier connection cannot hold a new motion.
    control::MotionId nextPath = PathStart::kFirstTicket;
    control::MotionId nextProgram = ProgramRun::kFirstTicket;
    std::unique_ptr<RobotLink> link;
    /// Receives fields for the recorder that the link does not receive. Used only by jobs of `files`.
    std::shared_ptr<receive::Receiver> recorderReceiver;
    const std::shared_ptr<publish::Publisher> publisher = std::make_shared<publish::Publisher>();
    recording::Recorder recorder{publisher};
    QString recordingRefusal;  ///< why the last recording could not start; empty if it started
    QTimer frameClock;

    LinkHistory history;
    receive::Sample sample;             ///< newest sample, shown by all parts of the window
    std::vector<receive::Sample> room;  ///< buffer for the samples of a frame, reused
    control::AbandonedProgram abandoned;
    const std::array<std::string, 2> stateFields = control::AbandonedProgram::fields();
    dashboard::ServiceReport report;  ///< queried about twice a second; Unknown until the first reply
    bool localRefuses = false;        ///< the robot was in Remote before, or has refused a command in Local
    bool takingControl = false;
    bool monitorOnly = false;
    CancelToken taking;  ///< cancels taking control
    control::MotionLimits limits;
    MoveGuard guard;
    QString refusal;                 ///< why control could not be taken the last time
    bool refusedByClient = false;    ///< control was refused because another client uses the registers
    bool hadForeignProgram = false;  ///< an external program existed at the last read()
    QString linkReason;

    bool movedBefore = false;  ///< the arm moved according to the newest fresh data

    std::uint64_t stopsSeen = 0;
    std::uint64_t ownStops = 0;  ///< number of displayed stops that the controller measured
    std::uint64_t foreignStops = 0;
    std::uint64_t ownUnmeasured = 0;  ///< like ownStops, for stops that could not be measured
    std::uint64_t foreignUnmeasured = 0;
    std::uint64_t unmeasuredSeen = 0;
    std::optional<std::int64_t> unmeasuredNs;  ///< time of a stop that was not measured and not reported yet
    std::int64_t readNs = 0;                   ///< time of the last read()
    std::optional<std::int64_t> stalledNs;     ///< end of the last hang of the window

    SafetyMode safetySeen = SafetyMode::Normal;
    LinkState linkSeen = LinkState::Disconnected;
    control::ControlLoss loss = control::ControlLoss::NotTaken;
    std::optional<std::int64_t>
        freshSinceLossNs;                      ///< start of fresh data after a loss of control, host clock
    bool doubtEnded = false;                   ///< data have been fresh long enough
    bool ownProgramEnded = false;              ///< the control program of a dead connection no longer runs
    std::optional<std::int64_t> ownProgramNs;  ///< last time in control; reset when no program runs on the
                                               ///< robot
    control::ControlLoss lossSeen = control::ControlLoss::NotTaken;  ///< last reported loss
    std::optional<RobotModelId> modelSeen;                           ///< last reported model of the robot
    bool externalRunSeen = false;               ///< the program of another client was reported
    bool takeoverReported = false;              ///< a takeover was reported since control was lost
    bool externalExists = false;                ///< a program of another client runs or is paused
    std::optional<std::int64_t> externalEndNs;  ///< end of that program; empty after the report
    bool readySeen = false;                     ///< the last reported robot mode was Running
    std::int64_t externalSinceNs = 0;           ///< time at which that program was reported
    std::optional<std::int64_t> replacementNs;  ///< time of the last report that a program was replaced
    std::optional<std::int64_t> startedNs;      ///< time of the controller's newest message about a start
    QString startedProgram;                     ///< name in the controller's newest message about a start
    QString programNode;                        ///< newest node label of the running program
    bool changesConfirmed = false;              ///< the operator confirmed changes during the running program

    QStringList extraFields;                 ///< requested in addition to the standard fields
    std::vector<receive::Sample> extraRoom;  ///< reused buffer for extra samples

    // Last members, because their jobs use the members above.
    SerialExecutor files;
    SerialExecutor controlling;  ///< takes and releases control
    SerialExecutor worker;
    SerialExecutor pulses;  ///< blocked by a pulse until its output is off
    ExtraFieldStream further{*clock, worker};

    void followExtraFields();

    /// Fetches the samples since the last frame into `into`, and the last sample into `sample`.
    SampleBatch drain(std::vector<receive::Sample>& into);
    /// Fills `state` from the newest sample and the controller's status.
    void read();
    /// Detects that the window hung since the last call.
    void noteStall();
    /// The state of the last frame, with current values of everything relevant for a stop.
    SessionState stateNow() const;
    control::StopEvidence stopEvidence() const;
    bool isTakenOver() const;
    /// True if the running program may be the control program of a lost connection.
    bool mayOwnProgramRun() const { return state.controlInDoubt && !ownProgramEnded; }
    /// Sentence with the earliest possible start of the running program; empty if it has just started.
    QString unknownStartText() const;
    /// True if the running program cannot be the control program, although the control connection works.
    bool isReplaced() const;

private:
    void readLink();
    void readSample();
    void readControl();
    bool isSendingPath(const control::ControllerStatus& status) const;
    bool isControlInDoubt();
    bool isRunningOtherProgram() const;
    void readGuard();
    void noteStop(const control::StopMeasurement& stop, std::uint64_t& seen);
    void noteUnmeasured(const control::UnmeasuredStop& stop, std::uint64_t& seen);
    void readRecording();
    QString obstacle() const;
};

}  // namespace tiller
