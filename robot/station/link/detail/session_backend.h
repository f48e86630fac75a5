// SPDX-License-Identifier: MIT
#pragma once

// State of a session while it is connected, and between two frames. Private to robot/station/link.

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

/// A path that is being sent to the robot. Its motion is known only after that; the path keeps a separate number.
struct PathStart {
    enum class Phase {
        Sending,
        Ready,  ///< starts with the next hold(), which proves that the key is still held
        Begun,
        Failed
    };
    control::MotionId ticket = control::kNoMotion;  ///< of the newest; above all that the controller gives
    Phase phase = Phase::Failed;
    control::PreparedPath prepared;
    control::Motion motion;  ///< after the start
    Error error;             ///< why it did not begin
    int sending = 0;         ///< number of paths being sent, including those already ended

    static constexpr control::MotionId kFirstTicket = control::MotionId(1) << 62;
};

/// Everything that talks to one robot. Torn down on the worker, because joining threads takes a moment.
struct RobotLink {
    std::shared_ptr<receive::Receiver> receiver;
    receive::Subscription stream;  ///< every sample, fetched once per frame
    std::uint64_t lost = 0;        ///< of the stream, until the last frame
    std::shared_ptr<control::Controller> controller;
    control::Jog jog;                                  ///< the newest one
    control::Motion move;                              ///< the newest move or freedrive
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
    control::AbandonedProgram abandoned;
    const std::array<std::string, 2> stateFields = control::AbandonedProgram::fields();
    dashboard::ServiceReport report;  ///< queried about once a second; Unknown until the first answer
    bool localRefuses = false;  ///< was in Remote before, or has refused a command because it was in Local
    bool takingControl = false;
    bool monitorOnly = false;
    CancelToken taking;  ///< cancels taking control
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

    // Last: their jobs use the members above.
    SerialExecutor files;
    SerialExecutor controlling;  ///< takes control and gives it back
    SerialExecutor worker;
    SerialExecutor pulses;  ///< each takes as long as its output is on: nothing else waits for that
    ExtraFieldStream further{*clock, worker};

    /// Requests extraFields from the connected robot.
    void followExtraFields();

    /// Fetches the samples since the last frame, the last one into `sample`.
    SampleBatch drain(std::vector<receive::Sample>& into);
    /// Fills `state` from the newest sample and the controller's status.
    void read();
    /// The state of the last frame, with current values of everything that a stop depends on.
    SessionState stateNow() const;
    /// Present knowledge about a stop in control.
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
