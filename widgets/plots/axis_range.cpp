// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/axis_range.h"

#include <algorithm>
#include <cmath>

namespace tiller {

namespace {

constexpr int kMostLines = 5;     // grid lines of one scale
constexpr double kMargin = 0.35;  // of a step, beyond the outermost curve

double niceStep(double least) {
    const double decade = std::pow(10.0, std::floor(std::log10(least)));
    for (double factor : {1.0, 2.0, 5.0, 10.0}) {
        if (factor * decade >= least * (1 - 1e-9)) {
            return factor * decade;
        }
    }
    return 10.0 * decade;
}

}  // namespace

AxisRange::AxisRange(double smallestStep) : smallestStep_(smallestStep) {
    reset(0, 0);
}

AxisRange::Scale AxisRange::best(double low, double high) const {
    for (double step = niceStep(smallestStep_);; step = niceStep(step * 1.5)) {
        // Grid lines at multiples of the step; the scale ends half a step beyond the outermost.
        double bottom = std::floor(low / step + 0.5 - kMargin) * step;
        double top = std::ceil(high / step - 0.5 + kMargin) * step;
        if (bottom > 0 && bottom <= 2 * step) {
            bottom = 0;
        }
        if (top < 0 && top >= -2 * step) {
            top = 0;
        }
        // Never fewer than three lines: one alone says nothing of the scale.
        while (std::lround((top - bottom) / step) < 2) {
            (high - top > bottom - low ? top : bottom) += high - top > bottom - low ? step : -step;
        }
        if (std::lround((top - bottom) / step) < kMostLines) {
            return {bottom - 0.55 * step, top + 0.55 * step, step};
        }
    }
}

bool AxisRange::set(const Scale& scale) {
    tooWideFor_ = 0;
    const bool changed = scale.min != min_ || scale.max != max_ || scale.step != step_;
    min_ = scale.min;
    max_ = scale.max;
    step_ = scale.step;
    return changed;
}

bool AxisRange::reset(double low, double high) {
    return low > high ? false : set(best(low, high));
}

bool AxisRange::fit(double low, double high, double seconds) {
    if (!(low <= high)) {
        return false;
    }
    if (low < min_ || high > max_) {
        // Grow, but do not let go of what is shown on the other side in the same moment.
        return set(best(std::min(low, min_ + 0.55 * step_), std::max(high, max_ - 0.55 * step_)));
    }
    const Scale narrower = best(low, high);
    if (narrower.max - narrower.min > 0.75 * (max_ - min_)) {
        tooWideFor_ = 0;
        return false;
    }
    tooWideFor_ += seconds;
    return tooWideFor_ >= kPatience ? set(narrower) : false;
}

}  // namespace tiller
