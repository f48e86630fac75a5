// SPDX-License-Identifier: MIT
#include "robot/testing/lock_step.h"

#include <QCoreApplication>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <utility>

#include "robot/receive/robot_state.h"

namespace tiller::virtual_time {

namespace {

/// Maximum real time for a thread to process one packet. This limit is reached only if a thread hangs.
constexpr std::chrono::seconds kGiveUp{20};
/// Real time within which the control thread detects that its data are too old: several of its check
/// intervals.
constexpr std::chrono::milliseconds kNoticeTime{50};
/// Maximum time for the control thread to answer a packet while control is being taken.
constexpr std::chrono::milliseconds kTakingTime{50};
/// Maximum wait for an answer before checking the state again, because a controller that is losing control
/// does not answer.
constexpr std::chrono::milliseconds kAnswerSlice{20};

template <class T>
std::vector<std::shared_ptr<const T>> living(std::vector<std::weak_ptr<const T>>& all) {
    std::vector<std::shared_ptr<const T>> there;
    std::erase_if(all, [](const auto& one) { return one.expired(); });
    for (const auto& one : all) {
        if (auto held = one.lock()) {
            there.push_back(std::move(held));
        }
    }
    return there;
}

simulator::SimulatorOptions inVirtualTime(simulator::SimulatorOptions options) {
    options.time = simulator::Time::Virtual;
    return options;
}

double newestStamp(const receive::Receiver& receiver) {
    const receive::Sample sample = receiver.latest();
    return receive::RobotState(sample).timestamp();
}

}  // namespace

simulator::SimulatorOptions LockStep::defaultOptions() {
    static std::atomic<unsigned> count{0};
    constexpr unsigned kFirst = 2;
    constexpr unsigned kAddresses = 250;
    const auto process = static_cast<unsigned>(QCoreApplication::applicationPid());
    simulator::SimulatorOptions options;
    options.listenAddress = QStringLiteral("127.%1.%2.%3")
                                .arg(10 + process % 200)
                                .arg(process / 200 % kAddresses)
                                .arg(kFirst + count++ % kAddresses);
    options.time = simulator::Time::Virtual;
    options.poweredOn = true;
    options.fastTransitions = true;
    return options;
}

LockStep::LockStep(simulator::SimulatorOptions options) : robot_(inVirtualTime(std::move(options))) {}

LockStep::~LockStep() {
    stop();
    {
        const std::lock_guard lock(flowMutex_);
        flows_ = 1;
    }
    endFlow();
}

Result<void> LockStep::start() {
    ending_ = false;
    return robot_.start();
}

void LockStep::stop() {
    ending_ = true;
    robot_.stop();
}

std::shared_ptr<receive::Receiver> LockStep::makeReceiver(receive::ReceiverOptions options) {
    options.host = robot_.listenAddress();
    options.port = robot_.ports().rtde;
    options.clock = clock_.get();
    auto made = std::make_shared<receive::Receiver>(std::move(options));
    follow(made);
    (void)made->start();  // waitForData() reports errors
    return made;
}

std::shared_ptr<control::Controller> LockStep::makeController(control::ControllerOptions options) {
    options.host = robot_.listenAddress();
    options.portOffset = robot_.options().portOffset;
    options.clock = clock_.get();
    auto made = std::make_shared<control::Controller>(std::move(options));
    follow(made);
    return made;
}

void LockStep::follow(std::weak_ptr<const receive::Receiver> receiver) {
    const std::lock_guard lock(followersMutex_);
    receivers_.push_back(std::move(receiver));
}

void LockStep::follow(std::weak_ptr<const control::Controller> controller) {
    const std::lock_guard lock(followersMutex_);
    controllers_.push_back(std::move(controller));
}

void LockStep::tick() {
    const std::lock_guard lock(stepping_);
    std::vector<std::shared_ptr<const receive::Receiver>> receivers;
    std::vector<std::shared_ptr<const control::Controller>> controllers;
    {
        const std::lock_guard guard(followersMutex_);
        receivers = living(receivers_);
        controllers = living(controllers_);
    }
    const auto all = controllers;
    std::erase_if(controllers, [](const auto& one) { return !one->status().inControl; });
    const std::uint64_t inputs = robot_.inputPackages();
    const auto before = robot_.rtdeDeliveries();
    clock_->advanceNs(static_cast<std::int64_t>(robot_.stepTime() * 1e9));
    robot_.step();
    const auto after = robot_.rtdeDeliveries();
    // Time stamp of the packet that reached the client in this period.
    const auto reached = [&](std::uint16_t port) -> std::optional<double> {
        const auto isOfPort = [port](const simulator::RtdeDelivery& one) { return one.port == port; };
        const auto now = std::find_if(after.begin(), after.end(), isOfPort);
        const auto then = std::find_if(before.begin(), before.end(), isOfPort);
        const bool isNew = now != after.end() && (then == before.end() || then->timestamp != now->timestamp);
        return isNew ? std::optional(now->timestamp) : std::nullopt;
    };
    const auto end = std::chrono::steady_clock::now() + kGiveUp;
    const auto goesOn = [&] { return !ending_ && std::chrono::steady_clock::now() < end; };
    for (const auto& receiver : receivers) {
        const auto stamp = reached(receiver->localPort());
        while (stamp && newestStamp(*receiver) < *stamp &&
               receiver->state() == receive::ReceiverState::Receiving && goesOn()) {
            std::this_thread::yield();
        }
    }
    // While control is being taken, the control program expects a response from the client within a limited
    // time. Packets that arrive before the control thread runs are not answered.
    for (const auto& controller : all) {
        const auto stamp = reached(controller->localPort());
        control::ControllerStatus status = controller->status();
        const auto enough = std::chrono::steady_clock::now() + kTakingTime;
        while (stamp && !status.inControl && status.loss == control::ControlLoss::Taking &&
               status.answeredTime < *stamp && !ending_ && std::chrono::steady_clock::now() < enough) {
            std::this_thread::yield();
            status = controller->status();
        }
    }
    std::uint64_t answers = 0;
    for (const auto& controller : controllers) {
        const auto stamp = reached(controller->localPort());
        control::ControllerStatus status = controller->status();
        while (stamp && status.answeredTime < *stamp && status.inControl && goesOn()) {
            std::this_thread::yield();
            status = controller->status();
        }
        answers += stamp && status.inControl ? 1 : 0;
    }
    // Without packets, the control thread detects outdated data by checking the clock, and then ends the
    // motion.
    const auto noticed = std::chrono::steady_clock::now() + kNoticeTime;
    for (const auto& controller : all) {
        control::ControllerStatus status = controller->status();
        while (!status.fresh && status.motion != control::kNoMotion &&
               std::chrono::steady_clock::now() < noticed) {
            std::this_thread::yield();
            status = controller->status();
        }
    }
    // Answers may be delayed by injected connection faults.
    const auto inControl = [&] {
        return std::any_of(controllers.begin(), controllers.end(),
                           [](const auto& controller) { return controller->status().inControl; });
    };
    while (answers > 0 && robot_.isLinkPlain() && inControl() && goesOn() &&
           !robot_.waitForInputPackages(inputs + answers, Deadline::after(kAnswerSlice))) {
    }
    // Clients that are still connecting receive replies without the time being advanced.
    robot_.drainSockets();
}

void LockStep::step(double seconds) {
    const auto ticks = std::llround(seconds / robot_.stepTime());
    for (long long i = 0; i < ticks && !ending_; ++i) {
        tick();
    }
}

bool LockStep::stepUntil(const std::function<bool()>& condition, double atMost) {
    const auto ticks = std::llround(atMost / robot_.stepTime());
    for (long long i = 0; i < ticks && !ending_ && !condition(); ++i) {
        tick();
    }
    return condition();
}

void LockStep::beginFlow() {
    const std::lock_guard lock(flowMutex_);
    if (flows_++ == 0) {
        const auto ends = std::make_shared<std::atomic<bool>>(false);
        ticking_ = {std::thread([this, ends] {
                        while (!*ends && !ending_ && robot_.isRunning()) {
                            tick();
                        }
                    }),
                    ends};
    }
}

void LockStep::endFlow() {
    Ticking last;
    {
        const std::lock_guard lock(flowMutex_);
        if (flows_ == 0 || --flows_ > 0) {
            return;
        }
        last = std::exchange(ticking_, {});
    }
    if (last.thread.joinable()) {
        *last.ends = true;
        last.thread.join();
    }
}

}  // namespace tiller::virtual_time
