// SPDX-License-Identifier: MIT
// The way into control, step by step, each with its own reason for not working.

#include <QRandomGenerator>
#include <algorithm>

#include "robot/control/detail/argument_check.h"
#include "robot/control/detail/control_script.h"
#include "robot/control/detail/controller_private.h"

namespace tiller::control {

using std::chrono::milliseconds;

namespace {

QString rangeText(RegisterRange range) {
    return range == RegisterRange::Upper ? QStringLiteral("upper (24-47)") : QStringLiteral("lower (0-23)");
}

RegisterRange other(RegisterRange range) {
    return range == RegisterRange::Upper ? RegisterRange::Lower : RegisterRange::Upper;
}

// Which registers, whose they are, and what the operator can do.
Error explainInUse(const Error& error, RegisterRange range) {
    const QString fieldbus =
        range == RegisterRange::Lower
            ? QStringLiteral("switch the fieldbus (EtherNet/IP, PROFINET) off on the robot, ")
            : QString();
    return {ErrorCode::RegisterInUse, QStringLiteral("take the %1 registers").arg(rangeText(range)),
            QStringLiteral("%1. End the program that owns it, %2or use the %3 registers.")
                .arg(error.context, fieldbus, rangeText(other(range)))};
}

Error explainUnknown(const QString& context, RegisterRange range) {
    const QString advice = range == RegisterRange::Upper
                               ? QStringLiteral("use the lower (0-23) registers with this software")
                               : QStringLiteral("this software is too old to be controlled over RTDE");
    return {ErrorCode::FieldUnknown, context,
            QStringLiteral("The controller has no %1 registers: %2.").arg(rangeText(range), advice)};
}

}  // namespace

Result<void> Controller::Private::take(const Deadline& deadline, bool join) {
    if (const Error error = checkLimits(options.limits, "take control"); error.code != ErrorCode::None) {
        return error;
    }
    loop.publishLoss(ControlLoss::Taking);
    if (auto opened = openRegisters(deadline); !opened) {
        return opened;
    }
    if (options.awaitProgram) {
        if (auto safe = checkModes(deadline); !safe) {
            return safe;
        }
    }
    std::optional<Echo> joined;
    if (join) {
        const auto found = findProgram(deadline);
        if (!found) {
            return found.error();
        }
        joined = *found;
    }
    if (auto heard = listen(deadline); !heard) {
        return heard;
    }
    const std::int32_t next = join ? joined->session : newSession();
    {
        // What was meant for the connection before must not reach this one.
        const std::lock_guard lock(requesting);
        stored = {};
        kick = false;
        wrench.take();
        startThread(next, join ? &*joined : nullptr);
    }
    if (join) {
        return awaitControl(deadline, QStringLiteral("join the control program at %1").arg(options.host));
    }
    return upload(next, {}, deadline);
}

// The primary interface: what the controller says about programs, and the arm's own dimensions.
Result<void> Controller::Private::listen(const Deadline& deadline) {
    script::PrimaryClientOptions listening;
    listening.host = options.host;
    listening.port = primaryPort();
    listening.clock = options.clock;
    listening.reconnect = false;
    auto listener = std::make_unique<script::PrimaryClient>(listening);
    listener->start();
    if (auto heard = listener->waitForState(deadline); !heard) {
        return heard;
    }
    ArmLimits limits = ArmLimits::of(robotModel(options.model));
    if (const auto told = listener->configuration()) {
        limits = {told->dh, told->minPosition, told->maxPosition, told->maxSpeed};
    }
    const std::lock_guard lock(arm);
    armLimits = limits;
    version = connection->version();
    refused.clear();
    primary = std::move(listener);
    return {};
}

std::int32_t Controller::Private::newSession() {
    return static_cast<std::int32_t>(QRandomGenerator::system()->bounded(1, 0x7fffffff));
}

Result<void> Controller::Private::openRegisters(const Deadline& deadline) {
    rtde::ConnectionOptions wanted;
    wanted.host = options.host;
    wanted.port = static_cast<std::uint16_t>(rtdePort());
    wanted.request.outputs = outputNames(options.registers);
    // Without watchdog or external wrench the arm can be moved all the same.
    wanted.request.inputs = {{inputNames(options.registers, kCommandInputs), true},
                             {inputNames(options.registers, kWatchdogInputs), false},
                             {inputNames(options.registers, kWrenchInputs), false}};
    // A controller may hold the registers of a connection that has just ended for a moment longer.
    const Deadline grace = Deadline::after(std::min(milliseconds(1000), deadline.remaining() / 2));
    auto opened = rtde::Connection::open(wanted, deadline);
    while (!opened && opened.error().code == ErrorCode::RegisterInUse && !grace.hasExpired() &&
           !deadline.hasExpired()) {
        std::this_thread::sleep_for(milliseconds(50));
        opened = rtde::Connection::open(wanted, deadline);
    }
    if (!opened) {
        const Error error = opened.error();
        return error.code == ErrorCode::RegisterInUse ? explainInUse(error, options.registers) : error;
    }
    connection = std::move(opened).value();
    const QString context = QStringLiteral("set up registers at %1").arg(connection->peer());
    const rtde::Recipe& inputs = connection->inputs().front();
    if (!inputs.isValid() || inputs.size() != kCommandSize) {
        return explainUnknown(context, options.registers);
    }
    auto found = FeedbackLayout::of(connection->outputs(), options.registers);
    if (!found) {
        return explainUnknown(context, options.registers);
    }
    layout = *found;
    watchdogUsable = connection->inputs()[kWatchdogInputs].isValid();
    wrenchUsable = connection->inputs()[kWrenchInputs].isValid();
    return {};
}

Result<Feedback> Controller::Private::firstData(const Deadline& deadline, const QString& context) {
    std::vector<double> values(connection->outputs().size());
    while (!deadline.hasExpired()) {
        const auto read = connection->readPackage(values, deadline.nextPoll());
        if (read == rtde::Connection::Read::Nothing) {
            continue;
        }
        if (read != rtde::Connection::Read::Package) {
            return connection->error();
        }
        return layout.decode(values, now());
    }
    return Error{deadline.isCancelled() ? ErrorCode::Cancelled : ErrorCode::Timeout, context,
                 QStringLiteral("no data package")};
}

Result<void> Controller::Private::checkModes(const Deadline& deadline) {
    const QString context = QStringLiteral("take control at %1").arg(connection->peer());
    const auto data = firstData(deadline, context);
    if (!data) {
        return data.error();
    }
    if (data->robotMode != RobotMode::Running || !allowsMotion(data->safetyMode)) {
        return Error{
            ErrorCode::UnsafeState, context,
            QStringLiteral("%1, %2").arg(robotModeName(data->robotMode), safetyModeName(data->safetyMode))};
    }
    return {};
}

// By what it says alone: to a program of others, what ours is asked with would be commands.
Result<Echo> Controller::Private::findProgram(const Deadline& deadline) {
    const QString context = QStringLiteral("join the control program at %1").arg(connection->peer());
    const auto data = firstData(deadline, context);
    if (!data) {
        return data.error();
    }
    const Echo& echo = data->echo;
    if (data->runtimeState != RuntimeState::Playing || echo.sequence <= kBeforeFirstSequence ||
        echo.session <= 0 || echo.epoch <= 0) {
        return Error{ErrorCode::NotInControl, context, QStringLiteral("no control program of ours runs")};
    }
    return echo;
}

// A name that is dropped from the language makes a controller refuse the whole program: once it has told
// which, the program does without.
Result<void> Controller::Private::upload(std::int32_t newSession, const QString& section,
                                         const Deadline& deadline) {
    for (;;) {
        auto sent = uploadOnce(newSession, section, deadline);
        if (sent || sent.error().code != ErrorCode::ScriptError) {
            return sent;
        }
        const QString name = refusedName(sent.error().controllerMessage);
        const std::lock_guard lock(arm);
        if (name.isEmpty() || refused.contains(name)) {
            return sent;
        }
        refused.append(name);
    }
}

Result<void> Controller::Private::uploadOnce(std::int32_t newSession, const QString& section,
                                             const Deadline& deadline) {
    const QString context =
        QStringLiteral("start the control program at %1:%2").arg(options.host).arg(primaryPort());
    QStringList without;
    {
        const std::lock_guard lock(arm);
        without = refused;
    }
    const ControlScript script = controlScript(versionNow(), options.registers, newSession, options.limits,
                                               armNow().maxSpeed, section, without, options.force);
    {
        const std::lock_guard lock(arm);
        primary->takeMessages();  // what was said before is not about us
        program = script;
    }
    session = newSession;
    if (options.deliver) {
        if (auto delivered = options.deliver(script.text, deadline); !delivered) {
            return delivered;
        }
    } else {
        script::ScriptClient client(options.host, primaryPort());
        if (auto connected = client.connect(deadline); !connected) {
            return connected;
        }
        if (auto sent = client.send(script.text, deadline); !sent) {
            return sent;
        }
    }
    return options.awaitProgram ? awaitControl(deadline, context) : Result<void>();
}

Result<void> Controller::Private::awaitControl(const Deadline& deadline, const QString& context) {
    while (!loop.isInControl()) {
        if (const Error bad = complaint(context); bad.code != ErrorCode::None) {
            return bad;
        }
        if (!running) {
            return Error{ErrorCode::LinkLost, context, QStringLiteral("the RTDE connection was lost")};
        }
        if (deadline.hasExpired()) {
            return Error{deadline.isCancelled() ? ErrorCode::Cancelled : ErrorCode::Timeout, context,
                         QStringLiteral("The program was sent, but it does not answer. Is the robot in "
                                        "Remote control, and are scripts allowed on this port?")};
        }
        std::this_thread::sleep_for(std::min(deadline.nextPoll(), milliseconds(2)));
    }
    return {};
}

Error Controller::Private::complaint(const QString& context) {
    constexpr int kReadOnlySocket = 210;
    const std::lock_guard lock(arm);
    if (!primary) {
        return {};
    }
    for (const auto& message : primary->takeMessages()) {
        if (message.kind == script::MessageKind::Key && !heardScript.name.isEmpty() &&
            message.text == heardScript.name) {
            heardScript.started = heardScript.started || message.title.endsWith(QLatin1String("STARTED"));
            heardScript.stopped = heardScript.stopped || message.title.endsWith(QLatin1String("STOPPED"));
        }
        if (message.kind == script::MessageKind::RuntimeException) {
            const QString place = message.line > 0 ? program.place(message.line, message.column) + ": " : "";
            const QString name = sectionName.isEmpty() ? QString() : sectionName + QLatin1Char(' ');
            const bool ours = place.contains(QLatin1String(".script line "));
            return {ErrorCode::ScriptError, context, (ours ? QString() : name) + place + message.text};
        }
        if (message.kind == script::MessageKind::ErrorCode && message.code == kReadOnlySocket) {
            return {ErrorCode::RemoteControlRequired, context,
                    message.text.isEmpty() ? message.codeName() : message.text};
        }
    }
    return {};
}

std::uint64_t Controller::Private::statesHeard() {
    const std::lock_guard lock(arm);
    return primary ? primary->state().packages : 0;
}

void Controller::Private::startThread(std::int32_t newSession, const Echo* joined) {
    session = newSession;
    loop.begin(newSession, connection->period(), armNow(), now());
    if (joined != nullptr) {
        // Nothing the client before us asked for may be taken for ours.
        mailbox.skipTo(static_cast<std::uint64_t>(joined->epoch) + 1);
        loop.follow(*joined);
    }
    quit.store(false, std::memory_order_release);
    running.store(true, std::memory_order_release);
    thread = std::thread([this] { run(); });
}

void Controller::Private::stopThread() {
    quit.store(true, std::memory_order_release);
    if (thread.joinable()) {
        thread.join();
    }
    running.store(false, std::memory_order_release);
    connection.reset();
    watchdogUsable = false;
    wrenchUsable = false;
    std::unique_ptr<script::PrimaryClient> listener;
    {
        const std::lock_guard lock(arm);
        listener = std::move(primary);
    }
}

}  // namespace tiller::control
