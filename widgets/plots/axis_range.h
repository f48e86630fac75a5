// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A vertical scale that changes rarely. Steps are round numbers. The scale grows immediately if a curve would
// exceed it. It shrinks only after the curves have needed less space for 3 s.

namespace tiller {

class AxisRange {
public:
    /// smallestStep  minimum distance between grid lines, which limits how far noise is enlarged
    explicit AxisRange(double smallestStep);

    double min() const { return min_; }
    double max() const { return max_; }
    double step() const { return step_; }  ///< distance between grid lines; 1, 2 or 5 times a power of ten

    /// Adapts the scale to curves in the range low ... high. If low > high, there is no curve and the scale
    /// does not change.
    /// seconds  time since the last call; the scale shrinks only after it was too large for kShrinkDelay seconds
    /// Returns  true if the scale changed
    bool fit(double low, double high, double seconds);
    /// Sets the best scale for low ... high immediately.
    bool reset(double low, double high);

    /// Zooms in (factor < 1) around the value `about`. Until release(), the scale does not follow the curves.
    void zoom(double factor, double about);
    /// Shows low ... high, where low < high. Until release(), the scale does not follow the curves.
    void hold(double low, double high);
    /// True between zoom() or hold() and release().
    bool isHeld() const { return held_; }
    /// Lets the scale follow the curves again from the next fit() or reset().
    void release() { held_ = false; }

    /// Sets the maximum number of grid lines, at least 2. The next change of the scale uses it.
    void setMostLines(int lines);

    static constexpr double kShrinkDelay = 3.0;  ///< [s]

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
