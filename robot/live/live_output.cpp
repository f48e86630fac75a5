// SPDX-License-Identifier: MIT
#include "robot/live/live_output.h"

#include <algorithm>
#include <utility>

#include "robot/live/detail/live_sinks.h"
#include "robot/publish/publisher.h"

namespace tiller::live {

namespace {

// Interval between two transmissions: two or three packets at 500 Hz. A shorter interval would not be
// visible.
constexpr std::chrono::milliseconds kSendEvery{5};

}  // namespace

struct LiveOutput::Private {
    std::shared_ptr<LiveCounters> counters = std::make_shared<LiveCounters>();
    std::shared_ptr<publish::Publisher> publisher;
    std::vector<publish::Publication> publications;
};

LiveOutput::LiveOutput() = default;

LiveOutput::LiveOutput(std::shared_ptr<publish::Publisher> publisher) : publisher_(std::move(publisher)) {}

LiveOutput::~LiveOutput() {
    stop();
}

Result<void> LiveOutput::start(const LiveOptions& options, const receive::Receiver& receiver) {
    stop();
    auto next = std::make_unique<Private>();
    LiveSinkContext context{options, 0, next->counters};
    const auto layout = receiver.layout();
    for (const std::string& field : options.fields) {
        if (layout->find(field) == nullptr) {
            return Error{
                ErrorCode::FieldUnknown, QStringLiteral("forward the data of the robot"),
                QStringLiteral("the receiver was started without the field \"%1\"").arg(Text(field))};
        }
    }
    if (options.fields.empty()) {
        for (const auto& entry : layout->entries()) {
            context.options.fields.push_back(entry.name);
        }
    }
    const auto utc = std::chrono::system_clock::now().time_since_epoch();
    context.steadyToUtc =
        std::chrono::duration_cast<std::chrono::nanoseconds>(utc).count() - SteadyClock::shared().nowNs();
    next->publisher = publisher_ ? publisher_ : std::make_shared<publish::Publisher>();
    for (const LiveSinkKind& kind : liveSinkKinds()) {
        if (auto sink = kind.make(context)) {
            auto added = next->publisher->add({std::move(sink), receiver.subscribe(), layout, kSendEvery});
            if (!added) {
                return added.error();
            }
            next->publications.push_back(std::move(added).value());
        }
    }
    d_ = std::move(next);
    return {};
}

void LiveOutput::stop() {
    d_.reset();
}

LiveProgress LiveOutput::progress() const {
    if (!d_) {
        return {};
    }
    LiveProgress progress;
    for (const publish::Publication& publication : d_->publications) {
        progress.packets = std::max(progress.packets, publication.packets());
        progress.missed = std::max(progress.missed, publication.missed());
    }
    LiveCounters& counters = *d_->counters;
    progress.viewers = counters.viewers;
    progress.messages = counters.messages;
    progress.dropped = counters.dropped;
    progress.datagrams = counters.datagrams;
    progress.disconnected = counters.disconnected;
    progress.refused = counters.refused;
    const std::lock_guard lock(counters.mutex);
    progress.refusedOrigin = counters.refusedOrigin;
    return progress;
}

std::uint16_t LiveOutput::port() const {
    return d_ ? d_->counters->port.load() : std::uint16_t(0);
}

}  // namespace tiller::live
