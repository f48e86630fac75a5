// SPDX-License-Identifier: MIT
#include "robot/simulator/simulator.h"

#include <QCoreApplication>
#include <QThread>
#include <algorithm>
#include <condition_variable>
#include <functional>
#include <future>
#include <mutex>
#include <utility>
#include <vector>

#include "robot/core/qt_main_thread.h"
#include "robot/platform/thread_priority.h"
#include "robot/realtime/periodic_timer.h"
#include "robot/simulator/controller_services.h"
#include "robot/simulator/equipment/device_table.h"
#include "robot/simulator/faults.h"
#include "robot/simulator/host/script_host.h"
#include "robot/simulator/pendant/urcaps.h"
#include "robot/simulator/plant/personality.h"

namespace tiller::simulator {

namespace {

using namespace std::chrono_literals;

/// Maximum number of overdue periods that are caught up, e.g. after high CPU load. Further periods are
/// dropped, and robot time pauses for their duration.
constexpr std::uint64_t kMaxCatchUp = 25;
/// Maximum delay of a request while virtual time is stopped.
constexpr auto kVirtualPoll = 500us;

}  // namespace

class Simulator::Impl {
public:
    using Work = std::function<void(ControllerServices&)>;

    explicit Impl(const SimulatorOptions& given) : options(given) {
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

    /// Queues work for the thread. The work is dropped if the thread is not running.
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

    /// Like post(), but waits until the work is done.
    void call(const Work& work) {
        std::promise<void> done;
        std::future<void> finished = done.get_future();
        {
            const std::lock_guard lock(mutex);
            if (!accepting) {
                return;
            }
            queue.push_back([&work, &done](ControllerServices& controlBox) {
                work(controlBox);
                done.set_value();
            });
        }
        wake.notify_all();
        finished.wait();
    }

    SimulatorOptions options;
    std::unique_ptr<QThread> thread;
    mutable std::mutex mutex;  // protects the following members
    std::condition_variable wake;
    std::vector<Work> queue;
    bool accepting = false;
    bool stopping = false;
    Ports ports = Ports::none();
    SimulatedState truth;
    std::vector<RtdeDelivery> deliveries;
    bool linkIsPlain = true;
    TickTiming timing;  ///< this and the following members are used by the simulator thread only
    std::chrono::steady_clock::time_point timingBegan;
    double threadSecondsBefore = 0;
    const RtdeServer* rtde = nullptr;  ///< server in use; its counters may be read from any thread

    // Functions called in the simulator thread.
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

    void publishState(ControllerServices& controlBox) {
        const Telemetry& t = controlBox.plant.telemetry();
        SimulatedState now;
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
        std::vector<RtdeDelivery> delivered;
        if (options.time == Time::Virtual) {
            delivered = controlBox.services.rtde().deliveries();
        }
        const std::lock_guard lock(mutex);
        truth = now;
        deliveries = std::move(delivered);
        linkIsPlain = controlBox.services.link().isPlain();
    }

private:
    void run(std::promise<Result<void>>& opened) {
        realtime::nameThread("ur-simulator");
        timing.priorityGranted =
            options.priority && realtime::requestThreadPriority(*options.priority).granted > 0;
        resetTiming();
        ControllerServices controlBox(options);
        Result<void> outcome = checkSoftware(options.model, options.software);
        if (outcome.ok()) {
            outcome = controlBox.services.open(options);
        }
        const bool isOpen = outcome.ok();
        if (isOpen) {
            publishState(controlBox);
            const std::lock_guard lock(mutex);
            ports = controlBox.services.ports();
            rtde = &controlBox.services.rtde();
            accepting = true;
        }
        opened.set_value(std::move(outcome));  // `opened` may be destroyed after this call
        if (!isOpen) {
            return;
        }
        if (options.time == Time::Real) {
            runInRealTime(controlBox);
        } else {
            runInVirtualTime(controlBox);
        }
        {
            const std::lock_guard lock(mutex);
            accepting = false;
            rtde = nullptr;
        }
        work(controlBox);  // processes the last requests
        controlBox.services.close();
    }

    bool mustStop() {
        const std::lock_guard lock(mutex);
        return stopping;
    }

    void work(ControllerServices& controlBox) {
        std::vector<Work> batch;
        {
            const std::lock_guard lock(mutex);
            batch.swap(queue);
        }
        for (const Work& item : batch) {
            item(controlBox);
        }
    }

    void runInRealTime(ControllerServices& controlBox) {
        realtime::PeriodicTimer timer{
            std::chrono::nanoseconds(static_cast<std::int64_t>(controlBox.plant.stepTime() * 1e9 + 0.5))};
        while (!mustStop()) {
            const std::uint64_t over = timer.wait();
            const std::uint64_t missed = std::min(over, kMaxCatchUp);
            const auto began = std::chrono::steady_clock::now();
            work(controlBox);
            for (std::uint64_t i = 0; i <= missed; ++i) {
                controlBox.tick();
            }
            publishState(controlBox);
            timing.ticks += 1 + missed;
            timing.late += missed;
            timing.lost += over - missed;
            timing.lateness.add(timer.latenessNs());
            timing.work.add((std::chrono::steady_clock::now() - began).count());
        }
    }

    void runInVirtualTime(ControllerServices& controlBox) {
        while (!mustStop()) {
            work(controlBox);
            controlBox.service();
            std::unique_lock lock(mutex);
            wake.wait_for(lock, kVirtualPoll, [this] { return stopping || !queue.empty(); });
        }
    }
};

namespace {

/// Qt calls socket notifiers only if an application object exists. Otherwise, the ports accept connections
/// but no client is served.
void makeApplication() {
    if (QCoreApplication::instance() == nullptr) {
        static int count = 1;
        static char name[] = "tiller";
        static char* arguments[] = {name, nullptr};
        static QCoreApplication* const application = new QCoreApplication(count, arguments);
        static_cast<void>(application);  // exists until the process exits
    }
}

}  // namespace

Simulator::Simulator(const SimulatorOptions& options) : d_(std::make_unique<Impl>(options)) {}

Simulator::~Simulator() {
    stop();
}

Result<void> Simulator::start() {
    if (const Text& folder = d_->options.urcapsFolder; !folder.isEmpty()) {
        if (Result<void> read = pendant::UrcapStandIns().addFolder(folder); !read) {
            return read;
        }
    }
    for (const SimulatorOptions::Device& device : d_->options.devices) {
        if (const Result<DeviceTable> table = DeviceTable::read(device.file); !table) {
            return table.error();
        }
    }
    adoptMainThread();
    makeApplication();
    return d_->start();
}
void Simulator::stop() {
    d_->stop();
}
bool Simulator::isRunning() const {
    return d_->thread != nullptr;
}

Ports Simulator::ports() const {
    const std::lock_guard lock(d_->mutex);
    return d_->ports;
}
QString Simulator::listenAddress() const {
    return d_->options.listenAddress;
}
const SimulatorOptions& Simulator::options() const {
    return d_->options;
}
double Simulator::stepTime() const {
    return d_->options.software.controlPeriod();
}

// ---- time -----------------------------------------------------------------------------------------------

void Simulator::step(int ticks) {
    if (d_->options.time != Time::Virtual || ticks <= 0) {
        return;
    }
    d_->call([this, ticks](ControllerServices& controlBox) {
        for (int i = 0; i < ticks; ++i) {
            controlBox.tick();
        }
        d_->publishState(controlBox);
    });
}

bool Simulator::stepAnswered(const Deadline& deadline) {
    bool answered = true;
    if (d_->options.time != Time::Virtual) {
        return answered;
    }
    d_->call([&](ControllerServices& controlBox) {
        const RtdeServer& rtde = controlBox.services.rtde();
        const std::uint64_t inputs = rtde.inputPackages();
        const std::uint64_t outputs = rtde.outputPackages();
        controlBox.tick();
        const std::uint64_t wanted = inputs + rtde.outputPackages() - outputs;
        while (rtde.inputPackages() < wanted && rtde.clients() > 0 && !deadline.hasExpired()) {
            std::this_thread::yield();
            controlBox.service();
        }
        answered = rtde.inputPackages() >= wanted;
        d_->publishState(controlBox);
    });
    return answered;
}

void Simulator::stepSeconds(double seconds) {
    step(static_cast<int>(seconds / stepTime() + 0.5));
}

void Simulator::drainSockets() {
    d_->call([](ControllerServices& controlBox) { controlBox.service(); });
}

std::uint64_t Simulator::inputPackages() const {
    const std::lock_guard lock(d_->mutex);
    return d_->rtde == nullptr ? 0 : d_->rtde->inputPackages();
}

std::uint64_t Simulator::outputPackages() const {
    const std::lock_guard lock(d_->mutex);
    return d_->rtde == nullptr ? 0 : d_->rtde->outputPackages();
}

bool Simulator::waitForInputPackages(std::uint64_t total, const Deadline& deadline) {
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

std::vector<RtdeDelivery> Simulator::rtdeDeliveries() const {
    const std::lock_guard lock(d_->mutex);
    return d_->deliveries;
}

bool Simulator::isLinkPlain() const {
    const std::lock_guard lock(d_->mutex);
    return d_->linkIsPlain;
}

int Simulator::rtdeClients() const {
    const std::lock_guard lock(d_->mutex);
    return d_->rtde == nullptr ? 0 : d_->rtde->clients();
}

SimulatedState Simulator::truth() const {
    const std::lock_guard lock(d_->mutex);
    return d_->truth;
}

TickTiming Simulator::timing() {
    TickTiming now;
    d_->call([this, &now](ControllerServices&) { now = d_->timingNow(); });
    return now;
}

void Simulator::resetTiming() {
    d_->post([this](ControllerServices&) { d_->resetTiming(); });
}

// ---- hooks ----------------------------------------------------------------------------------------------

void Simulator::protectiveStop() {
    d_->post([](ControllerServices& controlBox) {
        constexpr std::int32_t kCollision = 157;
        controlBox.plant.protectiveStop({kCollision, 0, primary::ReportLevel::Warning, ""});
    });
}
void Simulator::emergencyStop(bool pressed) {
    d_->post([pressed](ControllerServices& controlBox) {
        controlBox.plant.safety().set(SafetySystem::Input::RobotEmergencyStop, pressed);
    });
}
void Simulator::systemEmergencyStop(bool active) {
    d_->post([active](ControllerServices& controlBox) {
        controlBox.plant.safety().set(SafetySystem::Input::SystemEmergencyStop, active);
    });
}
void Simulator::safeguardStop(bool open) {
    d_->post([open](ControllerServices& controlBox) {
        controlBox.plant.safety().set(SafetySystem::Input::Safeguard, open);
    });
}
void Simulator::reducedMode(bool active) {
    d_->post([active](ControllerServices& controlBox) {
        controlBox.plant.safety().set(SafetySystem::Input::Reduced, active);
    });
}
void Simulator::violation() {
    d_->post([](ControllerServices& controlBox) { controlBox.plant.safety().violation(); });
}
void Simulator::fault() {
    d_->post([](ControllerServices& controlBox) { controlBox.plant.safety().fault(); });
}

void Simulator::setDigitalInput(int number, bool value) {
    if (number < 0 || number >= kDigitalPins) {
        return;
    }
    d_->post([number, value](ControllerServices& controlBox) {
        Pins::setBit(controlBox.plant.pins().digitalInputs, number, value);
    });
}

void Simulator::setAnalogInput(int number, double value) {
    if (number < 0 || number > 3) {
        return;
    }
    d_->post([n = static_cast<std::size_t>(number), value](ControllerServices& controlBox) {
        Pins& pins = controlBox.plant.pins();
        (n < 2 ? pins.analogInputs[n] : pins.toolAnalogInputs[n - 2]) = value;
    });
}

void Simulator::setRemoteControl(bool remote) {
    d_->post([remote](ControllerServices& controlBox) { controlBox.setRemoteControl(remote); });
}

Result<QString> Simulator::inject(const Text& words) {
    Result<QString> outcome =
        Error{ErrorCode::NotConnected, QStringLiteral("the simulated controller is not running"), {}};
    d_->call([&](ControllerServices& controlBox) { outcome = injectFault(controlBox, words); });
    return outcome;
}

void Simulator::pressFreedriveButton(bool pressed) {
    d_->post([pressed](ControllerServices& controlBox) { controlBox.plant.setFreedriveButton(pressed); });
}
void Simulator::pressHand(const Wrench& wrench) {
    d_->post([wrench](ControllerServices& controlBox) {
        controlBox.plant.arm().environment().setHandWrench(wrench);
    });
}
void Simulator::changeWorld(std::function<void(arm::Environment&)> change) {
    d_->post([change = std::move(change)](ControllerServices& controlBox) {
        change(controlBox.plant.arm().environment());
    });
}
void Simulator::setSpeedSlider(double fraction) {
    d_->post([fraction](ControllerServices& controlBox) { controlBox.plant.setSpeedSlider(fraction); });
}
void Simulator::answerRequest(const std::variant<bool, std::int32_t, double, std::string>& answer) {
    d_->post(
        [answer](ControllerServices& controlBox) { controlBox.plant.scriptHost().answerRequest(answer); });
}
void Simulator::silence(bool silent) {
    d_->post([silent](ControllerServices& controlBox) { controlBox.silent = silent; });
}
void Simulator::closeClients() {
    d_->post([](ControllerServices& controlBox) { controlBox.services.closeClients(); });
}

}  // namespace tiller::simulator
