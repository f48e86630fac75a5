// SPDX-License-Identifier: MIT
#include "robot/control/programs.h"

#include <QRegularExpression>
#include <algorithm>
#include <thread>

#include "robot/control/controller_private.h"

namespace tiller::control {

using std::chrono::milliseconds;

namespace {

Error overdue(const Deadline& deadline, const QString& context, const QString& what) {
    return {deadline.isCancelled() ? ErrorCode::Cancelled : ErrorCode::Timeout, context, what};
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
    const std::int32_t session = newSession();
    loop.expectSession(session);
    return upload(session, section, deadline);
}

Result<MotionId> Controller::Private::startSection(const QString& section, const QString& name,
                                                   Holding holding, const Deadline& deadline,
                                                   const QString& context) {
    const std::lock_guard lock(taking);
    const UnderWay cancellable(*this, deadline);
    if (!loop.isInControl()) {
        return Error{ErrorCode::NotInControl, context, {}};
    }
    // Braking first, and nothing that is stopped from here on may begin.
    const std::uint64_t epoch = mailbox.stop(Brake{}, StopCause::Superseded, now());
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
    const MotionId id = mailbox.startAfter(epoch, command, now());
    if (id == kNoMotion) {
        return Error{ErrorCode::Stopped, context, QStringLiteral("a stop or another motion came in between")};
    }
    return id;
}

Result<Motion> Programs::startFunction(const QString& name, const QString& body, const Deadline& start,
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
    if (const Error error = d.obstacle(context); error.code != ErrorCode::None) {
        return error;
    }
    const auto id = d.startSection(body, name, holding, start, context);
    if (!id) {
        return id.error();
    }
    return MotionAccess::make(*controller_, *id, MotionKind::Function);
}

Result<void> Programs::runScript(const QString& program, const Deadline& deadline) {
    const QString context = QStringLiteral("run a script");
    if (program.trimmed().isEmpty()) {
        return Error{ErrorCode::InvalidArgument, context, QStringLiteral("program: it is empty")};
    }
    auto& d = ControllerAccess::of(*controller_);
    if (const Error error = d.obstacle(context); error.code != ErrorCode::None) {
        return error;
    }
    const std::lock_guard lock(d.taking);
    const UnderWay cancellable(d, deadline);
    const std::uint64_t epoch = d.mailbox.stop(Brake{}, StopCause::Superseded, d.now());
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
    }
    script::ScriptClient client(d.options.host, d.primaryPort());
    Result<void> outcome = client.connect(deadline);
    if (outcome) {
        outcome = client.send(program, deadline);
    }
    // It has to begin before its end means anything; one that is over at once may never be seen playing.
    const Deadline begun =
        Deadline::after(std::min(milliseconds(1000), deadline.remaining()), deadline.token());
    bool seen = false;
    while (outcome) {
        if (const Error bad = d.complaint(context); bad.code != ErrorCode::None) {
            outcome = bad;
        } else if (!d.running) {
            return Error{ErrorCode::LinkLost, context, {}};
        } else if (d.mailbox.epoch().current() != epoch) {
            outcome = Error{ErrorCode::Stopped, context, {}};
        } else if (deadline.hasExpired()) {
            outcome = overdue(deadline, context, QStringLiteral("the script was ended"));
        } else {
            const bool plays = d.loop.status().runtimeState == RuntimeState::Playing;
            if ((seen && !plays) || (!seen && begun.hasExpired())) {
                break;
            }
            seen = seen || plays;
            std::this_thread::sleep_for(milliseconds(1));
        }
    }
    // A new program ends whatever runs, so this is the stop as well.
    const std::int32_t session = Controller::Private::newSession();
    {
        const std::lock_guard again(d.requesting);
        d.stored = {};
    }
    d.loop.expectSession(session);
    const Result<void> back = d.upload(session, {}, Deadline::after(milliseconds(5000)));
    return outcome ? back : outcome;
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

}  // namespace tiller::control
