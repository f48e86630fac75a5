// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/plot_playback.h"

#include <algorithm>
#include <chrono>

#include "robot/station/history/signal_store.h"
#include "widgets/plots/plot_pages.h"
#include "widgets/plots/plot_view.h"

namespace tiller {

namespace {

constexpr std::chrono::milliseconds kStep{33};
constexpr double kSecondsPerNs = 1e-9;

}  // namespace

PlotPlayback::PlotPlayback(const SignalStore& store, PlotPages& pages, QObject* parent)
    : QObject(parent), store_(store), pages_(pages) {
    timer_.setTimerType(Qt::PreciseTimer);
    timer_.setInterval(kStep);
    connect(&timer_, &QTimer::timeout, this, &PlotPlayback::step);
}

std::pair<double, double> PlotPlayback::range() const {
    const QString source = pages_.view().recordingInFront();
    const SeriesBuffer* times = source.isEmpty() ? &store_.live() : store_.timesOf(source);
    return times == nullptr || times->isEmpty() ? std::pair(0.0, 0.0)
                                                : std::pair(times->firstTime(), times->lastTime());
}

bool PlotPlayback::start(double speed) {
    const auto [first, last] = range();
    if (first >= last) {
        return false;
    }
    PlotView& view = pages_.view();
    source_ = view.recordingInFront();
    if (source_.isEmpty()) {
        view.pause();
    }
    const TimeWindow& window = view.window();
    const auto cursor = view.cursor(PlotView::Cursor::A);
    const bool isVisible = cursor && *cursor >= window.start() && *cursor <= window.end();
    end_ = last;
    const double from = std::clamp(isVisible ? *cursor : window.start(), first, last);
    view.goTo(from < last ? from : first);
    speed_ = speed;
    clock_.start();
    timer_.start();
    return true;
}

void PlotPlayback::stop() {
    timer_.stop();
}

void PlotPlayback::step() {
    const double elapsed = static_cast<double>(clock_.nsecsElapsed()) * kSecondsPerNs;
    clock_.start();
    PlotView& view = pages_.view();
    const auto cursor = view.cursor(PlotView::Cursor::A);
    const double first = range().first;
    // The playback ends if another page is shown, the cursor is removed, or the live page follows the data again.
    if (!cursor || first >= end_ || view.recordingInFront() != source_ ||
        (source_.isEmpty() && view.window().follows())) {
        stop();
        return;
    }
    // If the person has moved the cursor, continue from there.
    const double to = std::min(std::max(*cursor, first) + elapsed * speed_, end_);
    view.goTo(to);
    if (to >= end_) {
        stop();
    }
}

}  // namespace tiller

#include "moc_plot_playback.cpp"
