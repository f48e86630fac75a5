// SPDX-License-Identifier: MIT
#pragma once

// State of a session while connected, and between two frames. Private to robot/station/link.

#include <QElapsedTimer>
#include <QTimer>
#include <array>
#include <memory>
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

/// A path that is being sent to the robot. Its motion is known only afterwards, so the path has a number of
/// its own.
struct PathStart {
    enum class Phase {
        Sending,
        Ready,  ///< starts with the next hold(), which proves that the key is still held
        Begun,
        Failed
    };
    control::MotionId ticket = control::kNoMotion;  ///< of the newest path
    Phase phase = Phase::Failed;
    control::PreparedPath prepared;
    control::Motion motion;  ///< after the start
    Error error;             ///< why it did not start
    int sending = 0;         ///< number of paths being sent, including cancelled ones

    /// Path numbers start above all motion numbers of the controller.
    static constexpr control::MotionId kFirstTicket = control::MotionId(1) << 62;
};

/// All connections to one robot. Destroyed on the worker, because joining threads takes time.
struct RobotLink {
    std::shared_ptr<receive::Receiver> receiver;
    receive::Subscription stream;  ///< every sample, fetched once per frame
    std::uint64_t lost = 0;        ///< samples lost by the stream up to the last frame
    std::shared_ptr<control::Controller> controller;
    control::Jog jog;                                  ///< the newest one
    control::Motion move;                              ///< the newest move or freedrive
    control::MotionId freedrive = control::kNoMotion;  ///< the newest freedrive
    PathStart path;                                    ///< the newest path
    std::shared_ptr<io::Outputs> outputs;
    std::unique_ptr<dashboard::ServiceWorker> service;
    std::unique_ptr<dashboard::ServiceWorker> watch;  ///< queries, separate from commands
    std::unique_ptr<ExternalProgramStopper> foreignStop;
    std::unique_ptr<script::PrimaryClient> primary;
    script::MessageLimiter messageLimiter;  ///< for messages received by `primary`
};

struct SessionBackend {
    explicit SessionBackend(const Clock& c) : clock(&c) {}

    const Clock* clock;
    SessionState state;
    RobotAddress address;
    std::uint64_t generation = 0;  ///< number of the connection; answers to earlier ones are dropped
    std::unique_ptr<RobotLink> link;
    recording::Recorder recorder;
    QTimer frameClock;

    LinkHistory history;
    receive::Sample sample;             ///< the newest sample, shown by all parts of the window
    std::vector<receive::Sample> room;  ///< buffer for the samples of a frame, reused
    control::AbandonedProgram abandoned;
    const std::array<std::string, 2> stateFields = control::AbandonedProgram::fields();
    dashboard::ServiceReport report;  ///< queried about once a second; Unknown until the first answer
    bool localRefuses = false;  ///< was in Remote before, or has refused a command because it was in Local
    bool takingControl = false;
    bool monitorOnly = false;
    CancelToken taking;  ///< cancels taking control
    control::MotionLimits limits;
    MoveGuard guard;
    QString refusal;  ///< why the last attempt to take control failed
    QString linkReason;

    bool movedBefore = false;  ///< according to the newest fresh data

    std::uint64_t stopsSeen = 0;
    std::uint64_t ownStops = 0;  ///< stops measured by the controller that have been shown
    std::uint64_t foreignStops = 0;

    SafetyMode safetySeen = SafetyMode::Normal;
    LinkState linkSeen = LinkState::Disconnected;
    control::ControlLoss loss = control::ControlLoss::NotTaken;
    std::optional<std::int64_t>
        freshSinceLossNs;     ///< start of fresh data after a loss of control, by the monotonic host clock
    bool doubtEnded = false;  ///< data have been fresh long enough
    control::ControlLoss lossSeen = control::ControlLoss::NotTaken;  ///< last reported loss

    QStringList extraFields;                 ///< requested in addition to the standard fields
    std::vector<receive::Sample> extraRoom;  ///< as `room`

    // Last: their jobs use the members above.
    SerialExecutor files;
    SerialExecutor controlling;  ///< takes and releases control
    SerialExecutor worker;
    SerialExecutor pulses;  ///< a pulse occupies it until its output is off
    ExtraFieldStream further{*clock, worker};

    /// Requests extraFields from the connected robot.
    void followExtraFields();

    /// Fetches the samples since the last frame, the last one into `sample`.
    SampleBatch drain(std::vector<receive::Sample>& into);
    /// Fills `state` from the newest sample and the controller's status.
    void read();
    /// The state of the last frame, with current values of everything relevant for a stop.
    SessionState stateNow() const;
    /// Current evidence about a stop in control.
    control::StopEvidence stopEvidence() const;

private:
    void readLink();
    void readSample();
    void readControl();
    bool isSendingPath(const control::ControllerStatus& status) const;
    bool isControlInDoubt();
    void readGuard();
    void noteStop(const control::StopMeasurement& stop, std::uint64_t& seen);
    void readRecording();
    QString obstacle() const;
};

}  // namespace tiller
