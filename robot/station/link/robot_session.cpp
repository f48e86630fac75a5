// SPDX-License-Identifier: MIT
#include "robot/station/link/robot_session.h"

#include <QMetaMethod>
#include <algorithm>
#include <limits>

#include "robot/control/compliance.h"
#include "robot/control/motions.h"
#include "robot/control/programs.h"
#include "robot/core/wait_until.h"
#include "robot/receive/field_info.h"
#include "robot/receive/robot_state.h"
#include "robot/rtde/fields.h"
#include "robot/script/step_gate.h"
#include "robot/script/supervised_program.h"
#include "robot/station/link/detail/session_backend.h"
#include "robot/station/text/controller_codes.h"
#include "robot/station/text/error_summary.h"
#include "robot/station/text/mode_words.h"
#include "robot/station/text/move_words.h"
#include "robot/station/text/notation.h"
#include "robot/station/text/texts.h"

namespace tiller {
namespace {

using std::chrono::milliseconds;

constexpr milliseconds kTakeControlTime{5000};
constexpr milliseconds kSendPathTime{5000};

/// Text for the cause; for a stop by the safety system, the name of its mode, e.g. "Protective stop".
QString causeWords(control::StopCause cause, SafetyStatus safety) {
    const bool bySafety = cause == control::StopCause::UnsafeMode && !allowsMotion(safety);
    return bySafety ? safetyWords(safety).text : texts::stopCauseText(cause);
}

QString stopSentence(const control::StopMeasurement& stop, SafetyStatus safety) {
    return RobotSession::tr("Stopped: %1 (%2 ms, %3)")
        .arg(causeWords(stop.cause, safety))
        .arg(stop.durationMs, 0, 'f', 0)
        .arg(format::length(stop.distanceMm / 1e3, 1));
}

/// Example: "C157A1 Collision detected by a joint (elbow)".
QString codeTitle(const script::ControllerMessage& message, const CodeWords& words) {
    const QString name = message.codeName() + QLatin1Char(' ');
    if (message.text.isEmpty()) {
        return name + words.title;
    }
    return words.known ? name + words.title + QStringLiteral(" (") + message.text + QLatin1Char(')')
                       : name + message.text;
}

/// True for stops caused by the operator: a released button, the pointer leaving the button, a second
/// button, a stop key, or STOP.
bool isOperatorStop(control::StopCause cause) {
    using control::StopCause;
    return cause == StopCause::Released || cause == StopCause::PointerLeft || cause == StopCause::Escape ||
           cause == StopCause::Space || cause == StopCause::StopButton || cause == StopCause::SecondButton;
}

/// True if a program with step numbers ended during a step, e.g. because of the stop button of the teach
/// pendant. A program that reaches its end resets the step number.
bool wasStoppedOnRobot(const receive::Receiver& receiver) {
    receive::Sample newest;
    const auto hasEnded = [&] {
        newest = receiver.latest();
        return !newest.isEmpty() && receive::RobotState(newest).runtimeState() == RuntimeState::Stopped;
    };
    // The data of this connection may be older than those of the control connection.
    return waitUntil(Deadline::after(std::chrono::milliseconds(200)), hasEnded) &&
           receive::RobotState(newest).outputIntRegister(script::kStepRegister).value_or(0) > 0;
}

}  // namespace

RobotSession::RobotSession(const Clock& clock, QObject* parent)
    : QObject(parent)
    , d_(std::make_unique<SessionBackend>(clock))
    , outputs_(*this, *d_)
    , services_(*this, *d_)
    , tooling_(*this, *d_)
    , recording_(*this, *d_) {
    qRegisterMetaType<SessionState>();
    d_->frameClock.setTimerType(Qt::PreciseTimer);
    d_->frameClock.setInterval(kFrameMs);
    connect(this, &RobotSession::connected, this, [this] { d_->link->foreignStop->warmUp(); });
    connect(&d_->frameClock, &QTimer::timeout, this, &RobotSession::refresh);
    d_->frameClock.start();
    d_->read();
}

RobotSession::~RobotSession() {
    shutDown();
}

const SessionState& RobotSession::state() const {
    return d_->state;
}

receive::Receiver* RobotSession::receiver() const {
    return d_->link ? d_->link->receiver.get() : nullptr;
}

std::shared_ptr<const receive::Receiver> RobotSession::sharedReceiver() const {
    return d_->link ? d_->link->receiver : nullptr;
}

std::shared_ptr<publish::Publisher> RobotSession::publisher() const {
    return d_->publisher;
}

const RobotAddress& RobotSession::address() const {
    return d_->address;
}

const control::MotionLimits& RobotSession::limits() const {
    return d_->limits;
}

void RobotSession::setSpeedCap(double metresPerSecond) {
    d_->limits.tcpSpeed = metresPerSecond;
    if (d_->link) {
        (void)d_->link->controller->setSpeedCap(metresPerSecond);
    }
    refresh();
}

// ---- connection
// ----------------------------------------------------------------------------------------------------

void RobotSession::connectTo(const RobotAddress& address) {
    disconnectFromRobot();
    d_->address = address;

    auto link = std::make_unique<RobotLink>();

    receive::ReceiverOptions receiverOptions;
    receiverOptions.host = address.host;
    receiverOptions.port = static_cast<std::uint16_t>(rtde::kPort + address.portOffset);
    receiverOptions.clock = d_->clock;
    for (const int number : {script::kStepRegister, script::kGateRegister}) {
        receiverOptions.fields.push_back(rtde::intRegisterName(rtde::Direction::Output, number));
    }
    link->receiver = std::make_shared<receive::Receiver>(receiverOptions);
    link->stream = link->receiver->subscribe();
    static_cast<void>(link->receiver->start());  // lastError() stores a failure, and readLink() reports it

    control::ControllerOptions controllerOptions;
    controllerOptions.host = address.host;
    controllerOptions.portOffset = address.portOffset;
    controllerOptions.clock = d_->clock;
    controllerOptions.limits = d_->limits;
    link->controller = std::make_shared<control::Controller>(controllerOptions);
    d_->guard.forget();

    io::OutputsOptions outputsOptions;
    outputsOptions.host = address.host;
    outputsOptions.port = receiverOptions.port;
    link->outputs =
        std::make_shared<io::Outputs>(outputsOptions, io::OutputFeedback::fromReceiver(*link->receiver));

    link->service =
        std::make_unique<dashboard::ServiceWorker>(dashboard::serviceAt(address.host, address.portOffset));
    link->service->start();
    link->watch =
        std::make_unique<dashboard::ServiceWorker>(dashboard::serviceAt(address.host, address.portOffset));
    link->watch->start();
    link->foreignStop =
        std::make_unique<ExternalProgramStopper>(*this, address.host, address.portOffset, *d_->clock);

    script::PrimaryClientOptions primaryOptions;
    primaryOptions.host = address.host;
    primaryOptions.port = script::kPrimaryPort + address.portOffset;
    primaryOptions.clock = d_->clock;
    link->primary = std::make_unique<script::PrimaryClient>(primaryOptions);
    link->primary->start();

    d_->link = std::move(link);
    d_->sample = receive::Sample(d_->link->receiver->layout());
    d_->abandoned.reset();
    d_->startedProgram.clear();
    d_->programNode.clear();
    d_->modelSeen.reset();
    d_->safetySeen = SafetyMode::Normal;  // a stop of the previous robot has not ended
    d_->followExtraFields();
    journal_.setRobot(address.name, {});
    Q_EMIT linkBegan();
    journal_.add(Severity::Info, tr("Connecting to %1 (%2)").arg(address.name, address.host),
                 Origin::Operator);
    refresh();
}

void RobotSession::disconnectFromRobot() {
    if (!d_->link) {
        return;
    }
    stop(control::StopCause::ControlLost);
    recording_.stop();
    ++d_->generation;
    d_->controlling.cancelAll();
    d_->worker.cancelAll();
    // Joining the threads of the link takes a few tenths of a second, so the worker does it.
    d_->worker.postCleanup([link = std::shared_ptr<RobotLink>(std::move(d_->link))]() mutable {
        link->controller->release();
        link->outputs->disconnect();
        link->receiver->stop();
        link.reset();
    });
    d_->link.reset();
    d_->followExtraFields();
    d_->takingControl = false;
    d_->refusal.clear();
    outputs_.forget();
    services_.forget();
    d_->localRefuses = false;
    d_->history.clear();
    d_->stopsSeen = 0;
    d_->ownStops = 0;
    d_->ownUnmeasured = d_->foreignUnmeasured = d_->unmeasuredSeen = 0;
    d_->foreignStops = 0;
    d_->linkSeen = LinkState::Disconnected;
    journal_.add(Severity::Info, tr("Disconnected from %1").arg(d_->address.name));
    refresh();
}

void RobotSession::shutDown() {
    d_->frameClock.stop();
    disconnectFromRobot();
}

void RobotSession::followExtraFields(const QStringList& fields) {
    if (fields != d_->extraFields) {
        d_->extraFields = fields;
        d_->followExtraFields();
        Q_EMIT extraFieldsChanged();
    }
}

std::shared_ptr<const receive::Receiver> RobotSession::extraReceiver() const {
    return d_->further.receiver();
}

QSet<QString> RobotSession::absentFields() const {
    QSet<QString> fields = d_->further.absent();
    if (!d_->link || d_->state.version.major == 0) {
        return fields;
    }
    for (const std::string& field : d_->link->receiver->absentFields()) {
        fields.insert(QString::fromStdString(field));
    }
    for (const receive::FieldInfo& field : receive::fieldInfos()) {
        if (!field.isAvailableOn(d_->state.version)) {
            fields.insert(QString::fromUtf8(field.name.data(), static_cast<qsizetype>(field.name.size())));
        }
    }
    return fields;
}

void RobotSession::setMonitorOnly(bool on) {
    if (on == d_->monitorOnly) {
        return;
    }
    if (on) {
        outputs_.endPulses();  // releaseControl() ends the program that times the pulses
        stop(control::StopCause::ControlLost);
        releaseControl();
    }
    d_->monitorOnly = on;
    d_->refusal.clear();
    journal_.add(Severity::Info,
                 on ? tr("Monitor only: this window does not change anything on the robot. STOP still works.")
                    : tr("“Monitor only” is off. Commands to the robot are enabled."),
                 Origin::Operator);
    if (on && d_->link && d_->state.hasData()) {
        outputs_.release();
    }
    refresh();
}

bool RobotSession::isMonitorOnly() const {
    return d_->monitorOnly;
}

bool RobotSession::refusesCommand(const QString& command) {
    if (d_->monitorOnly) {
        journal_.add(Severity::Warning, tr("%1: refused. %2").arg(command, texts::monitorOnlyObstacle()));
    }
    return d_->monitorOnly;
}

// ---- control
// -------------------------------------------------------------------------------------------------------

void RobotSession::takeControl(ForeignProgram program) {
    if (refusesCommand(tr("Take control")) || !d_->link || d_->takingControl || d_->state.programRuns) {
        return;
    }
    if (program == ForeignProgram::Ask && !d_->state.hasData()) {
        // It is unknown whether an external program is running.
        journal_.add(Severity::Warning, d_->state.controlReason);
        return;
    }
    if (program == ForeignProgram::Ask && d_->state.hasForeignProgram()) {
        Q_EMIT takeControlQuestion();
        return;
    }
    if (d_->state.hasForeignProgram()) {
        journal_.add(Severity::Warning, tr("Stopping the other client's program to take control."),
                     Origin::Operator);
    }
    d_->takingControl = true;
    d_->refusal.clear();
    services_.forgetStop();
    d_->link->foreignStop->withdraw();
    const CancelToken stopped;
    d_->taking = stopped;
    const std::uint64_t generation = d_->generation;
    d_->controlling.post(this, [this, generation, stopped,
                                controller = d_->link->controller](const CancelToken& token) {
        const CancelToken either([token, stopped] { return token.isCancelled() || stopped.isCancelled(); });
        Result<void> result = controller->takeControl(Deadline::after(kTakeControlTime, either));
        if (result && stopped.isCancelled()) {
            controller->release();
            result = Error{ErrorCode::Cancelled, QStringLiteral("take control"), {}};
        }
        return std::function<void()>([this, generation, result] {
            if (generation != d_->generation) {
                return;
            }
            d_->takingControl = false;
            if (result) {
                journal_.add(Severity::Info, tr("In control"), Origin::Operator);
            } else if (result.error().code == ErrorCode::Cancelled) {
                journal_.add(Severity::Info, tr("Taking control was cancelled by a stop."));
            } else {
                d_->refusal = texts::errorSummary(result.error());
                d_->refusedByClient = result.error().code == ErrorCode::RegisterInUse;
                d_->localRefuses =
                    d_->localRefuses || result.error().code == ErrorCode::RemoteControlRequired;
                journal_.add(Severity::Error, d_->refusal, Origin::Tiller, result.error().toString());
            }
            refresh();
        });
    });
    refresh();
}

void RobotSession::releaseControl() {
    if (!d_->link) {
        return;
    }
    services_.forgetStop();
    d_->taking.cancel();
    if (d_->link->program.isRunning()) {
        d_->link->controller->stop(control::StopCause::ControlLost);  // `controlling` waits for the program
    }
    d_->controlling.post(this, [controller = d_->link->controller](const CancelToken&) {
        controller->release();
        return std::function<void()>();
    });
}

void RobotSession::setSurroundings(const collision::CellSurroundings& cell) {
    const bool isNew = cell.unplaced != d_->guard.surroundings().unplaced;
    d_->guard.setSurroundings(cell);
    if (isNew) {
        for (const collision::UnplacedObject& object : cell.unplaced) {
            journal_.add(Severity::Warning, tr("Moves are refused. %1.").arg(unplacedText(object)));
        }
    }
    refresh();
}

Result<void> RobotSession::permits(std::span<const MoveRequest> moves) const {
    return d_->guard.permit(d_->state, moves);
}

Result<void> RobotSession::permitsPath(std::span<const JointPositions> way) const {
    return d_->guard.permit(d_->state, way);
}

// ---- motion
// --------------------------------------------------------------------------------------------------------

namespace {

Error notMovable(const SessionState& state) {
    return {state.link == LinkState::Live ? ErrorCode::NotInControl : ErrorCode::NotConnected,
            state.controlReason,
            {}};
}

}  // namespace

Result<RobotSession::MotionId> RobotSession::beginJog(const control::JogTarget& target) {
    if (!d_->link || d_->monitorOnly) {
        return notMovable(d_->state);
    }
    const Result<control::Jog> jog =
        control::Motions(*d_->link->controller).startJog(target, control::Holding::Held);
    if (!jog) {
        return jog.error();
    }
    d_->link->jog = *jog;
    return jog->id();
}

Result<RobotSession::MotionId> RobotSession::beginMove(const MoveRequest& request) {
    if (!d_->link || d_->monitorOnly) {
        return notMovable(d_->state);
    }
    if (const QString objection = request.toProject ? projectGuard_() : QString(); !objection.isEmpty()) {
        return Error{ErrorCode::Cancelled, objection, {}};
    }
    if (const Result<void> permitted = permits({&request, 1}); !permitted) {
        return permitted.error();
    }
    const control::MoveParameters parameters{request.speed, request.acceleration, control::Holding::Held};
    control::Controller& controller = *d_->link->controller;
    control::Motions motions(controller, request.stops.value_or(controller.stops()));
    const Result<control::Motion> move = request.kind == MoveRequest::Kind::MoveJ
                                             ? motions.moveJ(request.q, parameters)
                                             : motions.moveL(request.pose, parameters);
    if (!move) {
        return move.error();
    }
    d_->link->move = *move;
    return move->id();
}

Result<RobotSession::MotionId> RobotSession::beginPath(control::MotionPath path, std::uint64_t stops) {
    if (!d_->link || !d_->state.canMove()) {
        return notMovable(d_->state);
    }
    if (const QString objection = projectGuard_(); !objection.isEmpty()) {
        return Error{ErrorCode::Cancelled, objection, {}};
    }
    if (const Result<void> permitted = d_->guard.permit(d_->state, path); !permitted) {
        return permitted.error();
    }
    PathStart& start = d_->link->path;
    start.ticket = d_->nextPath++;
    start.phase = PathStart::Phase::Sending;
    ++start.sending;
    d_->controlling.post(
        this, [this, ticket = start.ticket, generation = d_->generation, stops, path = std::move(path),
               controller = d_->link->controller](const CancelToken& token) {
            const Result<control::PreparedPath> prepared =
                control::Motions(*controller, stops).preparePath(path, Deadline::after(kSendPathTime, token));
            return std::function<void()>([this, ticket, generation, prepared] {
                if (generation == d_->generation) {
                    startPath(ticket, prepared);
                }
            });
        });
    refresh();
    return start.ticket;
}

Result<RobotSession::MotionId> RobotSession::beginProgram(
    const QString& name, const QString& script, control::Holding holding, std::uint64_t stops,
    const script::StepGate& gate, const std::vector<script::GateVariable>& variables) {
    if (!d_->link || !d_->state.canMove()) {
        return notMovable(d_->state);
    }
    if (const QString objection = projectGuard_(); !objection.isEmpty()) {
        return Error{ErrorCode::Cancelled, objection, {}};
    }
    if (const Result<void> permitted = permits({}); !permitted) {
        return permitted.error();
    }
    ProgramRun& run = d_->link->program;
    d_->changesConfirmed = false;
    run.ticket = d_->nextProgram++;
    run.name = name;
    run.holding = holding;
    run.outcome.reset();
    run.hasStalled = false;
    run.shared = std::make_shared<ProgramRun::Shared>();
    run.shared->heldNs = d_->clock->nowNs();
    run.shared->gate = gate;
    d_->controlling.post(
        this, [this, ticket = run.ticket, generation = d_->generation, shared = run.shared, script, holding,
               stops, gate, variables, clock = d_->clock, controller = d_->link->controller,
               receiver = d_->link->receiver](const CancelToken& token) {
            control::ScriptTerms terms;
            terms.holding = holding;
            terms.stops = stops;
            terms.gate = gate;
            terms.variables = variables;
            terms.starting = [&](const control::Motion& motion) {
                const std::lock_guard lock(shared->mutex);
                const bool held =
                    clock->nowNs() - shared->heldNs <= std::chrono::nanoseconds(control::kHoldTime).count();
                if (shared->cancelled || (holding == control::Holding::Held && !held)) {
                    return false;
                }
                shared->motion = motion;
                shared->isStarted = true;
                motion.setGate(shared->gate);  // the gate may have changed since the call
                return true;
            };
            terms.regainsAfterDataGap = false;  // the window never takes control by itself
            terms.regainsControl = [receiver] { return !wasStoppedOnRobot(*receiver); };
            const Result<void> outcome =
                control::Programs(*controller).runScript(script, Deadline::never(token), terms);
            return std::function<void()>([this, ticket, generation, outcome] {
                if (generation == d_->generation && ticket == d_->link->program.ticket) {
                    constexpr std::int64_t kStallSeenNs = 2 * kNsPerSecond;
                    d_->noteStall();
                    d_->link->program.outcome = outcome;
                    d_->link->program.hasStalled =
                        d_->stalledNs && d_->clock->nowNs() - *d_->stalledNs < kStallSeenNs;
                    refresh();
                }
            });
        });
    refresh();
    return run.ticket;
}

Result<control::MotionProgress> RobotSession::programProgress() const {
    const ProgramRun& run = d_->link->program;
    control::MotionProgress progress;
    const std::lock_guard lock(run.shared->mutex);
    if (!run.outcome) {
        progress.phase = control::MotionPhase::Active;
        progress.executing = run.shared->isStarted && run.shared->motion.progress().executing;
        return progress;
    }
    if (!*run.outcome && run.outcome->error().code == ErrorCode::LinkLost && run.hasStalled) {
        progress.cause = control::StopCause::EventLoopStalled;  // the connection is intact
        return progress;
    }
    if (!*run.outcome && run.outcome->error().code != ErrorCode::Stopped) {
        return run.outcome->error();
    }
    progress.cause = *run.outcome ? control::StopCause::Completed
                     : run.shared->isStarted
                         ? run.shared->motion.state().cause
                         : run.shared->cancelled.value_or(control::StopCause::EventLoopStalled);
    return progress;
}

bool ProgramRun::hold(std::int64_t nowNs) {
    if (!isRunning()) {
        return false;
    }
    const std::lock_guard lock(shared->mutex);
    if (shared->cancelled) {
        return false;
    }
    shared->heldNs = nowNs;
    return !shared->isStarted || shared->motion.refresh();
}

void ProgramRun::setGate(const script::StepGate& gate) {
    if (!isRunning()) {
        return;
    }
    const std::lock_guard lock(shared->mutex);
    shared->gate = gate;
    if (shared->isStarted) {
        shared->motion.setGate(gate);
    }
}

void ProgramRun::end(control::StopCause cause) {
    cancelStart(cause);
    if (!isRunning()) {
        return;
    }
    const std::lock_guard lock(shared->mutex);
    if (shared->isStarted) {
        shared->motion.cancel(cause);
    }
}

void ProgramRun::cancelStart(control::StopCause cause) {
    if (!isRunning()) {
        return;
    }
    const std::lock_guard lock(shared->mutex);
    if (!shared->isStarted && !shared->cancelled) {
        shared->cancelled = cause;
    }
}

void RobotSession::startPath(MotionId ticket, const Result<control::PreparedPath>& prepared) {
    PathStart& start = d_->link->path;
    --start.sending;
    if (ticket == start.ticket && start.phase == PathStart::Phase::Sending) {
        start.phase = prepared ? PathStart::Phase::Ready : PathStart::Phase::Failed;
        start.prepared = prepared ? *prepared : control::PreparedPath();
        start.error = prepared ? Error{} : prepared.error();
    }
    refresh();
}

namespace {

/// Starts the path once it has been sent, if the button is still held. Then keeps the path active.
bool holdPath(RobotLink& link) {
    PathStart& path = link.path;
    if (path.phase == PathStart::Phase::Ready) {
        const Result<control::Motion> motion =
            control::Motions(*link.controller).startPath(path.prepared, control::Holding::Held);
        path.phase = motion ? PathStart::Phase::Begun : PathStart::Phase::Failed;
        path.motion = motion ? *motion : control::Motion();
        path.error = motion ? Error{} : motion.error();
    }
    return path.phase == PathStart::Phase::Sending ||
           (path.phase == PathStart::Phase::Begun && path.motion.refresh());
}

}  // namespace

std::uint64_t RobotSession::stops() const {
    return d_->link ? d_->link->controller->stops() : 0;
}

Result<control::MotionProgress> RobotSession::motionProgress(MotionId motion) const {
    control::MotionProgress progress;
    if (!d_->link) {
        progress.cause = control::StopCause::ControlLost;
        return progress;
    }
    const RobotLink& link = *d_->link;
    if (motion != control::kNoMotion && motion == link.program.ticket) {
        return programProgress();
    }
    if (motion < PathStart::kFirstTicket) {
        if (motion == link.move.id()) {
            return link.move.progress();
        }
        const control::MotionState state = link.controller->motionState(motion);
        progress.phase = state.phase;
        progress.cause = state.cause;
        return progress;
    }
    if (motion != link.path.ticket) {
        progress.cause = control::StopCause::Superseded;
        return progress;
    }
    switch (link.path.phase) {
        case PathStart::Phase::Sending:
        case PathStart::Phase::Ready:
            progress.phase = control::MotionPhase::Active;
            return progress;
        case PathStart::Phase::Begun:
            return link.path.motion.progress();
        case PathStart::Phase::Failed:
            break;
    }
    return link.path.error;
}

Result<RobotSession::MotionId> RobotSession::beginFreedrive(const control::Freedrive& freedrive) {
    if (!d_->link || d_->monitorOnly) {
        return notMovable(d_->state);
    }
    const Result<control::Motion> motion =
        control::Compliance(*d_->link->controller).startFreedrive(freedrive, control::Holding::Held);
    if (!motion) {
        return motion.error();
    }
    d_->link->move = *motion;
    d_->link->freedrive = motion->id();
    return motion->id();
}

bool RobotSession::hold(MotionId motion) {
    if (!d_->link || motion == control::kNoMotion) {
        return false;
    }
    RobotLink& link = *d_->link;
    if (motion >= ProgramRun::kFirstTicket) {
        return motion == link.program.ticket && link.program.hold(d_->clock->nowNs());
    }
    if (motion >= PathStart::kFirstTicket) {
        return motion == link.path.ticket && holdPath(link);
    }
    return motion == link.move.id() ? link.move.refresh() : motion == link.jog.id() && link.jog.refresh();
}

std::optional<QString> RobotSession::freeProgram() const {
    const bool runs =
        d_->link && d_->link->program.isRunning() && d_->link->program.holding == control::Holding::Free;
    return runs ? std::optional(d_->link->program.name) : std::nullopt;
}

void RobotSession::setStepGate(MotionId program, const script::StepGate& gate) {
    if (d_->link && program == d_->link->program.ticket) {
        d_->link->program.setGate(gate);
    }
}

bool RobotSession::hold(MotionId motion, const control::JogTarget& target) {
    return d_->link && motion != control::kNoMotion && motion == d_->link->jog.id() &&
           d_->link->jog.refresh(target);
}

void RobotSession::endMotion(MotionId motion, control::StopCause cause) {
    if (!d_->link) {
        return;
    }
    RobotLink& link = *d_->link;
    if (motion >= ProgramRun::kFirstTicket) {
        if (motion == link.program.ticket) {
            link.program.end(cause);
        }
    } else if (motion < PathStart::kFirstTicket) {
        link.controller->end(motion, cause);
    } else if (motion == link.path.ticket &&
               (link.path.phase == PathStart::Phase::Sending || link.path.phase == PathStart::Phase::Ready)) {
        // A path without a motion number can only be prevented by a stop.
        link.controller->stop(cause);
        link.path.phase = PathStart::Phase::Failed;
        link.path.error = {ErrorCode::Stopped, QStringLiteral("start a path"), {}};
    } else if (motion == link.path.ticket && link.path.phase == PathStart::Phase::Begun) {
        link.controller->end(link.path.motion.id(), cause);
    }
}

void RobotSession::stop(control::StopCause cause) {
    if (!d_->link) {
        return;
    }
    d_->link->program.cancelStart(cause);
    const std::uint64_t epoch = d_->link->controller->stop(cause);
    services_.stopPrograms(cause, epoch);
}

// ---- the frame
// -----------------------------------------------------------------------------------------------------

void RobotSession::refresh() {
    // Move the buffer out of the member, because a connected slot may process events and thereby start
    // another frame.
    std::vector<receive::Sample> room = std::move(d_->room);
    const std::uint64_t connection = d_->sample.connection;
    const SampleBatch batch = d_->drain(room);
    const bool isNewConnection = d_->sample.connection != connection;
    d_->read();
    journal_.setRobot(d_->state.robotName,
                      d_->state.hasData() ? std::optional(d_->state.robotTime) : std::nullopt);
    if (!batch.samples.empty() || batch.lost > 0) {
        Q_EMIT samplesReceived(batch);
    }
    std::vector<receive::Sample> extraRoom = std::move(d_->extraRoom);
    if (const SampleBatch further = d_->further.drain(extraRoom);
        !further.samples.empty() || further.lost > 0) {
        Q_EMIT extraSamplesReceived(further);
    }
    d_->extraRoom = std::move(extraRoom);
    reportChanges();
    if (d_->link) {
        services_.followForeignStop(batch);
        if (isNewConnection) {
            d_->link->service->reconnect();  // the controller may have dropped this connection as well
            Q_EMIT connected();
        }
        services_.ask();
    }
    d_->room = std::move(room);
    Q_EMIT stateChanged(d_->state);
}

void RobotSession::reportChanges() {
    const SessionState& state = d_->state;
    if (state.lastStop.count > d_->stopsSeen) {
        d_->stopsSeen = state.lastStop.count;
        Q_EMIT motionStopped(state.lastStop);
        journal_.add(Severity::Info, stopSentence(state.lastStop, state.safety()),
                     isOperatorStop(state.lastStop.cause) ? Origin::Operator : Origin::Tiller);
    }
    reportUnmeasuredStop();
    if (state.link != d_->linkSeen) {
        if (state.link == LinkState::Live && d_->linkSeen != LinkState::Stale) {
            journal_.add(Severity::Info, tr("Connected to %1").arg(state.robotName));
        } else if (state.link == LinkState::Lost) {
            journal_.add(Severity::Error, state.linkReason);
        }
        d_->linkSeen = state.link;
    }
    if (d_->loss != d_->lossSeen) {
        d_->lossSeen = d_->loss;
        if (d_->loss == control::ControlLoss::LinkLost) {
            journal_.add(Severity::Error,
                         tr("Control was lost: the control connection did not respond for 0.5 s or was "
                            "closed. STOP, Space and Esc still stop the robot. Take control again."));
        }
    }
    if (state.modelKnown && state.link == LinkState::Live) {
        const RobotModelId before = std::exchange(d_->modelSeen, state.model).value_or(state.model);
        if (before != state.model) {
            journal_.add(Severity::Warning,
                         tr("The robot at %1 is a %2 now. It was a %3 before.")
                             .arg(state.address, QLatin1String(robotModel(state.model).name),
                                  QLatin1String(robotModel(before).name)),
                         Origin::Robot);
        }
    }
    reportExternalProgram();
    if (state.isFresh() && d_->readySeen != (state.robotMode == RobotMode::Running)) {
        d_->readySeen = !d_->readySeen;
        if (!d_->readySeen) {
            journal_.add(Severity::Info, tr("Robot mode: %1").arg(robotModeWords(state.robotMode).text),
                         Origin::Robot);
        }
    }
    if (state.hasData() && state.safety() != d_->safetySeen) {
        d_->safetySeen = state.safety();
        const QString obstacle = texts::safetyModeObstacle(state.safety());
        journal_.add(obstacle.isEmpty() ? Severity::Info : Severity::Error,
                     obstacle.isEmpty() ? tr("Safety mode is Normal again") : obstacle, Origin::Robot);
    }
    if (state.link == LinkState::Live) {
        outputs_.reportSlider();
        outputs_.followControl();
        outputs_.followPulses();
    }
    recording_.reportFailure();
    if (d_->link) {
        reportControllerMessages();
    }
}

void RobotSession::noteStopOnRobot() {
    control::UnmeasuredStop& stop = d_->state.unmeasuredStop;
    stop = {control::StopCause::None, control::UnmeasuredStop::Reason::OtherProgram, stop.count + 1};
    d_->unmeasuredSeen = stop.count;  // the program run reports this stop
    d_->state.lastStopSeen = false;
}

void RobotSession::reportUnmeasuredStop() {
    const SessionState& state = d_->state;
    control::UnmeasuredStop& stop = d_->state.unmeasuredStop;
    if (stop.count > d_->unmeasuredSeen) {
        d_->unmeasuredSeen = stop.count;
        d_->unmeasuredNs = d_->clock->nowNs();
    }
    using Reason = control::UnmeasuredStop::Reason;
    if (stop.reason == Reason::NotStopped && state.isFresh() && !state.moving &&
        !state.foreignProgramRuns()) {
        stop.reason = Reason::DataGap;  // stopped in the meantime
    }
    if (!d_->unmeasuredNs) {
        return;
    }
    // A program that the operator wanted to stop may be waiting between two motions.
    const bool programRuns = isOperatorStop(stop.cause) && state.foreignProgramRuns();
    // The arm may still be braking and the program may still be ending when data arrive again.
    constexpr std::int64_t kBrakingNs = kNsPerSecond;
    if (state.isFresh() && (state.moving || programRuns) &&
        d_->clock->nowNs() - *d_->unmeasuredNs < kBrakingNs) {
        return;
    }
    d_->unmeasuredNs.reset();
    const bool canHaveFailed = stop.reason == Reason::DataGap && state.isFresh() && !state.motionActive;
    const QString cause = causeWords(stop.cause, state.safety());
    if (canHaveFailed && (state.moving || programRuns)) {
        stop.reason = Reason::NotStopped;
        journal_.add(Severity::Error,
                     state.moving
                         ? tr("Not stopped: the arm is still moving (%1). Press STOP again.").arg(cause)
                         : tr("Not stopped: a program is still running (%1). Press STOP again.").arg(cause));
    } else {
        journal_.add(Severity::Warning,
                     tr("Stopped: %1 (%2)").arg(cause, texts::unmeasuredText(stop.reason)));
    }
}

void RobotSession::reportExternalProgram() {
    const SessionState& state = d_->state;
    // Tiller's own program also stops or pauses after a loss of control. Only a program that plays without
    // control belongs to another client.
    const bool runs = state.isFresh() && !d_->takingControl && state.foreignProgramRuns() &&
                      !state.programAbandoned &&
                      (!d_->mayOwnProgramRun() || d_->externalRunSeen || d_->isReplaced()) &&
                      (state.runtimeState == RuntimeState::Playing || d_->externalRunSeen);
    if (!state.foreignProgramRuns() && !freeProgram()) {
        d_->changesConfirmed = false;
    }
    d_->takeoverReported = d_->takeoverReported && state.control != ControlState::InControl;
    if (!state.isFresh()) {
        return;
    }
    reportEndOfExternalProgram(runs || (d_->externalExists && state.runtimeState == RuntimeState::Paused &&
                                        state.control != ControlState::InControl));
    if (runs == d_->externalRunSeen) {
        return;
    }
    d_->externalRunSeen = runs;
    if (runs) {
        // Report a takeover only for the first program after a loss of control. The loss is detected only
        // after the control program has not responded for some time.
        constexpr std::int64_t kKnownLate = 3 * kNsPerSecond / 2;
        const std::int64_t nowNs = d_->clock->nowNs();
        const std::int64_t agoNs = d_->startedNs ? nowNs - *d_->startedNs : 0;
        d_->externalSinceNs = nowNs;
        if (d_->isTakenOver() && !std::exchange(d_->takeoverReported, true)) {
            journal_.addLate(Severity::Warning,
                             tr("A program from another client has taken over the robot, and control was "
                                "lost. Taking control again ends that program."),
                             Origin::Robot, agoNs <= kKnownLate ? agoNs : 0);
        } else {
            journal_.add(Severity::Info, tr("A program from another client is running on the robot."),
                         Origin::Robot, d_->unknownStartText());
        }
    } else if (state.runtimeState == RuntimeState::Paused && state.control != ControlState::InControl) {
        journal_.add(Severity::Info, tr("The program on the robot is paused."), Origin::Robot);
    }
}

void RobotSession::reportReplacement() {
    // A program start is reported by controller messages and by the robot data, at most this time apart.
    constexpr std::int64_t kSameStart = kNsPerSecond / 2;
    // A client that sends a program for each cycle would fill the log.
    constexpr std::int64_t kAtMostEvery = 2 * kNsPerSecond;
    const std::int64_t nowNs = d_->clock->nowNs();
    const bool isStopping = d_->link->foreignStop->isPending() || d_->link->foreignStop->isMeasuring();
    if (!d_->externalRunSeen || d_->takingControl || isStopping || nowNs - d_->externalSinceNs < kSameStart ||
        (d_->replacementNs && nowNs - *d_->replacementNs < kAtMostEvery)) {
        return;
    }
    d_->replacementNs = nowNs;
    journal_.add(Severity::Info, tr("A program from another client has replaced the running program."),
                 Origin::Robot);
}

void RobotSession::reportEndOfExternalProgram(bool exists) {
    // A client that sends a program for each cycle would fill the log with the end of each program.
    constexpr std::int64_t kEndedNs = 2 * kNsPerSecond;
    const std::int64_t nowNs = d_->clock->nowNs();
    if (exists) {
        d_->externalExists = true;
        d_->externalEndNs.reset();
    } else if (std::exchange(d_->externalExists, false)) {
        d_->externalEndNs = nowNs;
    }
    if (d_->externalEndNs && nowNs - *d_->externalEndNs >= kEndedNs && !d_->takingControl) {
        const std::int64_t endNs = *std::exchange(d_->externalEndNs, std::nullopt);
        if (d_->state.control != ControlState::InControl) {
            journal_.addLate(Severity::Info, tr("The program from the other client has ended."),
                             Origin::Robot, nowNs - endNs);
        }
    }
}

bool RobotSession::mustAskBeforeChange() const {
    const SessionState& state = d_->state;
    return (freeProgram() || (state.foreignProgramRuns() && !state.programAbandoned)) &&
           !d_->changesConfirmed && isSignalConnected(QMetaMethod::fromSignal(&RobotSession::changeQuestion));
}

bool RobotSession::asksBeforeChange(const QString& what, const std::function<void()>& change) {
    if (!mustAskBeforeChange()) {
        return false;
    }
    Q_EMIT changeQuestion(what, change);
    return true;
}

void RobotSession::confirmChanges(bool confirmed) {
    d_->changesConfirmed = confirmed && (d_->state.foreignProgramRuns() || freeProgram());
}

void RobotSession::reportControllerMessages() {
    using script::MessageKind;
    script::PrimaryClient& primary = *d_->link->primary;
    script::MessageLimiter& limiter = d_->link->messageLimiter;
    const std::int64_t now = d_->clock->nowNs();
    std::vector<script::ControllerMessage> messages = primary.takeMessages();
    limiter.limit(messages, now);
    limiter.setDropped(primary.droppedMessages());
    if (const std::uint64_t removed = limiter.takeRemoved(now); removed > 0) {
        journal_.add(Severity::Warning,
                     tr("The robot is sending too many messages. %n messages were not shown.", nullptr,
                        static_cast<int>(std::min<std::uint64_t>(removed, std::numeric_limits<int>::max()))));
    }
    for (const script::ControllerMessage& m : messages) {
        Q_EMIT controllerMessage(m);
        if (m.kind == MessageKind::Key && m.title.endsWith(QLatin1String("STARTED"))) {
            d_->startedProgram = m.text;
            d_->startedNs = now;
            d_->programNode.clear();
            reportReplacement();
            d_->changesConfirmed =
                false;  // a new program may have replaced the confirmed program without a stop
        }
        const Severity severity = m.severity >= script::MessageSeverity::Violation ? Severity::Error
                                  : m.severity == script::MessageSeverity::Warning ? Severity::Warning
                                                                                   : Severity::Info;
        switch (m.kind) {
            case MessageKind::ProgramLabel:
                d_->programNode = m.text;
                break;
            case MessageKind::Text:
                journal_.add(severity, tr("Program: %1").arg(m.text), Origin::Robot);
                break;
            case MessageKind::ErrorCode: {
                const CodeWords words = controllerCode(m.code);
                journal_.add(severity, codeTitle(m, words), Origin::Robot,
                             words.meaning + QLatin1Char(' ') + words.action);
                break;
            }
            case MessageKind::RuntimeException:
                journal_.add(
                    Severity::Error,
                    tr("Program error on line %1, column %2: %3").arg(m.line).arg(m.column).arg(m.text),
                    Origin::Robot);
                break;
            case MessageKind::Popup:
                journal_.add(severity, tr("Popup on the robot: %1 %2").arg(m.title, m.text).trimmed(),
                             Origin::Robot);
                break;
            case MessageKind::RequestValue:
                journal_.add(Severity::Warning,
                             tr("The program on the robot is waiting for a response on the teach pendant: %1")
                                 .arg(m.text),
                             Origin::Robot);
                break;
            default:
                break;
        }
    }
}

}  // namespace tiller

#include "moc_robot_session.cpp"
