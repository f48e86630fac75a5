// SPDX-License-Identifier: MIT
#include "robot/control/programs.h"

#include <QRegularExpression>
#include <algorithm>
#include <optional>

#include "robot/control/detail/controller_private.h"
#include "robot/control/detail/script_body.h"
#include "robot/core/wait_until.h"
#include "robot/script/script_client.h"
#include "robot/script/supervised_program.h"

namespace tiller::control {

using std::chrono::milliseconds;

namespace {

/// Heartbeat registers for a program that replaces the control program.
script::Heartbeat heartbeatOf(const Controller::Private& d, MotionId run, const ScriptTerms& terms) {
    const int first = firstRegister(d.options.registers);
    script::Heartbeat heartbeat;
    heartbeat.number = first;
    heartbeat.session = {first + kSessionRegister, d.program.session()};
    heartbeat.lastEpoch = {first + kEpochRegister, static_cast<std::int32_t>(run)};
    heartbeat.expired = {first + kStateRegister, static_cast<std::int32_t>(ScriptState::HeartbeatExpired)};
    heartbeat.timeout = kHoldTime;
    if (terms.gate) {
        heartbeat.gate = {first + kChoiceRegister, first + kWholeRegister, first, terms.variables};
    }
    return heartbeat;
}

Error stopped(const QString& context) {
    return {ErrorCode::Stopped, context, QStringLiteral("interrupted by a stop or another motion")};
}

/// Ends a running user script and takes control again. Requires `taking`.
/// hasEnded  the end of the script was observed
/// regains   if false, the script is only ended
Result<void> bringBack(Controller::Private& d, bool hasEnded, bool regains) {
    // A separate deadline that only release() can shorten, because the script must not continue after an
    // error.
    const Deadline deadline = Deadline::after(milliseconds(5000));
    const UnderWay cancellable(d, deadline);
    const auto plays = [&d] { return d.loop.status().runtimeState == RuntimeState::Playing; };
    const auto isOver = [&] { return !d.link.isRunning() || !plays(); };
    // If the script has ended and a program still runs or is paused, that program belongs to another client
    // and must not be stopped.
    const auto isStopped = [&] {
        return !d.link.isRunning() || d.loop.status().runtimeState == RuntimeState::Stopped;
    };
    if (hasEnded && !isStopped() &&
        !waitUntil(Deadline::after(milliseconds(500), deadline.token()), isStopped)) {
        d.loop.abandonTaking();
        return Error{ErrorCode::NotInControl, QStringLiteral("run a script"),
                     QStringLiteral("a program from another client replaced the script")};
    }
    bool isStopSent = true;
    if (!d.link.isRunning() || plays()) {
        script::ScriptClient client(d.options.host, d.program.primaryPort());
        auto connected = client.connect(Deadline::after(milliseconds(1000), deadline.token()));
        if (!connected && deadline.isCancelled()) {
            connected = client.connect(Deadline::after(milliseconds(100)));
        }
        if (connected) {
            connected = client.send(QStringLiteral("stop program\n"), Deadline::after(milliseconds(100)));
        }
        isStopSent = connected.ok();
        // Wait for the end of the script. Otherwise, the stop could reach the robot after the start of the
        // control program and end that program.
        waitUntil(Deadline::after(milliseconds(500), deadline.token()), isOver);
    }
    if (!d.link.isRunning()) {
        return Error{
            ErrorCode::LinkLost, QStringLiteral("send the control program again"),
            isStopSent ? QString() : QStringLiteral("the script could not be stopped and may continue")};
    }
    if (!regains) {
        d.loop.abandonTaking();
        return {};
    }
    return d.program.resend(deadline);
}

/// A script that replaces the control program, and the epoch that must not change while it runs.
struct RunningScript {
    Motion motion;  ///< an ended motion if the script is unattended
    std::uint64_t epoch = 0;
    std::uint64_t played = 0;  ///< ControllerStatus::playing before the start
    bool hasEnded = false;     ///< the robot reported the end of the script
};

/// Permits the motion of a script during the lifetime of the object.
class ScriptPermission {
public:
    explicit ScriptPermission(Controller::Private& d) : d_(d) { d_.loop.permitScript(true); }
    ~ScriptPermission() { d_.loop.permitScript(false); }
    ScriptPermission(const ScriptPermission&) = delete;
    ScriptPermission& operator=(const ScriptPermission&) = delete;

private:
    Controller::Private& d_;
};

/// Starts the motion that represents the script, unless a stop has occurred since `epoch`.
Result<Motion> beginScript(Controller& controller, std::uint64_t epoch, const ScriptTerms& terms,
                           const QString& context) {
    auto& d = ControllerAccess::of(controller);
    MotionCommand command;
    command.kind = MotionCommand::Kind::Script;
    command.held = terms.holding == Holding::Held;
    setGateOf(command, terms.gate.value_or(script::StepGate{}));
    const MotionId id = d.mailbox.startAfter(epoch, command, d.now());
    if (id == kNoMotion) {
        return stopped(context);
    }
    const Motion motion = MotionAccess::make(controller, id, MotionKind::Script);
    if (terms.starting && !terms.starting(motion)) {
        motion.cancel(StopCause::Released);
    }
    return motion.isActive() ? Result<Motion>(motion) : stopped(context);
}

/// Waits for the start and then for the end of the script.
Result<void> watchScript(Controller::Private& d, RunningScript& run, const QString& context,
                         const Deadline& deadline) {
    const Deadline begun = Deadline::after(milliseconds(5000), deadline.token());
    std::optional<Deadline> messageDeadline;
    std::uint64_t statesAtEnd = 0;
    Error bad;
    const auto settled = [&] {
        // The message with the reason for the end arrives on another connection, possibly after the data that
        // report the end, but before the second robot state from now. The next state may have been sent
        // before the reason. The data that report the end may arrive after the message.
        const ControllerStatus now = d.loop.status();
        const bool receivedAll =
            messageDeadline &&
            (messageDeadline->hasExpired() ||
             (d.program.statesReceived() > statesAtEnd + 1 && now.runtimeState == RuntimeState::Stopped));
        bad = d.program.complaint(context);
        if (bad.code != ErrorCode::None || receivedAll) {
            return true;
        }
        if (!d.link.isRunning()) {
            bad = {ErrorCode::LinkLost, context, QStringLiteral("the script was ended")};
        } else if (deadline.hasExpired()) {
            bad = {deadline.isCancelled() ? ErrorCode::Cancelled : ErrorCode::Timeout, context,
                   QStringLiteral("the script was ended")};
        } else if (now.robotMode != RobotMode::Running || !allowsMotion(now.safetyMode)) {
            bad = {
                ErrorCode::UnsafeState, context,
                QStringLiteral("%1, %2").arg(robotModeName(now.robotMode), safetyModeName(now.safetyMode))};
        } else if (d.mailbox.epoch().current() != run.epoch) {
            const Result<void> ended = run.motion.wait(Deadline::after(milliseconds(0)));
            bad = ended ? stopped(context)
                        : Error{ended.error().code, context, ended.error().controllerMessage};
        }
        if (bad.code != ErrorCode::None) {
            return true;
        }
        // The data may not contain any packet in which a short program is playing. A paused program has not
        // ended. The count and the state must be from the same packet, because the state before the start is
        // also "stopped".
        const ControlProgram::ScriptFeedback heard = d.program.scriptFeedback();
        if (now.playing != run.played || heard.stopped) {
            const bool over = now.runtimeState == RuntimeState::Stopped;
            if (!messageDeadline && (over || heard.stopped)) {
                messageDeadline =
                    Deadline::after(std::min(milliseconds(500), deadline.remaining()), deadline.token());
                statesAtEnd = d.program.statesReceived();
            }
        } else if (begun.hasExpired() && !heard.started) {
            bad = {ErrorCode::Timeout, context,
                   QStringLiteral("the robot did not report that the script was running")};
        }
        return bad.code != ErrorCode::None;
    };
    // An expired deadline also ends the script. It is reported as an error below.
    waitUntil(Deadline::never(), settled);
    run.hasEnded = messageDeadline || d.program.scriptFeedback().stopped;
    if (bad.code == ErrorCode::None && d.loop.scriptState() == ScriptState::HeartbeatExpired) {
        bad = {ErrorCode::LinkLost, context,
               QStringLiteral("no heartbeat reached the robot for %1 ms, so the script was ended")
                   .arg(kHoldTime.count())};
    }
    return bad.code == ErrorCode::None ? Result<void>() : bad;
}

}  // namespace

Result<Motion> Programs::startFunction(const Text& name, const Text& body, const Deadline& start,
                                       Holding holding) {
    const QString context = QStringLiteral("start function %1").arg(name);
    static const QRegularExpression kName(QStringLiteral("^[A-Za-z_][A-Za-z0-9_]*$"));
    if (!kName.match(name).hasMatch()) {
        return Error{ErrorCode::InvalidArgument, context,
                     QStringLiteral("name: use letters, digits and _, and do not begin with a digit")};
    }
    if (body.trimmed().isEmpty()) {
        return Error{ErrorCode::InvalidArgument, context, QStringLiteral("body: the body is empty")};
    }
    if (body.contains(QLatin1String("tiller_"))) {
        return Error{
            ErrorCode::InvalidArgument, context,
            QStringLiteral("body: names beginning with tiller_ are reserved for the control program")};
    }
    if (const auto checked = checkBlocks(body, context); !checked) {
        return checked.error();
    }
    auto& d = ControllerAccess::of(*controller_);
    const std::uint64_t stops = d.mailbox.epoch().stops();
    if (const Error error = d.obstacle(context); error.code != ErrorCode::None) {
        return error;
    }
    const auto id = d.startSection(body, name, holding, milliseconds(0), stops, start, context);
    if (!id) {
        return id.error();
    }
    return MotionAccess::make(*controller_, *id, MotionKind::Function);
}

Result<void> Programs::runScript(const Text& program, const Deadline& deadline, Supervision supervision) {
    return runScript(program, deadline, ScriptTerms{.supervision = supervision});
}

Result<void> Programs::runScript(const Text& program, const Deadline& deadline, const ScriptTerms& terms) {
    const QString context = QStringLiteral("run a script");
    if (program.trimmed().isEmpty()) {
        return Error{ErrorCode::InvalidArgument, context, QStringLiteral("program: the program is empty")};
    }
    const bool attended = terms.supervision == Supervision::Heartbeat;
    if (attended && program.contains(QLatin1String(script::kHeartbeatPrefix))) {
        return Error{ErrorCode::InvalidArgument, context,
                     QStringLiteral("program: names beginning with %1 are reserved for the watchdog thread")
                         .arg(QLatin1String(script::kHeartbeatPrefix))};
    }
    if (!attended && terms.holding == Holding::Held) {
        return Error{ErrorCode::InvalidArgument, context,
                     QStringLiteral("holding: an unattended program does not support hold-to-run")};
    }
    if (!attended && terms.gate) {
        return Error{ErrorCode::InvalidArgument, context,
                     QStringLiteral("gate: an unattended program does not support a step gate")};
    }
    auto& d = ControllerAccess::of(*controller_);
    const std::uint64_t stops = terms.stops.value_or(d.mailbox.epoch().stops());
    if (const Error error = d.obstacle(context); error.code != ErrorCode::None) {
        return error;
    }
    const std::lock_guard lock(d.taking);
    const UnderWay cancellable(d, deadline);
    if (auto quiet = d.awaitPulses(stops, deadline, context); !quiet) {
        return quiet;
    }
    const std::uint64_t epoch = d.mailbox.stop(Brake{}, StopCause::Superseded, d.now());
    if (d.mailbox.epoch().stops() != stops) {
        return stopped(context);
    }
    // If the robot does not respond, the caller must not wait forever, even without a time limit for the
    // program.
    const Deadline start =
        Deadline::after(std::min(milliseconds(5000), deadline.remaining()), deadline.token());
    if (auto ended = d.program.end(ControlLoss::OwnScript, start); !ended) {
        return ended;
    }
    Result<void> outcome;
    bool hasEnded = false;
    {
        const ScriptPermission permission(d);
        script::ScriptClient client(d.options.host, d.program.primaryPort());
        outcome = client.connect(start);
        if (outcome && d.mailbox.epoch().current() != epoch) {
            outcome = stopped(context);
        }
        RunningScript run;
        run.epoch = epoch;
        if (outcome && attended) {
            const Result<Motion> motion = beginScript(*controller_, epoch, terms, context);
            run.motion = motion ? *motion : Motion();
            run.epoch = run.motion.id();
            outcome = motion ? Result<void>() : motion.error();
        }
        if (outcome) {
            const script::SupervisedProgram sent =
                attended
                    ? script::supervised(program, heartbeatOf(d, run.motion.id(), terms), d.program.version())
                    : script::unsupervised(program);
            d.program.yieldTo(sent);
            run.played = d.loop.status().playing;
            outcome = client.send(sent.text, start);
        }
        if (outcome) {
            outcome = watchScript(d, run, context, deadline);
            hasEnded = run.hasEnded;
        }
        run.motion.cancel(outcome ? StopCause::Completed : StopCause::ControlLost);
    }
    if (outcome && terms.regainsControl && !terms.regainsControl()) {
        d.loop.abandonTaking();
        return outcome;
    }
    const bool regains = terms.regainsAfterDataGap || outcome || outcome.error().code != ErrorCode::LinkLost;
    if (auto back = bringBack(d, hasEnded, regains); !back) {
        if (outcome) {
            return back;
        }
        Error error = outcome.error();
        error.controllerMessage +=
            QStringLiteral("; control could not be regained: ") + back.error().toString();
        return error;
    }
    return outcome;
}

Result<void> Programs::endControlProgram(const Deadline& deadline) {
    auto& d = ControllerAccess::of(*controller_);
    const std::lock_guard lock(d.taking);
    const UnderWay cancellable(d, deadline);
    d.mailbox.stop(Brake{}, StopCause::ControlLost, d.now());
    return d.link.isRunning() ? d.program.end(ControlLoss::Released, deadline) : Result<void>();
}

Result<void> Programs::reupload(const Deadline& deadline) {
    auto& d = ControllerAccess::of(*controller_);
    {
        const std::lock_guard lock(d.taking);
        if (d.link.isRunning()) {
            const UnderWay cancellable(d, deadline);
            d.mailbox.stop(Brake{}, StopCause::Superseded, d.now());
            return d.program.restart({}, {}, deadline);
        }
    }
    return controller_->takeControl(deadline);
}

bool Programs::isProgramRunning() const {
    auto& d = ControllerAccess::of(*controller_);
    return d.link.isRunning() && d.loop.status().runtimeState == RuntimeState::Playing;
}

QString Programs::controlProgram(const SoftwareVersion& version, RegisterRange registers) {
    const ArmLimits arm = ArmLimits::of(robotModel(ControllerOptions().model));
    return controlScript(version, registers, ControlProgram::newSession(), {}, arm).text;
}

}  // namespace tiller::control
