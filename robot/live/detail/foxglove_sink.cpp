// SPDX-License-Identifier: MIT
//
// The messages for viewers that use the Foxglove WebSocket protocol.

#include <QEventLoop>
#include <memory>
#include <optional>
#include <string>

#include "robot/live/detail/allowed_origins.h"
#include "robot/live/detail/live_sinks.h"
#include "robot/receive/sample.h"
#include "robot/recording/mcap/robot_state_message.h"
#include "robot/recording/mcap/ros_messages.h"
#ifdef TILLER_HAS_WEBSOCKETS
#include "robot/live/detail/foxglove_server.h"
#else
#include "robot/live/detail/absent_server.h"
#endif

namespace tiller::live {

namespace {

using namespace recording::mcap;

constexpr std::uint32_t kJointStates = 1;
constexpr std::uint32_t kWrench = 2;
constexpr std::uint32_t kTransform = 3;
constexpr std::uint32_t kFirstState = 10;
/// Maximum time per turn in which the requests of viewers are processed.
constexpr int kRequestTimeMs = 2;

/// All sockets belong to the thread of the publisher.
class FoxgloveSink final : public publish::SampleSink {
public:
    explicit FoxgloveSink(const LiveSinkContext& context) : context_(context) {}

    Result<void> open() override {
        const LiveOptions& options = context_.options;
        auto origins = AllowedOrigins::from(options.allowedOrigins);
        if (!origins) {
            return origins.error();
        }
        loop_ = std::make_unique<QEventLoop>();
        server_ = std::make_unique<FoxgloveServer>(options.name, *origins, options.limits);
        if (auto listening = server_->listen(options.listenAddress, options.port); !listening) {
            close();
            return listening;
        }
        context_.counters->port = server_->port();
        advertise(kJointStates, "/joint_states", jointStateType());
        advertise(kWrench, "/wrench", wrenchType());
        advertise(kTransform, "/tf", transformType());
        return {};
    }

    void beginTurn() override { loop_->processEvents(QEventLoop::AllEvents, kRequestTimeMs); }

    Next take(const receive::Sample& sample, std::uint64_t missing) override {
        const std::int64_t utcNs = sample.hostTimeNs + context_.steadyToUtc;
        if (!state_ || sample.connection != connection_) {
            RobotStateMessage fresh(context_.options.fields, sample);
            if (!state_ || fresh.definition() != state_->definition()) {
                // A different robot may send different fields. The definition of a channel is immutable, so a
                // new channel number is used.
                server_->advertise({++stateChannel_, kStateTopic, kStateType, fresh.definition()});
            }
            state_ = std::move(fresh);
            connection_ = sample.connection;
        }
        const auto time = static_cast<std::uint64_t>(utcNs);
        if (server_->isWanted(stateChannel_)) {
            state_->write(sample, missing, bytes_);
            server_->send(stateChannel_, time, bytes_);
        }
        if (server_->isWanted(kJointStates) && writeJointState(sample, utcNs, bytes_)) {
            server_->send(kJointStates, time, bytes_);
        }
        if (server_->isWanted(kWrench) && writeWrench(sample, utcNs, bytes_)) {
            server_->send(kWrench, time, bytes_);
        }
        if (server_->isWanted(kTransform) && writeTransform(sample, utcNs, bytes_)) {
            server_->send(kTransform, time, bytes_);
        }
        return Next::Continue;
    }

    bool endTurn(bool last) override {
        LiveCounters& counters = *context_.counters;
        counters.viewers = server_->viewers();
        counters.messages = server_->sent();
        counters.dropped = server_->dropped();
        counters.disconnected = server_->disconnected();
        if (counters.refused != server_->refused()) {
            const std::lock_guard lock(counters.mutex);
            counters.refusedOrigin = server_->refusedOrigin();
            counters.refused = server_->refused();
        }
        return !last;
    }

    void close() override {
        server_.reset();
        loop_.reset();
    }

private:
    void advertise(std::uint32_t id, const char* topic, const MessageType& type) {
        server_->advertise({id, topic, type.name, type.definition});
    }

    const LiveSinkContext context_;
    std::unique_ptr<QEventLoop> loop_;
    std::unique_ptr<FoxgloveServer> server_;
    std::optional<RobotStateMessage> state_;
    std::uint32_t stateChannel_ = kFirstState;
    std::uint64_t connection_ = 0;
    std::string bytes_;
};

}  // namespace

std::shared_ptr<publish::SampleSink> foxgloveSink(const LiveSinkContext& context) {
    return context.options.listenAddress.isEmpty() ? nullptr : std::make_shared<FoxgloveSink>(context);
}

}  // namespace tiller::live
