// SPDX-License-Identifier: MIT
#include "robot/simulator/controller.h"

#include <QThread>
#include <algorithm>
#include <condition_variable>
#include <functional>
#include <future>
#include <mutex>
#include <utility>
#include <vector>

#include "robot/realtime/periodic_timer.h"
#include "robot/realtime/thread_priority.h"
#include "robot/simulator/faults.h"
#include "robot/simulator/machine.h"
#include "robot/simulator/personality.h"
#include "robot/simulator/script_host.h"

namespace tiller::simulator {

namespace {

using namespace std::chrono_literals;

/// Periods made up for after the machine was busy; more are dropped, time stands still for them.
constexpr std::uint64_t kMostCatchUp = 25;
/// How soon a request is answered while virtual time stands still.
constexpr auto kVirtualPoll = 500us;

}  // namespace

class Controller::Impl {
public:
    using Work = std::function<void(Machine&)>;

    explicit Impl(const ControllerOptions& given) : options(given) {
        if (options.serialNumber.isEmpty()) {
            options.serialNumber = serialNumber(options.model, options.software);
        }
    }

    Result<void> start() {
        if (thread) {
            return {};
        }
        std::promise<Result<void>> opened;
        std::future<Result<void>> result = opened.get_future();
        stopping = false;
        thread.reset(QThread::create([this, &opened] { run(opened); }));
        thread->start();
        Result<void> outcome = result.get();
        if (!outcome) {
            thread->wait();
            thread.reset();
        }
        return outcome;
    }

    void stop() {
        if (!thread) {
            return;
        }
        {
            const std::lock_guard lock(mutex);
            stopping = true;
        }
        wake.notify_all();
        thread->wait();
        thread.reset();
    }

    /// Hands work to the thread; it is dropped when none runs.
    void post(Work work) {
        {
            const std::lock_guard lock(mutex);
            if (!accepting) {
                return;
            }
            queue.push_back(std::move(work));
        }
        wake.notify_all();
    }

    /// As post(), and waits until it is done.
    void call(const Work& work) {
        std::promise<void> done;
        std::future<void> finished = done.get_future();
        {
            const std::lock_guard lock(mutex);
            if (!accepting) {
                return;
            }
            queue.push_back([&work, &done](Machine& machine) {
                work(machine);
                done.set_value();
            });
        }
        wake.notify_all();
        finished.wait();
    }

    ControllerOptions options;
    std::unique_ptr<QThread> thread;
    mutable std::mutex mutex;  // guards everything below
    std::condition_variable wake;
    std::vector<Work> queue;
    bool accepting = false;
    bool stopping = false;
    Ports ports = Ports::none();
    Truth truth;
    TickTiming timing;  ///< the thread's, as what follows
    std::chrono::steady_clock::time_point timingBegan;
    double threadSecondsBefore = 0;
    const RtdeServer* rtde = nullptr;  ///< of the running thread; its counters may be read by any

    // In the thread.
    void resetTiming() {
        const bool granted = timing.priorityGranted;
        timing = TickTiming();
        timing.priorityGranted = granted;
        timingBegan = std::chrono::steady_clock::now();
        threadSecondsBefore = realtime::threadSeconds();
    }
    TickTiming timingNow() const {
        TickTiming now = timing;
        now.threadSeconds = realtime::threadSeconds() - threadSecondsBefore;
        now.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - timingBegan).count();
        return now;
    }

    void publishTruth(Machine& machine) {
        const Telemetry& t = machine.plant.telemetry();
        Truth now;
        now.tick = t.tick;
        now.timestamp = t.timestamp;
        now.robotMode = t.robotMode;
        now.safetyMode = t.safetyMode;
        now.runtimeState = t.runtimeState;
        now.q = t.arm->actualQ;
        now.qd = t.arm->actualQd;
        now.tcpPose = t.arm->actualTcpPose;
        now.tcpSpeed = t.arm->actualTcpSpeed;
        now.speedSlider = t.speedSlider;
        now.digitalOutputs = t.pins->digitalOutputs;
        const std::lock_guard lock(mutex);
        truth = now;
    }

private:
    void run(std::promise<Result<void>>& opened) {
        realtime::nameThread("ur-simulator");
        timing.priorityGranted =
            options.priority && realtime::requestThreadPriority(*options.priority).granted > 0;
        resetTiming();
        Machine machine(options);
        Result<void> outcome = checkSoftware(options.model, options.software);
        if (outcome.ok()) {
            outcome = machine.services.open(options);
        }
        const bool isOpen = outcome.ok();
        if (isOpen) {
            publishTruth(machine);
            const std::lock_guard lock(mutex);
            ports = machine.services.ports();
            rtde = &machine.services.rtde();
            accepting = true;
        }
        opened.set_value(std::move(outcome));  // from here on `opened` may be gone
        if (!isOpen) {
            return;
        }
        if (options.time == Time::Real) {
            runInRealTime(machine);
        } else {
            runInVirtualTime(machine);
        }
        {
            const std::lock_guard lock(mutex);
            accepting = false;
            rtde = nullptr;
        }
        work(machine);  // nobody shall wait for what came last
        machine.services.close();
    }

    bool mustStop() {
        const std::lock_guard lock(mutex);
        return stopping;
    }

    void work(Machine& machine) {
        std::vector<Work> batch;
        {
            const std::lock_guard lock(mutex);
            batch.swap(queue);
        }
        for (const Work& item : batch) {
            item(machine);
        }
    }

    void runInRealTime(Machine& machine) {
        realtime::PeriodicTimer timer{
            std::chrono::nanoseconds(static_cast<std::int64_t>(machine.plant.stepTime() * 1e9 + 0.5))};
        while (!mustStop()) {
            const std::uint64_t over = timer.wait();
            const std::uint64_t missed = std::min(over, kMostCatchUp);
            const auto began = std::chrono::steady_clock::now();
            work(machine);
            for (std::uint64_t i = 0; i <= missed; ++i) {
                machine.tick();
            }
            publishTruth(machine);
            timing.ticks += 1 + missed;
            timing.late += missed;
            timing.lost += over - missed;
            timing.lateness.add(timer.latenessNs());
            timing.work.add((std::chrono::steady_clock::now() - began).count());
        }
    }

    void runInVirtualTime(Machine& machine) {
        while (!mustStop()) {
            work(machine);
            machine.service();
            std::unique_lock lock(mutex);
            wake.wait_for(lock, kVirtualPoll, [this] { return stopping || !queue.empty(); });
        }
    }
};

Controller::Controller(const ControllerOptions& options) : d_(std::make_unique<Impl>(options)) {}

Controller::~Controller() {
    stop();
}

Result<void> Controller::start() {
    return d_->start();
}
void Controller::stop() {
    d_->stop();
}
bool Controller::isRunning() const {
    return d_->thread != nullptr;
}

Ports Controller::ports() const {
    const std::lock_guard lock(d_->mutex);
    return d_->ports;
}
QString Controller::listenAddress() const {
    return d_->options.listenAddress;
}
const ControllerOptions& Controller::options() const {
    return d_->options;
}
double Controller::stepTime() const {
    return d_->options.software.controlPeriod();
}

// ---- time -----------------------------------------------------------------------------------------------

void Controller::step(int ticks) {
    if (d_->options.time != Time::Virtual || ticks <= 0) {
        return;
    }
    d_->call([this, ticks](Machine& machine) {
        for (int i = 0; i < ticks; ++i) {
            machine.tick();
        }
        d_->publishTruth(machine);
    });
}

bool Controller::stepAnswered(const Deadline& deadline) {
    bool answered = true;
    if (d_->options.time != Time::Virtual) {
        return answered;
    }
    d_->call([&](Machine& machine) {
        const RtdeServer& rtde = machine.services.rtde();
        const std::uint64_t inputs = rtde.inputPackages();
        const std::uint64_t outputs = rtde.outputPackages();
        machine.tick();
        const std::uint64_t wanted = inputs + rtde.outputPackages() - outputs;
        while (rtde.inputPackages() < wanted && rtde.clients() > 0 && !deadline.hasExpired()) {
            std::this_thread::yield();
            machine.service();
        }
        answered = rtde.inputPackages() >= wanted;
        d_->publishTruth(machine);
    });
    return answered;
}

void Controller::stepSeconds(double seconds) {
    step(static_cast<int>(seconds / stepTime() + 0.5));
}

void Controller::drainSockets() {
    d_->call([](Machine& machine) { machine.service(); });
}

std::uint64_t Controller::inputPackages() const {
    const std::lock_guard lock(d_->mutex);
    return d_->rtde == nullptr ? 0 : d_->rtde->inputPackages();
}

std::uint64_t Controller::outputPackages() const {
    const std::lock_guard lock(d_->mutex);
    return d_->rtde == nullptr ? 0 : d_->rtde->outputPackages();
}

bool Controller::waitForInputPackages(std::uint64_t total, const Deadline& deadline) {
    while (inputPackages() < total) {
        if (deadline.hasExpired() || !isRunning()) {
            return false;
        }
        drainSockets();
        if (inputPackages() < total) {
            std::this_thread::yield();
        }
    }
    return true;
}

int Controller::rtdeClients() const {
    const std::lock_guard lock(d_->mutex);
    return d_->rtde == nullptr ? 0 : d_->rtde->clients();
}

Truth Controller::truth() const {
    const std::lock_guard lock(d_->mutex);
    return d_->truth;
}

TickTiming Controller::timing() {
    TickTiming now;
    d_->call([this, &now](Machine&) { now = d_->timingNow(); });
    return now;
}

void Controller::resetTiming() {
    d_->post([this](Machine&) { d_->resetTiming(); });
}

// ---- hooks ----------------------------------------------------------------------------------------------

void Controller::protectiveStop() {
    d_->post([](Machine& machine) {
        constexpr std::int32_t kCollision = 157;
        machine.plant.protectiveStop({kCollision, 0, primary::ReportLevel::Warning, ""});
    });
}
void Controller::emergencyStop(bool pressed) {
    d_->post([pressed](Machine& machine) {
        machine.plant.safety().set(SafetySystem::Input::RobotEmergencyStop, pressed);
    });
}
void Controller::systemEmergencyStop(bool active) {
    d_->post([active](Machine& machine) {
        machine.plant.safety().set(SafetySystem::Input::SystemEmergencyStop, active);
    });
}
void Controller::safeguardStop(bool open) {
    d_->post([open](Machine& machine) { machine.plant.safety().set(SafetySystem::Input::Safeguard, open); });
}
void Controller::reducedMode(bool active) {
    d_->post(
        [active](Machine& machine) { machine.plant.safety().set(SafetySystem::Input::Reduced, active); });
}
void Controller::violation() {
    d_->post([](Machine& machine) { machine.plant.safety().violation(); });
}
void Controller::fault() {
    d_->post([](Machine& machine) { machine.plant.safety().fault(); });
}

void Controller::setDigitalInput(int number, bool value) {
    if (number < 0 || number >= kDigitalPins) {
        return;
    }
    d_->post([number, value](Machine& machine) {
        Pins::setBit(machine.plant.pins().digitalInputs, number, value);
    });
}

void Controller::setAnalogInput(int number, double value) {
    if (number < 0 || number > 3) {
        return;
    }
    d_->post([n = static_cast<std::size_t>(number), value](Machine& machine) {
        Pins& pins = machine.plant.pins();
        (n < 2 ? pins.analogInputs[n] : pins.toolAnalogInputs[n - 2]) = value;
    });
}

void Controller::setRemoteControl(bool remote) {
    d_->post([remote](Machine& machine) { machine.setRemoteControl(remote); });
}

Result<QString> Controller::inject(const Text& words) {
    Result<QString> outcome =
        Error{ErrorCode::NotConnected, QStringLiteral("the controller does not run"), {}};
    d_->call([&](Machine& machine) { outcome = injectFault(machine, words); });
    return outcome;
}

void Controller::pressFreedriveButton(bool pressed) {
    d_->post([pressed](Machine& machine) { machine.plant.setFreedriveButton(pressed); });
}
void Controller::pressHand(const Wrench& wrench) {
    d_->post([wrench](Machine& machine) { machine.plant.arm().environment().setHandWrench(wrench); });
}
void Controller::changeWorld(std::function<void(arm::Environment&)> change) {
    d_->post([change = std::move(change)](Machine& machine) { change(machine.plant.arm().environment()); });
}
void Controller::setSpeedSlider(double fraction) {
    d_->post([fraction](Machine& machine) { machine.plant.setSpeedSlider(fraction); });
}
void Controller::answerRequest(const std::variant<bool, std::int32_t, double, std::string>& answer) {
    d_->post([answer](Machine& machine) { machine.plant.scriptHost().answerRequest(answer); });
}
void Controller::silence(bool silent) {
    d_->post([silent](Machine& machine) { machine.silent = silent; });
}
void Controller::closeClients() {
    d_->post([](Machine& machine) { machine.services.closeClients(); });
}

}  // namespace tiller::simulator
