// SPDX-License-Identifier: MIT
#include "robot/control/detail/control_link.h"

#include <algorithm>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "robot/core/wait_until.h"
#include "robot/realtime/cpu_latency.h"
#include "robot/realtime/realtime_report.h"

namespace tiller::control {

using std::chrono::milliseconds;

namespace {

// Maximum real time between two checks of the control thread if no data arrive. The Clock determines whether
// data are late.
constexpr std::int64_t kLookUpNs = 4 * kNsPerMs;
// Data read within this time after other work of the thread may have arrived earlier.
constexpr std::int64_t kBusyNs = kNsPerMs / 20;
// Marks a value that the sample does not contain.
constexpr std::size_t kNoPlace = std::numeric_limits<std::size_t>::max();

QString rangeText(RegisterRange range) {
    return range == RegisterRange::Upper ? QStringLiteral("upper (24-47)") : QStringLiteral("lower (0-23)");
}

RegisterRange other(RegisterRange range) {
    return range == RegisterRange::Upper ? RegisterRange::Lower : RegisterRange::Upper;
}

// Names the affected registers, the possible users of these registers, and the suggested action.
Error explainInUse(const Error& error, RegisterRange range) {
    const QString fieldbus =
        range == RegisterRange::Lower
            ? QStringLiteral("disable the fieldbus (EtherNet/IP, PROFINET) on the robot, ")
            : QString();
    return {ErrorCode::RegisterInUse, QStringLiteral("take the %1 registers").arg(rangeText(range)),
            // Place the list of registers at the end, because it is long.
            QStringLiteral("Another client controls this robot or uses its registers, for example another "
                           "Tiller window. Close that client, %2or use the %3 registers. (%1)")
                .arg(error.context, fieldbus, rangeText(other(range)))};
}

Error explainUnknown(const QString& context, RegisterRange range) {
    const QString advice = range == RegisterRange::Upper
                               ? QStringLiteral("use the lower (0-23) registers with this robot software")
                               : QStringLiteral("this robot software is too old to be controlled over RTDE");
    return {ErrorCode::FieldUnknown, context,
            QStringLiteral("The controller has no %1 registers: %2.").arg(rangeText(range), advice)};
}

}  // namespace

Result<void> ControlLink::open(const Deadline& deadline) {
    rtde::ConnectionOptions wanted;
    wanted.host = options_.host;
    wanted.port =
        static_cast<std::uint16_t>(options_.rtdePort != 0 ? options_.rtdePort : 30004 + options_.portOffset);
    const std::vector<std::string> outputs = outputNames(options_.registers, options_.fields);
    wanted.request.outputs = outputs;
    // The watchdog and the external wrench are optional: motion is possible without them.
    wanted.request.inputs = {{inputNames(options_.registers, kCommandInputs), true},
                             {inputNames(options_.registers, kWatchdogInputs), false},
                             {inputNames(options_.registers, kWrenchInputs), false}};
    // A controller may release the registers of a closed connection late, so retry for up to one second.
    const Deadline grace =
        Deadline::after(std::min(milliseconds(1000), deadline.remaining() / 2), deadline.token());
    auto opened = rtde::Connection::open(wanted, deadline);
    waitUntil(
        grace,
        [&] {
            if (opened || opened.error().code != ErrorCode::RegisterInUse) {
                return true;
            }
            opened = rtde::Connection::open(wanted, deadline);
            return opened.ok();
        },
        milliseconds(50));
    if (!opened) {
        const Error error = opened.error();
        return error.code == ErrorCode::RegisterInUse ? explainInUse(error, options_.registers) : error;
    }
    connection_ = std::move(opened).value();
    localPort_ = native_socket::localPort(connection_->descriptor());
    const QString context = QStringLiteral("set up registers at %1").arg(connection_->peer());
    const rtde::Recipe& inputs = connection_->inputs().front();
    if (!inputs.isValid() || inputs.size() != kCommandSize) {
        return explainUnknown(context, options_.registers);
    }
    auto found = FeedbackLayout::of(connection_->outputs(), options_.registers);
    if (!found) {
        return explainUnknown(context, options_.registers);
    }
    layout_ = *found;
    planSample(outputs);
    watchdogUsable_ = connection_->inputs()[kWatchdogInputs].isValid();
    wrenchUsable_ = connection_->inputs()[kWrenchInputs].isValid();
    return {};
}

// Uses the types reported by the robot. If a type differs from the catalogue, only values that fit are used.
void ControlLink::planSample(const std::vector<std::string>& names) {
    sample_ = receive::Sample(std::make_shared<receive::SampleLayout>(names));
    sample_.connection = 1;
    const rtde::Recipe& recipe = connection_->outputs();
    places_.assign(recipe.size(), kNoPlace);
    for (const rtde::RecipeField& field : recipe.fields()) {
        if (const auto* entry = sample_.layout->find(field.name); entry != nullptr) {
            const std::size_t count = std::min(entry->count, componentCount(field.type));
            for (std::size_t i = 0; i < count; ++i) {
                places_[field.first + i] = entry->first + i;
            }
        }
    }
}

Feedback ControlLink::decode(std::span<const double> values) {
    Feedback data = layout_.decode(values, now());
    for (std::size_t i = 0; i < places_.size(); ++i) {
        if (places_[i] != kNoPlace) {
            sample_.values[places_[i]] = values[i];
        }
    }
    ++sample_.sequence;
    sample_.hostTimeNs = data.hostNs;
    data.sample = &sample_;
    return data;
}

Result<Feedback> ControlLink::firstData(const Deadline& deadline, const QString& context) {
    std::vector<double> values(connection_->outputs().size());
    while (!deadline.hasExpired()) {
        const auto read = connection_->readPackage(values, deadline.nextPoll());
        if (read == rtde::Connection::Read::Nothing) {
            continue;
        }
        if (read != rtde::Connection::Read::Package) {
            return connection_->error();
        }
        return layout_.decode(values, now());
    }
    return Error{deadline.isCancelled() ? ErrorCode::Cancelled : ErrorCode::Timeout, context,
                 QStringLiteral("no data packet arrived")};
}

Result<void> ControlLink::checkModes(const Deadline& deadline) {
    const QString context = QStringLiteral("take control at %1").arg(connection_->peer());
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

// Only reads registers, because another program could interpret a request as a command.
Result<Echo> ControlLink::findProgram(const Deadline& deadline) {
    const QString context = QStringLiteral("connect to the control program at %1").arg(connection_->peer());
    const auto data = firstData(deadline, context);
    if (!data) {
        return data.error();
    }
    const Echo& echo = data->echo;
    if (data->runtimeState != RuntimeState::Playing || echo.sequence <= kBeforeFirstSequence ||
        echo.session <= 0 || echo.epoch <= 0) {
        return Error{ErrorCode::NotInControl, context,
                     QStringLiteral("no control program of this library is running")};
    }
    return echo;
}

void ControlLink::begin(script::PrimaryClient& primary) {
    // Discard values of the previous connection.
    kick_ = false;
    wrench_.take();
    quit_.store(false, std::memory_order_release);
    running_.store(true, std::memory_order_release);
    thread_ = std::thread([this, &primary] { run(primary); });
}

void ControlLink::end() {
    quit_.store(true, std::memory_order_release);
    if (thread_.joinable()) {
        thread_.join();
    }
    running_.store(false, std::memory_order_release);
    localPort_ = 0;
    connection_.reset();
    watchdogUsable_ = false;
    wrenchUsable_ = false;
}

bool ControlLink::send(const Command& command) {
    const auto isSent = [this](Inputs recipe, std::span<const double> inputs) {
        return connection_->sendInputs(recipe, inputs) != rtde::Connection::Send::Failed;
    };
    const auto inputs = encode(command);
    bool sent = isSent(kCommandInputs, inputs);
    if (sent && watchdogUsable_ && kick_.exchange(false, std::memory_order_acq_rel)) {
        constexpr std::array<double, 1> kNothing{};
        sent = isSent(kWatchdogInputs, kNothing);
    }
    if (const auto* measured = sent && wrenchUsable_ ? wrench_.take() : nullptr; measured != nullptr) {
        sent = isSent(kWrenchInputs, *measured);
    }
    return sent;
}

// The packet that was read into `values`, or the newest packet of a backlog.
Feedback ControlLink::newest(std::vector<double>& values, std::int64_t lookedNs, std::int64_t doneNs) {
    Feedback data = decode(values);
    data.awaited = data.hostNs - doneNs > kBusyNs;
    data.lookedNs = lookedNs;
    constexpr int kQueue = 1000;  // limits the loop if the peer sends faster than this thread reads
    const bool mayQueue = !data.awaited || connection_->hasPackage();
    for (int passed = 0; passed < kQueue && mayQueue && loop_.wantsNewest(); ++passed) {
        // The next read detects a failure of the connection.
        if (connection_->readPackage(values, std::chrono::nanoseconds(0)) !=
            rtde::Connection::Read::Package) {
            break;
        }
        loop_.pass(data);
        data = decode(values);
        data.awaited = false;
        data.lookedNs = lookedNs;
    }
    return data;
}

void ControlLink::run(script::PrimaryClient& primary) {
    realtime::nameThread("control");
    // Without a real-time priority, CPU deep sleep stays enabled to save power.
    std::optional<realtime::CpuLatency> latency;
    if (options_.priority > 0) {
        latency.emplace();
    }
    loop_.setGranted(options_.priority <= 0 || realtime::requestThreadPriority(options_.priority).ok(),
                     options_.cpus.empty() || realtime::bindToCpus(options_.cpus).isEmpty(),
                     latency && latency->isGranted());
    std::vector<double> values(connection_->outputs().size());
    bool alive = true;
    std::int64_t doneNs = now();
    const auto lastData = [this] { return loop_.status().dataTimeNs; };
    const std::int64_t timeoutNs = std::chrono::nanoseconds(options_.connectionTimeout).count();
    const std::int64_t begunNs = doneNs;
    std::int64_t lookedNs = doneNs;
    int looks = 0;  // unsuccessful checks since the newest packet
    // A controller may send no data while it compiles a program. During this time, no motion of this client
    // is active.
    constexpr std::int64_t kTakingTimeoutNs = 2 * kNsPerSecond;
    const auto isDead = [&](std::int64_t nowNs) {
        // Minimum number of checks. After a delay of this PC, data may have arrived that were not read yet.
        constexpr int kLooks = 10;
        const std::int64_t silentNs = nowNs - std::max(lastData(), begunNs);
        const std::int64_t takingNs = loop_.status().loss == ControlLoss::Taking ? kTakingTimeoutNs : 0;
        return timeoutNs > 0 && looks >= kLooks &&
               silentNs > std::max({timeoutNs, loop_.dataTimeoutNs(), takingNs});
    };
    const auto answer = [&](const Command& command) {
        doneNs = now();
        return send(command);
    };
    while (alive && !quit_.load(std::memory_order_acquire)) {
        const std::int64_t due = loop_.dueNs();
        // Close to a scheduled cycle, poll instead of sleeping.
        const std::int64_t left = due == kNoCycleDue ? kLookUpNs : due - now() - kWakeUpNs;
        const std::chrono::nanoseconds wait(std::clamp<std::int64_t>(left, 0, kLookUpNs));
        switch (connection_->readPackage(values, wait, &waker_)) {
            case rtde::Connection::Read::Package: {
                looks = 0;
                const Feedback data = newest(values, lookedNs, doneNs);
                lookedNs = data.hostNs;
                alive = answer(loop_.tick(data));
                if (alive) {
                    loop_.answered();
                }
                if (loop_.takePaused() && (!options_.keepPaused || loop_.yieldedWhenPaused())) {
                    primary.requestProgramStop();
                }
                break;
            }
            case rtde::Connection::Read::Nothing: {
                const bool looksOn = wait.count() == 0 && now() < due;
                Command command;
                if ((waker_.take() && loop_.early(now(), command)) ||
                    (!looksOn && loop_.fallback(now(), command))) {
                    alive = answer(command);
                }
                looks += wait.count() > 0 ? 1 : 0;
                lookedNs = now();
                alive = alive && !isDead(lookedNs);
                break;
            }
            case rtde::Connection::Read::Closed:
            case rtde::Connection::Read::Failed:
            case rtde::Connection::Read::Malformed:
                alive = false;
                break;
        }
    }
    if (!alive) {
        loop_.lost(now(), ControlLoss::LinkLost);
        connection_->close();  // frees the registers for the next client
    }
    running_.store(false, std::memory_order_release);
}

Result<void> ControlLink::sendWrench(const std::array<double, 6>& wrench) {
    const QString context = QStringLiteral("send a wrench");
    if (!isRunning()) {
        return Error{ErrorCode::NotInControl, context, {}};
    }
    if (!wrenchUsable_) {
        return Error{
            ErrorCode::RegisterInUse, context,
            QStringLiteral("this robot has no input external_force_torque, or another client uses it")};
    }
    const std::lock_guard lock(wrenchCallers_);
    wrench_.publish(wrench);
    return {};
}

Result<void> ControlLink::kickWatchdog() {
    const QString context = QStringLiteral("kick the watchdog");
    if (!isRunning()) {
        return Error{ErrorCode::NotInControl, context, {}};
    }
    if (!watchdogUsable_) {
        return Error{ErrorCode::RegisterInUse, context,
                     QStringLiteral("another client uses the required register")};
    }
    kick_.store(true, std::memory_order_release);
    return {};
}

}  // namespace tiller::control
