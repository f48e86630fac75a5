// SPDX-License-Identifier: MIT
#include "robot/control/programs.h"

#include <QRegularExpression>
#include <algorithm>
#include <thread>

#include "robot/control/detail/controller_private.h"

namespace tiller::control {

using std::chrono::milliseconds;

namespace {

Error overdue(const Deadline& deadline, const QString& context, const QString& what) {
    return {deadline.isCancelled() ? ErrorCode::Cancelled : ErrorCode::Timeout, context, what};
}

/// What the controller calls this program in its messages.
QString scriptName(const QString& program) {
    static const QRegularExpression kDefinition(QStringLiteral("^[ \\t]*def[ \\t]+(\\w+)"),
                                                QRegularExpression::MultilineOption);
    return kDefinition.match(program).captured(1);
}

Error stopped(const QString& context) {
    return {ErrorCode::Stopped, context, QStringLiteral("a stop or another motion came in between")};
}

}  // namespace

Result<void> Controller::Private::endProgram(ControlLoss loss, const Deadline& deadline) {
    const QString context = QStringLiteral("end the control program");
    loop.requestEnd(loss);
    while (running && (loop.isInControl() || loop.status().runtimeState == RuntimeState::Playing)) {
        if (deadline.hasExpired()) {
            return overdue(deadline, context, QStringLiteral("it goes on"));
        }
        std::this_thread::sleep_for(milliseconds(1));
    }
    return running ? Result<void>() : Error{ErrorCode::LinkLost, context, {}};
}

Result<void> Controller::Private::restart(const QString& section, const QString& name,
                                          const Deadline& deadline) {
    const QString context = QStringLiteral("send the control program again");
    if (!running) {
        return Error{ErrorCode::NotInControl, context, {}};
    }
    if (auto ended = endProgram(ControlLoss::Taking, deadline); !ended) {
        return ended;
    }
    {
        const std::lock_guard lock(arm);
        sectionName = name;
    }
    {
        const std::lock_guard lock(requesting);
        stored = {};
    }
    const std::int32_t next = newSession();
    loop.expectSession(next);
    return upload(next, section, deadline);
}

Result<MotionId> Controller::Private::startSection(const QString& section, const QString& name,
                                                   Holding holding, milliseconds silence, std::uint64_t stops,
                                                   const Deadline& deadline, const QString& context) {
    const std::lock_guard lock(taking);
    const UnderWay cancellable(*this, deadline);
    if (!loop.isInControl()) {
        return Error{ErrorCode::NotInControl, context, {}};
    }
    // Braking first, and nothing that is stopped from here on may begin.
    const std::uint64_t epoch = mailbox.stop(Brake{}, StopCause::Superseded, now());
    if (mailbox.epoch().stops() != stops) {
        return stopped(context);
    }
    if (auto sent = restart(section, name, deadline); !sent) {
        Error error = sent.error();
        error.context = context;
        // A section that does not compile must not cost the control.
        if (error.code == ErrorCode::ScriptError) {
            if (auto back = restart({}, {}, deadline); !back) {
                error.controllerMessage +=
                    QStringLiteral("; and control did not come back: ") + back.error().toString();
            }
        }
        return error;
    }
    MotionCommand command;
    command.kind = MotionCommand::Kind::Program;
    command.program = static_cast<std::int32_t>(ScriptCommand::Section);
    command.held = holding == Holding::Held;
    command.silence = silence;
    const MotionId id = mailbox.startAfter(epoch, command, now());
    if (id == kNoMotion) {
        return stopped(context);
    }
    if (!loop.confirmControl()) {
        mailbox.end(id, StopCause::ControlLost, now());
        return Error{ErrorCode::NotInControl, context, {}};
    }
    return id;
}

Result<Motion> Programs::startFunction(const Text& name, const Text& body, const Deadline& start,
                                       Holding holding) {
    const QString context = QStringLiteral("start function %1").arg(name);
    static const QRegularExpression kName(QStringLiteral("^[A-Za-z_][A-Za-z0-9_]*$"));
    if (!kName.match(name).hasMatch()) {
        return Error{ErrorCode::InvalidArgument, context,
                     QStringLiteral("name: letters, digits and _, not beginning with a digit")};
    }
    if (body.trimmed().isEmpty()) {
        return Error{ErrorCode::InvalidArgument, context, QStringLiteral("body: it is empty")};
    }
    if (body.contains(QLatin1String("tiller_"))) {
        return Error{ErrorCode::InvalidArgument, context,
                     QStringLiteral("body: names beginning with tiller_ are the control program's own")};
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

Result<void> Controller::Private::bringBack() {
    // Its own time, which only release() may cut short: whatever ended the script, it must not go on.
    const Deadline deadline = Deadline::after(milliseconds(5000));
    const UnderWay cancellable(*this, deadline);
    const auto plays = [this] { return loop.status().runtimeState == RuntimeState::Playing; };
    bool told = true;
    if (!running || plays()) {
        script::ScriptClient client(options.host, primaryPort());
        auto connected = client.connect(Deadline::after(milliseconds(1000), deadline.token()));
        if (!connected && deadline.isCancelled()) {
            connected = client.connect(Deadline::after(milliseconds(100)));
        }
        if (connected) {
            connected = client.send(QStringLiteral("stop program\n"), Deadline::after(milliseconds(100)));
        }
        told = connected.ok();
        // It must not reach the robot after the control program.
        const Deadline ended = Deadline::after(milliseconds(500), deadline.token());
        while (running && plays() && !ended.hasExpired()) {
            std::this_thread::sleep_for(milliseconds(1));
        }
    }
    if (!running) {
        return Error{ErrorCode::LinkLost, QStringLiteral("send the control program again"),
                     told ? QString() : QStringLiteral("the script could not be stopped and may go on")};
    }
    const std::int32_t next = newSession();
    {
        const std::lock_guard again(requesting);
        stored = {};
    }
    loop.expectSession(next);
    return upload(next, {}, deadline);
}

Result<void> Programs::runScript(const Text& program, const Deadline& deadline) {
    const QString context = QStringLiteral("run a script");
    if (program.trimmed().isEmpty()) {
        return Error{ErrorCode::InvalidArgument, context, QStringLiteral("program: it is empty")};
    }
    auto& d = ControllerAccess::of(*controller_);
    const std::uint64_t stops = d.mailbox.epoch().stops();
    if (const Error error = d.obstacle(context); error.code != ErrorCode::None) {
        return error;
    }
    const std::lock_guard lock(d.taking);
    const UnderWay cancellable(d, deadline);
    const std::uint64_t epoch = d.mailbox.stop(Brake{}, StopCause::Superseded, d.now());
    if (d.mailbox.epoch().stops() != stops) {
        return stopped(context);
    }
    if (auto ended = d.endProgram(ControlLoss::OwnScript, deadline); !ended) {
        return ended;
    }
    d.complaint(context);  // what was said before is not about this script
    {
        const std::lock_guard arm(d.arm);
        d.program = {};
        d.program.sectionLine = 1;
        d.program.sectionLines = static_cast<int>(program.count(QLatin1Char('\n'))) + 1;
        d.sectionName = QString();
        d.heardScript = {scriptName(program), false, false};
    }
    const std::uint64_t played = d.loop.playing();
    Result<void> outcome;
    {
        script::ScriptClient client(d.options.host, d.primaryPort());
        outcome = client.connect(deadline);
        if (outcome && d.mailbox.epoch().current() != epoch) {
            outcome = stopped(context);
        }
        if (outcome) {
            outcome = client.send(program, deadline);
        }
        if (outcome) {
            outcome = d.watchScript(epoch, played, context, deadline);
        }
    }
    if (auto back = d.bringBack(); !back) {
        if (outcome) {
            return back;
        }
        Error error = outcome.error();
        error.controllerMessage +=
            QStringLiteral("; and control did not come back: ") + back.error().toString();
        return error;
    }
    return outcome;
}

// Until the script has ended. It has to begin before its end means anything.
Result<void> Controller::Private::watchScript(std::uint64_t epoch, std::uint64_t played,
                                              const QString& context, const Deadline& deadline) {
    const Deadline begun = Deadline::after(milliseconds(5000), deadline.token());
    std::optional<Deadline> told;
    std::uint64_t statesAtEnd = 0;
    for (;;) {
        // Why it ended is told on another connection, a little later, but before the state after next: the
        // first to come may have been under way.
        const bool heardAll = told && (told->hasExpired() || statesHeard() > statesAtEnd + 1);
        if (const Error bad = complaint(context); bad.code != ErrorCode::None) {
            return bad;
        }
        if (heardAll) {
            return {};
        }
        if (!running) {
            return Error{ErrorCode::LinkLost, context, QStringLiteral("the script was ended")};
        }
        if (mailbox.epoch().current() != epoch) {
            return stopped(context);
        }
        if (deadline.hasExpired()) {
            return overdue(deadline, context, QStringLiteral("the script was ended"));
        }
        const ControllerStatus now = loop.status();
        if (now.robotMode != RobotMode::Running || !allowsMotion(now.safetyMode)) {
            return Error{
                ErrorCode::UnsafeState, context,
                QStringLiteral("%1, %2").arg(robotModeName(now.robotMode), safetyModeName(now.safetyMode))};
        }
        // The shortest ones play in no package; a paused one has not ended.
        const ScriptHeard heard = scriptHeard();
        if (loop.playing() != played || heard.stopped) {
            const bool over = now.runtimeState == RuntimeState::Stopped;
            if (!told && (over || heard.stopped)) {
                told = Deadline::after(std::min(milliseconds(500), deadline.remaining()), deadline.token());
                statesAtEnd = statesHeard();
            }
        } else if (begun.hasExpired() && !heard.started) {
            return Error{ErrorCode::Timeout, context, QStringLiteral("it was never seen running")};
        }
        std::this_thread::sleep_for(milliseconds(1));
    }
}

Result<void> Programs::endControlProgram(const Deadline& deadline) {
    auto& d = ControllerAccess::of(*controller_);
    const std::lock_guard lock(d.taking);
    const UnderWay cancellable(d, deadline);
    d.mailbox.stop(Brake{}, StopCause::ControlLost, d.now());
    return d.running ? d.endProgram(ControlLoss::Released, deadline) : Result<void>();
}

Result<void> Programs::reupload(const Deadline& deadline) {
    auto& d = ControllerAccess::of(*controller_);
    {
        const std::lock_guard lock(d.taking);
        if (d.running) {
            const UnderWay cancellable(d, deadline);
            d.mailbox.stop(Brake{}, StopCause::Superseded, d.now());
            return d.restart({}, {}, deadline);
        }
    }
    return controller_->takeControl(deadline);
}

bool Programs::isProgramRunning() const {
    auto& d = ControllerAccess::of(*controller_);
    return d.running && d.loop.status().runtimeState == RuntimeState::Playing;
}

QString Programs::controlProgram(const SoftwareVersion& version, RegisterRange registers) {
    const ArmLimits arm = ArmLimits::of(robotModel(ControllerOptions().model));
    return controlScript(version, registers, Controller::Private::newSession(), {}, arm.maxSpeed).text;
}

}  // namespace tiller::control
