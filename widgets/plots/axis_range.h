// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A vertical scale with few changes: round steps, immediate growth when a curve would exceed it, and reduction only
// after the curves have needed less space for a while.

namespace tiller {

class AxisRange {
public:
    /// smallestStep  minimum distance of grid lines, so that noise is not enlarged further
    explicit AxisRange(double smallestStep);

    double min() const { return min_; }
    double max() const { return max_; }
    double step() const { return step_; }  ///< distance of grid lines; 1, 2 or 5 times a power of ten

    /// Adapts the scale to curves from low to high. Low > high: there is no curve, and the scale does not
    /// change.
    /// seconds  since the last call; a scale that is too large for kPatience seconds is reduced
    /// Returns  true if the scale changed
    bool fit(double low, double high, double seconds);
    /// Sets the best scale for low ... high immediately.
    bool reset(double low, double high);

    /// Zooms in (factor < 1) around this value; afterwards the scale is independent of the curves.
    void zoom(double factor, double about);
    /// Shows low ... high, low < high, independent of the curves.
    void hold(double low, double high);
    /// True between zoom() or hold() and release().
    bool isHeld() const { return held_; }
    /// Adapts to the curves again, with the next fit() or reset().
    void release() { held_ = false; }

    /// Maximum number of grid lines, at least 2. Takes effect at the next change of the scale.
    void setMostLines(int lines);

    static constexpr double kPatience = 3.0;  ///< [s]

private:
    struct Scale {
        double min, max, step;
    };
    Scale best(double low, double high) const;
    bool set(const Scale& scale);

    double smallestStep_;
    int mostLines_ = 4;
    double min_ = -1;
    double max_ = 1;
    double step_ = 1;
    double tooWideFor_ = 0;
    bool held_ = false;
};

}  // namespace tiller
