// SPDX-License-Identifier: MIT
#include "robot/ur_rtde/custom/register_link.h"

#include "robot/core/wait_until.h"
#include "robot/platform/thread_priority.h"
#include "robot/rtde/fields.h"
#include "robot/ur_rtde/detail/waiting.h"

namespace tiller::urrtde {

namespace {

using rtde::Direction;
using std::chrono::milliseconds;

constexpr milliseconds kLookEvery(20);
constexpr milliseconds kSilenceLimit(2500);  // maximum time without data for an intact connection
constexpr int kClearRecipe = 4;
constexpr int kKickRecipe = 11;

// First integer register after the registers of the recipes and of RTDEIOInterface.
constexpr int kHeartbeatRegister = 23;

/// Layout: integer registers from 0, then double registers from 0, then one more field.
struct RecipeShape {
    int ints;
    int doubles;
    const char* last;
};
constexpr const char* kIntOne = "int 1";
constexpr RecipeShape kRecipes[] = {
    {1, 8, kIntOne},  {1, 11, nullptr}, {8, 18, nullptr},
    {1, 0, nullptr},  {1, 9, nullptr},  {1, 6, nullptr},
    {1, 4, nullptr},  {1, 1, nullptr},  {2, 0, nullptr},
    {1, 14, nullptr}, {1, 0, nullptr},  {1, 12, nullptr},
    {1, 8, nullptr},  {1, 14, nullptr}, {2, 0, nullptr},
    {1, 13, nullptr}, {7, 6, nullptr},  {1, 0, "external_force_torque"},
    {2, 7, nullptr},  {1, 1, kIntOne},
};

std::vector<rtde::InputRequest> inputRequests(int offset) {
    std::vector<rtde::InputRequest> requests;
    for (const RecipeShape& shape : kRecipes) {
        rtde::InputRequest request;
        for (int i = 0; i < shape.ints; ++i) {
            request.names.push_back(rtde::intRegisterName(Direction::Input, offset + i));
        }
        for (int i = 0; i < shape.doubles; ++i) {
            request.names.push_back(rtde::doubleRegisterName(Direction::Input, offset + i));
        }
        if (shape.last == kIntOne) {
            request.names.push_back(rtde::intRegisterName(Direction::Input, offset + 1));
        } else if (shape.last != nullptr) {
            request.names.emplace_back(shape.last);
            request.required = false;  // another client may use the sensor
        }
        requests.push_back(std::move(request));
    }
    const std::string heartbeat = rtde::intRegisterName(Direction::Input, offset + kHeartbeatRegister);
    requests.push_back({{heartbeat}, false});
    return requests;
}

constexpr const char* kStatusFields[] = {"robot_status_bits", "safety_status_bits", "runtime_state"};

std::vector<std::string> outputNames(int offset) {
    std::vector<std::string> names(std::begin(kStatusFields), std::end(kStatusFields));
    for (int i = 0; i < 3; ++i) {
        names.push_back(rtde::intRegisterName(Direction::Output, offset + i));
    }
    for (int i = 0; i < 6; ++i) {
        names.push_back(rtde::doubleRegisterName(Direction::Output, offset + i));
    }
    return names;
}

}  // namespace

Result<std::unique_ptr<RegisterLink>> RegisterLink::open(const RegisterLinkOptions& options,
                                                         const Deadline& deadline) {
    rtde::ConnectionOptions wanted;
    wanted.host = options.host;
    wanted.request.outputs = outputNames(options.offset);
    wanted.request.frequency = options.frequency;
    wanted.request.inputs = inputRequests(options.offset);
    // A controller may release the registers of a closed connection late, so retry for up to one second.
    auto opened = rtde::Connection::open(wanted, deadline);
    waitUntil(
        Deadline::after(milliseconds(1000)),
        [&] {
            if (!opened && opened.error().code == ErrorCode::RegisterInUse) {
                opened = rtde::Connection::open(wanted, deadline);
            }
            return opened || opened.error().code != ErrorCode::RegisterInUse;
        },
        milliseconds(50));
    if (!opened) {
        return opened.error();
    }
    std::unique_ptr<RegisterLink> link(new RegisterLink(options, std::move(opened).value()));
    if (auto found = link->findFields(); !found) {
        return found.error();
    }
    // Clears the commands of an earlier client.
    link->clear();
    link->thread_ = std::thread([self = link.get()] { self->run(); });
    return link;
}

RegisterLink::RegisterLink(const RegisterLinkOptions& options, std::unique_ptr<rtde::Connection> connection)
    : options_(options), connection_(std::move(connection)), version_(connection_->version()) {}

RegisterLink::~RegisterLink() {
    close();
}

void RegisterLink::close() {
    quit_ = true;
    alive_ = false;
    wake();
    if (thread_.joinable()) {
        thread_.join();
    }
    const std::lock_guard lock(sending_);
    connection_->close();
}

Result<void> RegisterLink::findFields() {
    const rtde::Recipe& outputs = connection_->outputs();
    std::string missing;
    const auto find = [&](const std::string& name) {
        const auto index = outputs.indexOf(name);
        if (!index) {
            missing += (missing.empty() ? "" : ", ") + name;
        }
        return index.value_or(0);
    };
    for (std::size_t i = 0; i < status_.size(); ++i) {
        status_[i] = find(kStatusFields[i]);
    }
    for (int i = 0; i < 3; ++i) {
        ints_[static_cast<std::size_t>(i)] =
            find(rtde::intRegisterName(Direction::Output, options_.offset + i));
    }
    for (int i = 0; i < 6; ++i) {
        doubles_[static_cast<std::size_t>(i)] =
            find(rtde::doubleRegisterName(Direction::Output, options_.offset + i));
    }
    if (!missing.empty()) {
        return Error{ErrorCode::FieldUnknown,
                     QStringLiteral("control over RTDE at %1").arg(connection_->peer()),
                     QStringLiteral("this robot does not send %1").arg(QString::fromStdString(missing))};
    }
    return {};
}

void RegisterLink::run() {
    realtime::nameThread("ur_rtde-control");
    if (options_.priority > 0) {
        realtime::requestThreadPriority(options_.priority);
    }
    std::vector<double> values(connection_->outputs().size());
    auto lastData = std::chrono::steady_clock::now();
    while (!quit_) {
        const auto read = connection_->readPackage(values, kLookEvery);
        if (read == rtde::Connection::Read::Package) {
            lastData = std::chrono::steady_clock::now();
            publish(values);
        } else if (read != rtde::Connection::Read::Nothing ||
                   std::chrono::steady_clock::now() - lastData > kSilenceLimit) {
            break;
        }
        sendHeartbeat();
    }
    alive_ = false;
    {
        const std::lock_guard lock(sending_);
        connection_->close();
    }
    { const std::lock_guard lock(mutex_); }
    changed_.notify_all();
}

void RegisterLink::publish(const std::vector<double>& values) {
    RegisterState now;
    {
        const std::lock_guard lock(mutex_);
        ++state_.sequence;
        state_.robotStatus = static_cast<std::uint32_t>(values[status_[0]]);
        state_.safetyStatus = static_cast<std::uint32_t>(values[status_[1]]);
        state_.runtime = static_cast<RuntimeState>(values[status_[2]]);
        state_.played += state_.isPlaying() ? 1 : 0;
        const auto answer = static_cast<std::uint32_t>(static_cast<std::int32_t>(values[ints_[0]]));
        state_.answer = static_cast<int>(answer % 4);
        state_.answered = static_cast<int>(answer / 4);
        state_.result = static_cast<int>(values[ints_[1]]);
        state_.progress = static_cast<int>(values[ints_[2]]);
        for (std::size_t i = 0; i < doubles_.size(); ++i) {
            state_.values[i] = values[doubles_[i]];
        }
        now = state_;
    }
    changed_.notify_all();
    if (isCommandAlone()) {
        const std::lock_guard lock(sending_);
        if (isCommandAlone() && (now.isDone(alone_) || now.hasEnded())) {
            sendLocked(kClearRecipe, {0.0});
        }
    }
}

RegisterState RegisterLink::state() const {
    const std::lock_guard lock(mutex_);
    return state_;
}

bool RegisterLink::wait(const std::function<bool(const RegisterState&)>& done,
                        const std::function<bool(const RegisterState&)>& giveUp, milliseconds atMost) {
    constexpr milliseconds kSlice(10);
    const auto end = std::chrono::steady_clock::now() + atMost;
    std::unique_lock lock(mutex_);
    while (!done(state_)) {
        if (!alive_ || giveUp(state_) || std::chrono::steady_clock::now() >= end) {
            return false;
        }
        changed_.wait_for(lock, kSlice);
        lock.unlock();
        throwIfInterrupted();
        lock.lock();
    }
    return true;
}

int RegisterLink::heartbeatRegister() const {
    return options_.offset + kHeartbeatRegister;
}

bool RegisterLink::beginHeartbeat() {
    {
        const std::lock_guard lock(sending_);
        beats_ = alive_ && connection_->inputs().back().isValid();
    }
    sendHeartbeat();
    return beats_;
}

void RegisterLink::sendHeartbeat() {
    const std::lock_guard lock(sending_);
    if (beats_ && alive_) {
        beat_ = beat_ % 0x3fffffff + 1;
        connection_->sendInputs(connection_->inputs().size() - 1, std::array{static_cast<double>(beat_)});
    }
}

bool RegisterLink::send(int recipe, const std::vector<double>& values) {
    const std::lock_guard lock(sending_);
    return sendLocked(recipe, values);
}

bool RegisterLink::sendLocked(int recipe, const std::vector<double>& values) {
    const auto index = static_cast<std::size_t>(recipe - 1);
    if (!alive_ || !connection_->inputs()[index].isValid() ||
        connection_->inputs()[index].size() != values.size()) {
        return false;
    }
    if (connection_->sendInputs(index, values) != rtde::Connection::Send::Sent) {
        return false;
    }
    if (recipe != kKickRecipe) {
        alone_ = 0;
    }
    command_ = static_cast<int>(values.front());
    return true;
}

bool RegisterLink::sendAlone(int recipe, const std::vector<double>& values) {
    const std::lock_guard lock(sending_);
    if (!sendLocked(recipe, values)) {
        return false;
    }
    alone_ = static_cast<int>(values.front());
    return true;
}

bool RegisterLink::kick() {
    const std::lock_guard lock(sending_);
    return sendLocked(kKickRecipe, {static_cast<double>(command_)});
}

bool RegisterLink::clear() {
    return send(kClearRecipe, {0.0});
}

bool RegisterLink::clear(CommandId command) {
    const std::lock_guard lock(sending_);
    return !holds(command) || sendLocked(kClearRecipe, {0.0});
}

}  // namespace tiller::urrtde
