// SPDX-License-Identifier: MIT
#include "robot/api/robot.h"

#include <algorithm>
#include <atomic>
#include <optional>
#include <thread>
#include <utility>

#include "robot/platform/thread_priority.h"
#include "robot/receive/data_age.h"

namespace tiller {

namespace {

receive::ReceiverOptions receiverOptions(const Text& host, const RobotOptions& options) {
    receive::ReceiverOptions wanted;
    wanted.host = host;
    wanted.port = static_cast<std::uint16_t>(rtde::kPort + options.portOffset);
    wanted.frequency = options.frequency;
    wanted.clock = options.clock;
    if (!options.fields.empty()) {
        wanted.fields = options.fields;
        // These fields are required for events and for the confirmation of outputs.
        for (const char* name : {"robot_mode", "safety_mode", "runtime_state", "actual_digital_output_bits",
                                 "target_speed_fraction", "analog_io_types", "standard_analog_output0",
                                 "standard_analog_output1"}) {
            if (std::find(wanted.fields.begin(), wanted.fields.end(), name) == wanted.fields.end()) {
                wanted.fields.emplace_back(name);
            }
        }
    }
    return wanted;
}

control::ControllerOptions controllerOptions(const Text& host, const RobotOptions& options) {
    control::ControllerOptions wanted = options.control;
    wanted.host = host;
    wanted.portOffset = options.portOffset;
    wanted.primaryPort = 0;
    wanted.rtdePort = 0;
    wanted.clock = options.clock;
    return wanted;
}

}  // namespace

// An unnamed namespace is not possible, because Observation is the type of a member of Robot::EventThread.
namespace robot_events {

/// Values whose changes are reported as events.
struct Observation {
    bool hasData = false;
    SafetyMode safetyMode = SafetyMode::Undefined;
    RobotMode robotMode = RobotMode::NoController;
    bool programRuns = false;
    control::ControllerStatus status;
};

inline Observation observe(const receive::Receiver& receiver, const control::Controller& controller,
                           const receive::Sample& sample) {
    const receive::RobotState state(sample);
    return {receiver.isFresh(receive::kMaxDataAge), state.safetyMode(), state.robotMode(),
            state.runtimeState() == RuntimeState::Playing, controller.status()};
}

/// During an outage, `now` contains the modes of the last packet, so the modes after the outage are compared
/// with those before it.
template <class Report>
void compare(const Observation& before, const Observation& now, Report report) {
    using Kind = RobotEvent::Kind;
    const auto event = [&](Kind kind) {
        report(RobotEvent{kind, now.safetyMode, now.robotMode, now.status.loss, now.status.lastMotion,
                          now.status.lastCause});
    };
    if (before.hasData != now.hasData) {
        event(now.hasData ? Kind::DataResumed : Kind::DataLost);
    }
    if (before.safetyMode != now.safetyMode) {
        event(now.safetyMode == SafetyMode::ProtectiveStop ? Kind::ProtectiveStop : Kind::SafetyMode);
    }
    if (before.robotMode != now.robotMode) {
        event(Kind::RobotMode);
    }
    if (before.programRuns != now.programRuns) {
        event(now.programRuns ? Kind::ProgramStarted : Kind::ProgramEnded);
    }
    if (before.status.lastMotion != now.status.lastMotion) {
        event(Kind::MotionEnded);
    }
    if (before.status.inControl != now.status.inControl) {
        event(now.status.inControl ? Kind::ControlTaken : Kind::ControlLost);
    }
}

}  // namespace robot_events

/// Compares the state before and after every packet.
class Robot::EventThread {
public:
    EventThread(std::shared_ptr<receive::Receiver> receiver, std::shared_ptr<control::Controller> controller,
                const std::function<void(const RobotEvent&)>& handler)
        : receiver_(std::move(receiver)), controller_(std::move(controller)), handler_(handler) {
        packets_ = receiver_->subscribe();
        sample_ = receiver_->latest();
        before_ = robot_events::observe(*receiver_, *controller_, sample_);
        thread_ = std::thread([this] { run(); });
    }
    ~EventThread() {
        token_.cancel();
        thread_.join();
    }
    EventThread(const EventThread&) = delete;
    EventThread& operator=(const EventThread&) = delete;

private:
    void run() {
        realtime::nameThread("tiller-events");
        // Even without packets, the age of the data and the state of control change.
        constexpr std::chrono::milliseconds kLook{20};
        while (!token_.isCancelled()) {
            (void)packets_.next(sample_, Deadline::after(kLook, token_));
            const robot_events::Observation now = robot_events::observe(*receiver_, *controller_, sample_);
            robot_events::compare(before_, now, handler_);
            before_ = now;
        }
    }

    const std::shared_ptr<receive::Receiver> receiver_;
    const std::shared_ptr<control::Controller> controller_;
    const std::function<void(const RobotEvent&)>& handler_;
    receive::Subscription packets_;
    receive::Sample sample_;
    robot_events::Observation before_;
    CancelToken token_;
    std::thread thread_;
};

CancelToken cancelledBy(std::stop_token stop) {
    return CancelToken([stop = std::move(stop)] { return stop.stop_requested(); });
}

Robot::Robot(const Text& host, RobotOptions options)
    : options_(std::move(options))
    , host_(host)
    , receiver_(std::make_shared<receive::Receiver>(receiverOptions(host, options_)))
    , controller_(std::make_shared<control::Controller>(controllerOptions(host, options_)))
    , outputs_(std::make_unique<io::Outputs>(
          io::OutputsOptions{host, static_cast<std::uint16_t>(rtde::kPort + options_.portOffset)},
          io::OutputFeedback::fromReceiver(*receiver_))) {}

Robot::~Robot() {
    disconnect();
}

Result<void> Robot::connect(const Deadline& deadline) {
    if (receiver_->state() != receive::ReceiverState::Stopped) {
        return {};
    }
    if (auto started = receiver_->start(); !started) {
        return started;
    }
    if (const auto first = receiver_->waitForData(deadline); !first) {
        receiver_->stop();
        return first.error();
    }
    if (options_.onEvent) {
        events_ = std::make_unique<EventThread>(receiver_, controller_, options_.onEvent);
    }
    return {};
}

// Stop the arm first; nothing before this line may wait.
void Robot::disconnect() {
    controller_->release();
    recorder_.stop();
    outputs_->disconnect();
    service_.reset();
    events_.reset();
    receiver_->stop();
}

Result<dashboard::RobotService*> Robot::service(const Deadline& deadline) {
    if (!service_ || !service_->isConnected()) {
        service_.reset();
        auto opened = dashboard::openService(dashboard::serviceAt(host_, options_.portOffset), deadline);
        if (!opened) {
            return opened.error();
        }
        service_ = std::move(opened).value();
    }
    return service_.get();
}

Result<void> Robot::record(const recording::RecorderOptions& options) {
    if (receiver_->state() == receive::ReceiverState::Stopped) {
        return Error{ErrorCode::NotConnected, QStringLiteral("record"),
                     QStringLiteral("call connect() first")};
    }
    recorder_.stop();
    return recorder_.start(options, *receiver_);
}

Result<void> Robot::stopRecording() {
    recorder_.stop();
    const Error error = recorder_.error();
    return error.code == ErrorCode::None ? Result<void>() : Result<void>(error);
}

}  // namespace tiller
