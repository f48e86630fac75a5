// SPDX-License-Identifier: MIT
#pragma once

// What a session holds while it is connected, and what it remembers between two frames. Private to
// robot/station/link.

#include <QElapsedTimer>
#include <QTimer>
#include <memory>
#include <optional>
#include <vector>

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

/// A path on its way to the robot. Its motion is known only once it is there; until then, and after that, it goes by
/// a number of its own.
struct PathStart {
    enum class Phase {
        Sending,
        Ready,  ///< it begins with the next hold(): whoever holds it is still there then
        Begun,
        Failed
    };
    control::MotionId ticket = control::kNoMotion;  ///< of the newest; above all that the controller gives
    Phase phase = Phase::Failed;
    control::PreparedPath prepared;
    control::Motion motion;  ///< once it has begun
    Error error;             ///< why it did not begin
    int sending = 0;         ///< how many are on their way, those included that were ended meanwhile

    static constexpr control::MotionId kFirstTicket = control::MotionId(1) << 62;
};

/// Everything that talks to one robot. Torn down on the worker, because joining threads takes a moment.
struct RobotLink {
    std::shared_ptr<receive::Receiver> receiver;
    receive::Subscription stream;  ///< every sample, fetched once a frame
    std::uint64_t lost = 0;        ///< of the stream, until the last frame
    std::shared_ptr<control::Controller> controller;
    control::Jog jog;      ///< the newest one
    control::Motion move;  ///< the newest motion that is none: a move or freedrive
    control::MotionId freedrive = control::kNoMotion;  ///< the newest freedrive
    PathStart path;                                    ///< the newest path
    std::shared_ptr<io::Outputs> outputs;
    std::unique_ptr<dashboard::ServiceWorker> service;
    std::unique_ptr<dashboard::ServiceWorker> watch;  ///< only looks: never behind a command
    std::unique_ptr<ExternalProgramStopper> foreignStop;
    std::unique_ptr<script::PrimaryClient> primary;
    script::MessageLimiter messageLimiter;  ///< of what `primary` received
};

struct SessionBackend {
    explicit SessionBackend(const Clock& c) : clock(&c) {}

    const Clock* clock;
    SessionState state;
    RobotAddress address;
    std::uint64_t generation = 0;  ///< of the connection; answers to an older one are dropped
    std::unique_ptr<RobotLink> link;
    recording::Recorder recorder;
    QTimer frameClock;

    LinkHistory history;
    receive::Sample sample;             ///< the newest, as all parts of the window show it
    std::vector<receive::Sample> room;  ///< for the samples of a frame, kept from frame to frame
    dashboard::ServiceReport report;    ///< asked for about once a second; Unknown until it was answered
    bool localRefuses = false;  ///< it was in Remote once, or has refused something for being in Local
    bool takingControl = false;
    bool monitorOnly = false;
    CancelToken taking;  ///< ends the taking under way
    control::MotionLimits limits;
    MoveGuard guard;
    QString refusal;  ///< why taking control failed last
    QString linkReason;

    bool movedBefore = false;  ///< by the newest data that were fresh

    std::uint64_t stopsSeen = 0;
    std::uint64_t ownStops = 0;  ///< measured by the controller, of those shown
    std::uint64_t foreignStops = 0;

    SafetyMode safetySeen = SafetyMode::Normal;
    LinkState linkSeen = LinkState::Disconnected;
    control::ControlLoss loss = control::ControlLoss::NotTaken;
    std::optional<std::int64_t>
        freshSinceLossNs;     ///< since when data have been fresh after a loss of control
    bool doubtEnded = false;  ///< they have been for long enough
    control::ControlLoss lossSeen = control::ControlLoss::NotTaken;  ///< and reported

    QStringList extraFields;                 ///< asked for besides what comes anyway
    std::vector<receive::Sample> extraRoom;  ///< as `room`

    // Last: their jobs use what stands above.
    SerialExecutor files;
    SerialExecutor controlling;  ///< takes control and gives it back
    SerialExecutor worker;
    SerialExecutor pulses;  ///< each takes as long as its output is on: nothing else waits for that
    ExtraFieldStream further{*clock, worker};

    /// Asks the robot for extraFields, where there is one.
    void followExtraFields();

    /// Fetches what came since the last frame, and the last of it into `sample`.
    SampleBatch drain(std::vector<receive::Sample>& into);
    /// Fills `state` from the newest sample and the controller's status.
    void read();
    /// What the state was in the last frame, with all that a stop depends on as it is at this moment.
    SessionState stateNow() const;
    /// What is known at this moment of a stop in control.
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
