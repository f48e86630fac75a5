// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/axis_range.h"

#include <algorithm>
#include <cmath>

namespace tiller {

namespace {

constexpr double kEdge = 0.55;   // distance from the outermost grid line to the end of the scale [steps]
constexpr double kReach = 0.35;  // permitted excess of a curve beyond the outermost grid line [steps]

double niceStep(double least) {
    const double decade = std::pow(10.0, std::floor(std::log10(least)));
    for (double factor : {1.0, 2.0, 5.0, 10.0}) {
        if (factor * decade >= least * (1 - 1e-9)) {
            return factor * decade;
        }
    }
    return 10.0 * decade;
}

bool usable(double low, double high) {
    return std::isfinite(low) && std::isfinite(high) && low <= high;
}

}  // namespace

AxisRange::AxisRange(double smallestStep) : smallestStep_(smallestStep) {
    reset(0, 0);
}

AxisRange::Scale AxisRange::best(double low, double high) const {
    const double fewest = std::min(3, mostLines_) - 1;
    // With a smaller step or larger values, the numbers of the grid lines would not be exact.
    constexpr double kMaxLine = 1e9;
    constexpr double kMaxValue = 1e300;
    low = std::clamp(low, -kMaxValue, kMaxValue);
    high = std::clamp(high, -kMaxValue, kMaxValue);
    const double smallest = std::max(smallestStep_, std::max(std::abs(low), std::abs(high)) / kMaxLine);
    for (double step = niceStep(smallest);; step = niceStep(step * 1.5)) {
        // The outermost grid lines [steps]. A curve may exceed them by kReach.
        double bottom = std::floor(low / step + kReach);
        double top = std::ceil(high / step - kReach);
        // Include zero if it is at most two steps away.
        if (bottom > 0 && bottom <= 2) {
            bottom = 0;
        }
        if (top < 0 && top >= -2) {
            top = 0;
        }
        while (top - bottom < fewest) {
            if (top * step - high <= low - bottom * step) {
                top += 1;
            } else {
                bottom -= 1;
            }
        }
        if (top - bottom < mostLines_) {
            return {(bottom - kEdge) * step, (top + kEdge) * step, step};
        }
    }
}

void AxisRange::setMostLines(int lines) {
    mostLines_ = std::max(2, lines);
}

bool AxisRange::set(const Scale& scale) {
    tooWideFor_ = 0;
    const bool changed = scale.min != min_ || scale.max != max_ || scale.step != step_;
    min_ = scale.min;
    max_ = scale.max;
    step_ = scale.step;
    return changed;
}

void AxisRange::zoom(double factor, double about) {
    constexpr double kNarrowest = 0.01;  // [minimum steps]
    constexpr double kWidest = 1e4;
    const double span =
        std::clamp((max_ - min_) * factor, kNarrowest * smallestStep_, kWidest * smallestStep_);
    const double below = (about - min_) / (max_ - min_);
    set({about - below * span, about + (1 - below) * span, niceStep(span / mostLines_)});
    held_ = true;
}

void AxisRange::hold(double low, double high) {
    if (usable(low, high) && low < high) {
        set({low, high, niceStep((high - low) / mostLines_)});
        held_ = true;
    }
}

bool AxisRange::reset(double low, double high) {
    return !held_ && usable(low, high) && set(best(low, high));
}

bool AxisRange::fit(double low, double high, double seconds) {
    if (held_ || !usable(low, high)) {
        return false;
    }
    if (low < min_ || high > max_) {
        // Extend one side without reducing the other side.
        return set(best(std::min(low, min_ + kEdge * step_), std::max(high, max_ - kEdge * step_)));
    }
    const Scale narrower = best(low, high);
    if (narrower.max - narrower.min > 0.75 * (max_ - min_)) {
        tooWideFor_ = 0;
        return false;
    }
    tooWideFor_ += seconds;
    return tooWideFor_ >= kShrinkDelay ? set(narrower) : false;
}

}  // namespace tiller
