// SPDX-License-Identifier: MIT
#include "robot/control/detail/control_program.h"

#include <QRandomGenerator>
#include <algorithm>
#include <optional>

#include "robot/core/wait_until.h"
#include "robot/script/script_client.h"

namespace tiller::control {

using std::chrono::milliseconds;

namespace {

/// Version text; omits the bugfix number if it is 0, e.g. "5.4", "5.25.1".
QString shortVersionText(const SoftwareVersion& version) {
    const QString both = QStringLiteral("%1.%2").arg(version.major).arg(version.minor);
    return version.bugfix > 0 ? both + QStringLiteral(".%1").arg(version.bugfix) : both;
}

}  // namespace

ControlProgram::ControlProgram(const ControllerOptions& options, ControlLoop& loop, const ControlLink& link,
                               RequestChannel& requests)
    : options_(options)
    , loop_(loop)
    , link_(link)
    , requests_(requests)
    , arm_(ArmLimits::of(robotModel(options.model))) {}

std::int32_t ControlProgram::newSession() {
    return static_cast<std::int32_t>(QRandomGenerator::system()->bounded(1, 0x7fffffff));
}

Result<void> ControlProgram::listen(const SoftwareVersion& version, const Deadline& deadline) {
    script::PrimaryClientOptions listening;
    listening.host = options_.host;
    listening.port = primaryPort();
    listening.clock = options_.clock;
    listening.reconnect = false;
    auto listener = std::make_unique<script::PrimaryClient>(listening);
    listener->start();
    if (auto heard = listener->waitForState(deadline); !heard) {
        return heard;
    }
    ArmLimits limits = ArmLimits::of(robotModel(options_.model));
    if (const auto reported = listener->configuration()) {
        // The robot reports its type, but not the torque limits of its joints.
        const auto model = robotModelByType(reported->robotType, version.isCb3());
        limits = ArmLimits::of(robotModel(model.value_or(options_.model)), *reported);
    }
    const std::lock_guard lock(guard_);
    arm_ = limits;
    version_ = version;
    refused_.clear();
    primary_ = std::move(listener);
    return {};
}

void ControlProgram::stopListening() {
    std::unique_ptr<script::PrimaryClient> listener;
    const std::lock_guard lock(guard_);
    listener = std::move(primary_);
}

SoftwareVersion ControlProgram::version() const {
    const std::lock_guard lock(guard_);
    return version_;
}

ArmLimits ControlProgram::arm() const {
    const std::lock_guard lock(guard_);
    return arm_;
}

Result<void> ControlProgram::needs(const SoftwareVersion& eSeries, const SoftwareVersion& cb3,
                                   const QString& context, const SoftwareVersion& polyScopeX) const {
    const SoftwareVersion has = version();
    const bool ownOfX = polyScopeX.major > 0;
    const SoftwareVersion& least = has.isCb3() ? cb3 : has.isPolyScopeX() && ownOfX ? polyScopeX : eSeries;
    if (least.major > 0 && has >= least) {
        return {};
    }
    QString since = QStringLiteral("not available on this controller series");
    if (least.major > 0) {
        since = QStringLiteral("%1 or newer is required").arg(shortVersionText(has.isCb3() ? cb3 : eSeries));
        since += ownOfX ? QStringLiteral(", on PolyScope X %1").arg(shortVersionText(polyScopeX)) : QString();
    }
    return Error{
        ErrorCode::VersionUnsupported, context,
        QStringLiteral("software %1.%2.%3: %4").arg(has.major).arg(has.minor).arg(has.bugfix).arg(since)};
}

Result<void> ControlProgram::knows(const char* name, const QString& context) const {
    const SoftwareVersion has = version();
    const std::lock_guard lock(guard_);
    if (!refused_.contains(QLatin1String(name))) {
        return {};
    }
    return Error{ErrorCode::VersionUnsupported, context,
                 QStringLiteral("software %1.%2.%3 does not provide %4")
                     .arg(has.major)
                     .arg(has.minor)
                     .arg(has.bugfix)
                     .arg(QLatin1String(name))};
}

// A controller refuses a program that contains a function removed from the language. After such an error, the
// program is sent again without the function.
Result<void> ControlProgram::upload(std::int32_t session, const QString& section, const Deadline& deadline) {
    for (;;) {
        auto sent = uploadOnce(session, section, deadline);
        if (sent || sent.error().code != ErrorCode::ScriptError) {
            return sent;
        }
        const QString name = refusedName(sent.error().controllerMessage);
        const std::lock_guard lock(guard_);
        if (name.isEmpty() || refused_.contains(name)) {
            return sent;
        }
        refused_.append(name);
    }
}

std::chrono::milliseconds ControlProgram::abandonedAfter() const {
    // A delivered program is a node of the operator's program, which continues after this node.
    return options_.deliver
               ? kNeverAbandoned
               : std::max({kMinAbandonedAfter, options_.dataTimeout, options_.connectionTimeout});
}

Result<void> ControlProgram::uploadOnce(std::int32_t session, const QString& section,
                                        const Deadline& deadline) {
    const QString context =
        QStringLiteral("start the control program at %1:%2").arg(options_.host).arg(primaryPort());
    QStringList without;
    {
        const std::lock_guard lock(guard_);
        without = refused_;
    }
    const ControlScript script = controlScript(version(), options_.registers, session, options_.limits, arm(),
                                               section, without, options_.force, abandonedAfter());
    {
        const std::lock_guard lock(guard_);
        primary_->takeMessages();  // discard earlier messages
        script_ = script;
        own_ = {};
    }
    session_ = session;
    // Stay connected until the program responds, because a controller may discard a program whose sender
    // disconnects at once.
    std::optional<script::ScriptClient> sender;
    if (options_.deliver) {
        if (auto delivered = options_.deliver(script.text, deadline); !delivered) {
            return delivered;
        }
    } else {
        sender.emplace(options_.host, primaryPort());
        if (auto connected = sender->connect(deadline); !connected) {
            return connected;
        }
        if (auto sent = sender->send(script.text, deadline); !sent) {
            return sent;
        }
    }
    return options_.awaitProgram ? awaitControl(deadline, context) : Result<void>();
}

Result<void> ControlProgram::awaitControl(const Deadline& deadline, const QString& context) {
    Error bad;
    const auto settled = [&] {
        if (loop_.isInControl()) {
            return true;
        }
        bad = complaint(context);
        if (bad.code == ErrorCode::None && !link_.isRunning()) {
            bad = {ErrorCode::LinkLost, context, QStringLiteral("the RTDE connection was lost")};
        }
        return bad.code != ErrorCode::None;
    };
    if (!waitUntil(deadline, settled)) {
        bad = {deadline.isCancelled() ? ErrorCode::Cancelled : ErrorCode::Timeout, context,
               QStringLiteral("The program was sent, but it does not respond. Check that the robot is in "
                              "Remote control and that it accepts scripts on this port.")};
    }
    return bad.code == ErrorCode::None ? Result<void>() : bad;
}

Result<void> ControlProgram::end(ControlLoss loss, const Deadline& deadline) {
    const QString context = QStringLiteral("end the control program");
    loop_.requestEnd(loss);
    const bool ended = waitUntil(deadline, [this] {
        return !link_.isRunning() ||
               (!loop_.isInControl() && loop_.status().runtimeState != RuntimeState::Playing);
    });
    if (!ended) {
        return Error{deadline.isCancelled() ? ErrorCode::Cancelled : ErrorCode::Timeout, context,
                     QStringLiteral("the program is still running")};
    }
    return link_.isRunning() ? Result<void>() : Error{ErrorCode::LinkLost, context, {}};
}

Result<void> ControlProgram::restart(const QString& section, const QString& name, const Deadline& deadline) {
    const QString context = QStringLiteral("send the control program again");
    if (!link_.isRunning()) {
        return Error{ErrorCode::NotInControl, context, {}};
    }
    if (auto ended = end(ControlLoss::Taking, deadline); !ended) {
        loop_.abandonTaking();
        return ended;
    }
    {
        const std::lock_guard lock(guard_);
        sectionName_ = name;
    }
    requests_.forget();
    return sendAgain(section, deadline);
}

Result<void> ControlProgram::resend(const Deadline& deadline) {
    requests_.forget();
    return sendAgain({}, deadline);
}

Result<void> ControlProgram::sendAgain(const QString& section, const Deadline& deadline) {
    const std::int32_t next = newSession();
    loop_.expectSession(next);
    auto sent = upload(next, section, deadline);
    if (!sent) {
        // If the robot starts the program later, the program must end.
        loop_.requestEnd(ControlLoss::ScriptStopped);
        loop_.abandonTaking();
    }
    return sent;
}

void ControlProgram::yieldTo(const script::SupervisedProgram& program) {
    complaint({});  // discard earlier errors
    const std::lock_guard lock(guard_);
    own_ = program;
    sectionName_ = QString();
    scriptFeedback_ = {.name = program.name};
}

void ControlProgram::ScriptFeedback::take(const script::ControllerMessage& message) {
    if (message.title.endsWith(QLatin1String("STARTED"))) {
        if (!started) {
            started = name.isEmpty() || message.text == name;
            startedAs = message.text;
        } else if (message.text != startedAs) {
            stopped = true;  // a controller runs one program at a time
        }
    } else if (message.title.endsWith(QLatin1String("STOPPED"))) {
        stopped = stopped || (name.isEmpty() ? started && message.text == startedAs : message.text == name);
    }
}

Error ControlProgram::complaint(const QString& context) {
    constexpr int kReadOnlySocket = 210;
    const std::lock_guard lock(guard_);
    if (!primary_) {
        return {};
    }
    for (const auto& message : primary_->takeMessages()) {
        if (message.kind == script::MessageKind::Key) {
            scriptFeedback_.take(message);
        }
        if (message.kind == script::MessageKind::RuntimeException) {
            const QString place = message.line > 0 ? placeOf(message.line, message.column) + ": " : "";
            const QString name = sectionName_.isEmpty() ? QString() : sectionName_ + QLatin1Char(' ');
            const bool ours = place.contains(QLatin1String(".script line "));
            QString text = message.text;
            if (const int line = own_.lineOf(message.line); !own_.text.isEmpty() && line > 0) {
                // A syntax error repeats its line number in the text.
                text.replace(QStringLiteral("on_line:%1:").arg(message.line),
                             QStringLiteral("on_line:%1:").arg(line));
            }
            return {ErrorCode::ScriptError, context, (ours ? QString() : name) + place + text};
        }
        if (message.kind == script::MessageKind::ErrorCode && message.code == kReadOnlySocket) {
            return {ErrorCode::RemoteControlRequired, context,
                    message.text.isEmpty() ? message.codeName() : message.text};
        }
    }
    return {};
}

// Requires `guard_`.
QString ControlProgram::placeOf(int line, int column) const {
    if (own_.text.isEmpty()) {
        return script_.place(line, column);
    }
    const int inOwn = own_.lineOf(line);
    return inOwn > 0 ? QStringLiteral("line %1").arg(inOwn) : QStringLiteral("watchdog thread");
}

std::uint64_t ControlProgram::statesReceived() const {
    const std::lock_guard lock(guard_);
    return primary_ ? primary_->state().packages : 0;
}

ControlProgram::ScriptFeedback ControlProgram::scriptFeedback() const {
    const std::lock_guard lock(guard_);
    return scriptFeedback_;
}

}  // namespace tiller::control
