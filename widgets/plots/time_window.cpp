// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/time_window.h"

#include <algorithm>

namespace tiller {

void TimeWindow::setHistory(double oldest, double newest) {
    oldest_ = oldest;
    newest_ = newest;
    if (follows_) {
        end_ = newest;
    }
}

void TimeWindow::setSpan(double seconds) {
    const double middle = end_ - span_ / 2;
    span_ = std::clamp(seconds, kShortest, kLongest);
    if (follows_) {
        end_ = newest_;
    } else {
        end_ = middle + span_ / 2;
        keepInside();
    }
}

void TimeWindow::follow() {
    follows_ = true;
    end_ = newest_;
}

void TimeWindow::showRange(double from, double to) {
    follows_ = false;
    span_ = std::clamp(to - from, kShortest, kLongest);
    end_ = (from + to) / 2 + span_ / 2;
    keepInside();
}

void TimeWindow::scrollBy(double seconds) {
    follows_ = false;
    end_ += seconds;
    keepInside();
}

void TimeWindow::zoom(double factor, double anchor) {
    const double before = span_;
    span_ = std::clamp(span_ * factor, kShortest, kLongest);
    if (follows_) {
        end_ = newest_;
    } else {
        end_ = anchor + (end_ - anchor) * (span_ / before);
        keepInside();
    }
}

void TimeWindow::keepInside() {
    // The range must not extend beyond the newest sample, and should not start before the oldest sample. If
    // both are impossible, the first rule has priority.
    end_ = std::min(std::max(end_, oldest_ + span_), newest_);
}

}  // namespace tiller
