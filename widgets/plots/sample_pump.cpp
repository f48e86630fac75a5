// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/sample_pump.h"

#include <cmath>

namespace tiller {

namespace {

/// A controller that starts again begins its time anew; its first sample is put this far behind the last. [s]
constexpr double kRestartDistance = 0.1;
/// A hole of more than this many times the last distance is one, whoever counted what.
constexpr double kHole = 3.5;

}  // namespace

SamplePump::SamplePump(SeriesBuffer& history, QObject* parent) : QObject(parent), history_(history) {
    timer_.setTimerType(Qt::PreciseTimer);
    timer_.setInterval(kFrameMs);
    connect(&timer_, &QTimer::timeout, this, &SamplePump::pump);
}

SamplePump::~SamplePump() = default;

void SamplePump::setSource(std::unique_ptr<PlotSource> source) {
    source_ = std::move(source);
    gapPending_ = any_;
    lastSequence_ = 0;
}

void SamplePump::start() {
    timer_.start();
}

void SamplePump::stop() {
    timer_.stop();
}

void SamplePump::pump() {
    added_ = 0;
    if (source_ != nullptr) {
        const std::uint64_t lost = source_->drain([this](const PlotRow& row) { take(row); });
        overrun_ += lost;
    }
    Q_EMIT frame(added_);
}

void SamplePump::take(const PlotRow& row) {
    if (!std::isfinite(row.robotTime)) {
        return;
    }
    bool gap = row.gapBefore || gapPending_;
    if (any_) {
        gap = gap || (lastSequence_ != 0 && row.sequence != lastSequence_ + 1);
        const double forward = row.robotTime - lastRobotTime_;
        if (forward <= 0) {
            if (row.sequence == lastSequence_) {
                return;
            }
            // The controller began its time anew.
            offset_ = history_.lastTime() + kRestartDistance - row.robotTime;
            gap = true;
        } else if (lastStep_ > 0 && forward > kHole * lastStep_) {
            gap = true;
        }
        if (forward > 0 && !gap) {
            lastStep_ = forward;
        }
    }
    lastRobotTime_ = row.robotTime;
    lastSequence_ = row.sequence;
    if (!history_.append(plotTime(row.robotTime), row.values, gap)) {
        return;
    }
    any_ = true;
    gapPending_ = false;
    gaps_ += gap ? 1 : 0;
    ++added_;
}

}  // namespace tiller
