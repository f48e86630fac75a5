// SPDX-License-Identifier: MIT
#include "robot/live/live_output.h"

#include <QEventLoop>
#include <QHostAddress>
#include <QThread>
#include <QTimer>
#include <QUdpSocket>
#include <atomic>
#include <future>
#include <mutex>
#include <optional>
#include <thread>

#include "robot/live/detail/allowed_origins.h"
#include "robot/live/detail/foxglove_server.h"
#include "robot/live/detail/sample_json.h"
#include "robot/realtime/thread_priority.h"
#include "robot/recording/mcap/robot_state_message.h"
#include "robot/recording/mcap/ros_messages.h"

namespace tiller::live {

namespace {

using namespace recording::mcap;

// Two or three packages at 500 Hz. A shorter interval would not be visible.
constexpr std::chrono::milliseconds kSendEvery{5};
constexpr std::uint32_t kJointStates = 1;
constexpr std::uint32_t kWrench = 2;
constexpr std::uint32_t kTransform = 3;
constexpr std::uint32_t kFirstState = 10;

}  // namespace

struct LiveOutput::Worker {
    LiveOptions options;
    std::shared_ptr<const receive::SampleLayout> layout;
    receive::Subscription subscription;
    std::int64_t steadyToUtc = 0;  ///< [ns]

    std::thread thread;
    std::atomic<bool> stopping{false};
    std::atomic<std::uint16_t> port{0};
    std::atomic<int> viewers{0};
    std::atomic<std::uint64_t> packets{0};
    std::atomic<std::uint64_t> messages{0};
    std::atomic<std::uint64_t> dropped{0};
    std::atomic<std::uint64_t> datagrams{0};
    std::atomic<std::uint64_t> disconnected{0};
    std::atomic<std::uint64_t> refused{0};
    std::mutex mutex;
    QString refusedOrigin;  ///< protected by the mutex

    // Used by the thread only.
    std::unique_ptr<FoxgloveServer> server;
    std::unique_ptr<QUdpSocket> udp;
    QHostAddress udpHost;
    receive::Sample sample;
    std::optional<RobotStateMessage> state;
    std::uint32_t stateChannel = kFirstState;
    std::uint64_t connection = 0;
    std::uint64_t lastSequence = 0;
    std::string bytes;

    Result<void> open() {
        if (!options.listenAddress.isEmpty()) {
            auto origins = AllowedOrigins::from(options.allowedOrigins);
            if (!origins) {
                return origins.error();
            }
            server = std::make_unique<FoxgloveServer>(options.name, *origins, options.limits);
            if (auto listening = server->listen(options.listenAddress, options.port); !listening) {
                return listening;
            }
            port = server->port();
            advertise(kJointStates, "/joint_states", jointStateType());
            advertise(kWrench, "/wrench", wrenchType());
            advertise(kTransform, "/tf", transformType());
        }
        if (!options.udpAddress.isEmpty()) {
            if (!udpHost.setAddress(options.udpAddress)) {
                return Error{ErrorCode::AddressInvalid, QStringLiteral("send to %1").arg(options.udpAddress),
                             QStringLiteral("this is not an IP address; use an address such as 127.0.0.1")};
            }
            udp = std::make_unique<QUdpSocket>();
        }
        return {};
    }

    void advertise(std::uint32_t id, const char* topic, const MessageType& type) {
        server->advertise({id, topic, type.name, type.definition});
    }

    void run(std::promise<Result<void>> opened) {
        realtime::nameThread("tiller-live");
        QEventLoop loop;
        auto ready = open();
        const bool ok = ready.ok();
        opened.set_value(std::move(ready));
        if (ok) {
            sample = receive::Sample(layout);
            QTimer timer;
            timer.setTimerType(Qt::PreciseTimer);
            QObject::connect(&timer, &QTimer::timeout, &loop, [this, &loop] {
                if (stopping) {
                    loop.quit();
                    return;
                }
                sendOn();
            });
            timer.start(kSendEvery);
            loop.exec();
        }
        server.reset();
        udp.reset();
    }

    void sendOn() {
        while (subscription.next(sample)) {
            const std::uint64_t overrun = lastSequence == 0 ? 0 : sample.sequence - lastSequence - 1;
            lastSequence = sample.sequence;
            const auto utcNs = sample.hostTimeNs + steadyToUtc;
            if (server) {
                toViewers(overrun + sample.lostBefore, utcNs);
            }
            if (udp) {
                writeJson(sample, options.fields, bytes);
                const qint64 sent = udp->writeDatagram(bytes.data(), static_cast<qint64>(bytes.size()),
                                                       udpHost, options.udpPort);
                datagrams += sent > 0 ? 1 : 0;
            }
            ++packets;
        }
        if (server) {
            viewers = server->viewers();
            messages = server->sent();
            dropped = server->dropped();
            disconnected = server->disconnected();
            if (refused != server->refused()) {
                const std::lock_guard lock(mutex);
                refusedOrigin = server->refusedOrigin();
                refused = server->refused();
            }
        }
    }

    void toViewers(std::uint64_t lost, std::int64_t utcNs) {
        if (!state || sample.connection != connection) {
            RobotStateMessage fresh(options.fields, sample);
            if (!state || fresh.definition() != state->definition()) {
                // A different robot may send different fields. The definition of a channel is immutable, so a
                // new channel number is used.
                server->advertise({++stateChannel, kStateTopic, kStateType, fresh.definition()});
            }
            state = std::move(fresh);
            connection = sample.connection;
        }
        const auto time = static_cast<std::uint64_t>(utcNs);
        if (server->isWanted(stateChannel)) {
            state->write(sample, lost, bytes);
            server->send(stateChannel, time, bytes);
        }
        if (server->isWanted(kJointStates) && writeJointState(sample, utcNs, bytes)) {
            server->send(kJointStates, time, bytes);
        }
        if (server->isWanted(kWrench) && writeWrench(sample, utcNs, bytes)) {
            server->send(kWrench, time, bytes);
        }
        if (server->isWanted(kTransform) && writeTransform(sample, utcNs, bytes)) {
            server->send(kTransform, time, bytes);
        }
    }
};

LiveOutput::LiveOutput() = default;

LiveOutput::~LiveOutput() {
    stop();
}

Result<void> LiveOutput::start(const LiveOptions& options, const receive::Receiver& receiver) {
    stop();
    auto next = std::make_unique<Worker>();
    next->options = options;
    next->layout = receiver.layout();
    for (const std::string& field : options.fields) {
        if (next->layout->find(field) == nullptr) {
            return Error{ErrorCode::FieldUnknown, QStringLiteral("forward the data of the robot"),
                         QStringLiteral("the receiver does not receive \"%1\"").arg(Text(field))};
        }
    }
    if (options.fields.empty()) {
        for (const auto& entry : next->layout->entries()) {
            next->options.fields.push_back(entry.name);
        }
    }
    next->subscription = receiver.subscribe();
    const auto utc = std::chrono::system_clock::now().time_since_epoch();
    next->steadyToUtc =
        std::chrono::duration_cast<std::chrono::nanoseconds>(utc).count() - SteadyClock::shared().nowNs();
    std::promise<Result<void>> opened;
    auto ready = opened.get_future();
    next->thread = std::thread(
        [worker = next.get(), promise = std::move(opened)]() mutable { worker->run(std::move(promise)); });
    Result<void> result = ready.get();
    if (!result) {
        next->thread.join();
        return result;
    }
    d_ = std::move(next);
    return {};
}

void LiveOutput::stop() {
    if (d_) {
        d_->stopping = true;
        d_->thread.join();
        d_.reset();
    }
}

LiveProgress LiveOutput::progress() const {
    if (!d_) {
        return {};
    }
    const std::lock_guard lock(d_->mutex);
    return {d_->viewers,   d_->packets,      d_->messages, d_->dropped,
            d_->datagrams, d_->disconnected, d_->refused,  d_->refusedOrigin};
}

std::uint16_t LiveOutput::port() const {
    return d_ ? d_->port.load() : std::uint16_t(0);
}

}  // namespace tiller::live
