// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/plot_replay.h"

#include <algorithm>
#include <cmath>

#include "robot/core/clock.h"
#include "robot/station/history/signal_store.h"
#include "widgets/plots/plot_pages.h"
#include "widgets/plots/plot_view.h"

namespace tiller {

PlotReplay::PlotReplay(const SignalStore& store, const PlotPages& pages, QObject* parent)
    : QObject(parent), store_(store), pages_(pages) {}

void PlotReplay::noteFrame(double newest, const QDateTime& now) {
    if (frames_.empty() || newest > frames_.back().newest) {
        frames_.push_back({newest, now.toMSecsSinceEpoch(), SteadyClock::shared().nowNs()});
    }
}

void PlotReplay::forgetBefore(double time) {
    while (frames_.size() > 1 && frames_[1].newest < time) {
        frames_.pop_front();
    }
}

QDateTime PlotReplay::wallTimeOf(double time) const {
    const auto frame = std::lower_bound(frames_.begin(), frames_.end(), time,
                                        [](const Frame& each, double at) { return each.newest < at; });
    if (frame == frames_.end()) {
        return {};
    }
    // Log entries up to the next frame belong to this frame, so return the last millisecond before the next
    // frame.
    const auto next = frame + 1;
    const std::int64_t last =
        next == frames_.end() ? frame->wallMs : std::max(frame->wallMs, next->wallMs - 1);
    return QDateTime::fromMSecsSinceEpoch(last);
}

QDateTime PlotReplay::clockAt(double time) const {
    constexpr double kMsPerSecond = 1e3;
    if (const QString source = pages_.view().recordingInFront(); !source.isEmpty()) {
        const auto start = store_.recorded(source)->startUtcNs();
        const double since = time - store_.timesOf(source)->firstTime();
        return start ? QDateTime::fromMSecsSinceEpoch(*start / kNsPerMs + std::llround(since * kMsPerSecond))
                     : QDateTime();
    }
    if (frames_.empty()) {
        return {};
    }
    const Frame& frame = frameAt(time);
    return QDateTime::fromMSecsSinceEpoch(frame.wallMs + std::llround((time - frame.newest) * kMsPerSecond));
}

const PlotReplay::Frame& PlotReplay::frameAt(double time) const {
    const auto frame = std::lower_bound(frames_.begin(), frames_.end(), time,
                                        [](const Frame& each, double at) { return each.newest < at; });
    return frame == frames_.end() ? frames_.back() : *frame;
}

std::int64_t PlotReplay::noteUtcNs(double time) const {
    const std::int64_t nowNs = QDateTime::currentMSecsSinceEpoch() * kNsPerMs;
    if (frames_.empty()) {
        return nowNs;
    }
    const Frame& frame = frameAt(time);
    const auto sinceFrameNs = std::llround((time - frame.newest) * static_cast<double>(kNsPerSecond));
    return nowNs - (SteadyClock::shared().nowNs() - frame.steadyNs - sinceFrameNs);
}

std::optional<double> PlotReplay::timeAt(const QDateTime& clock) const {
    constexpr double kSecondsPerMs = 1e-3;
    const std::int64_t wall = clock.toMSecsSinceEpoch();
    if (const QString source = pages_.view().recordingInFront(); !source.isEmpty()) {
        const auto start = store_.recorded(source)->startUtcNs();
        const SeriesBuffer& times = *store_.timesOf(source);
        const double since = start ? static_cast<double>(wall - *start / kNsPerMs) * kSecondsPerMs : -1;
        const bool isInside = since >= 0 && since <= times.lastTime() - times.firstTime();
        return isInside ? std::optional(times.firstTime() + since) : std::nullopt;
    }
    // Log entries belong to the last frame before them; see wallTimeOf().
    const auto next = std::upper_bound(frames_.begin(), frames_.end(), wall,
                                       [](std::int64_t at, const Frame& each) { return at < each.wallMs; });
    const bool isKnown = next != frames_.begin() && !store_.live().isEmpty() &&
                         (next - 1)->newest >= store_.live().firstTime();
    return isKnown ? std::optional((next - 1)->newest) : std::nullopt;
}

QString PlotReplay::recordingInFront() const {
    return pages_.view().recordingInFront();
}

std::shared_ptr<const std::vector<recording::RecordedEvent>> PlotReplay::eventsOf(
    const QString& recording) const {
    std::vector<recording::RecordedEvent> events = store_.recorded(recording)->events();
    const std::vector<recording::RecordedEvent> further = further_.value(recording);
    events.insert(events.end(), further.begin(), further.end());
    std::stable_sort(events.begin(), events.end(),
                     [](const auto& a, const auto& b) { return a.seconds < b.seconds; });
    return std::make_shared<const std::vector<recording::RecordedEvent>>(std::move(events));
}

void PlotReplay::setFurtherEvents(const QString& recording, std::vector<recording::RecordedEvent> events) {
    if (events.empty() && !further_.contains(recording)) {
        return;
    }
    further_[recording] = std::move(events);
    if (moment_ && moment_->source == recording && store_.recorded(recording) != nullptr) {
        moment_->events = eventsOf(recording);
        Q_EMIT changed(moment_);
    }
}

Replay PlotReplay::momentNow() const {
    const PlotView& view = pages_.view();
    const auto time = view.cursor(PlotView::Cursor::A);
    const QString source = view.recordingInFront();
    if (!time || (source.isEmpty() && view.window().follows())) {
        return {};
    }
    ReplayMoment moment;
    moment.source = source;
    moment.time = *time;
    // True if the sample is already displayed and need not be read again.
    const bool same =
        moment_ && moment_->source == source && moment_->time == *time && !moment_->sample.isEmpty();
    moment.sample = same ? moment_->sample : store_.sampleAt(source, *time);
    if (source.isEmpty()) {
        moment.wallTime = wallTimeOf(*time);
        if (const HistoryRobot* robot = store_.robotAt(*time); robot != nullptr) {
            moment.model = robot->model;
            moment.robot = store_.isNewest(*robot) ? QString() : robot->name;
        }
        return moment;
    }
    const auto& facts = store_.recorded(source)->facts();
    if (const auto model = facts.find("model"); model != facts.end()) {
        moment.model = robotModelByName(QString::fromStdString(model->second));
    }
    moment.seconds = *time - store_.timesOf(source)->firstTime();
    moment.events = same || (moment_ && moment_->source == source) ? moment_->events : eventsOf(source);
    moment.wallTime = clockAt(*time);
    return moment;
}

void PlotReplay::follow() {
    Replay now = momentNow();
    const bool same = now.has_value() == moment_.has_value() &&
                      (!now || (now->source == moment_->source && now->time == moment_->time &&
                                now->sample.isEmpty() == moment_->sample.isEmpty() &&
                                now->robot == moment_->robot && now->model == moment_->model));
    if (!same) {
        moment_ = std::move(now);
        Q_EMIT changed(moment_);
    }
}

}  // namespace tiller

#include "moc_plot_replay.cpp"
