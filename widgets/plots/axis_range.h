// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A vertical scale that is calm: round steps, grows at once when a curve would leave it, shrinks only after
// the curves have kept far inside for a while.

namespace tiller {

class AxisRange {
public:
    /// smallestStep  the finest distance of two grid lines; noise is never blown up beyond it
    explicit AxisRange(double smallestStep);

    double min() const { return min_; }
    double max() const { return max_; }
    double step() const { return step_; }  ///< between two grid lines; 1, 2 or 5 times a power of ten

    /// The curves reach from low to high now. Low > high: no curve, nothing changes.
    /// seconds  passed since the last call; wide enough a scale for kPatience seconds is narrowed
    /// Returns  true when the scale changed
    bool fit(double low, double high, double seconds);
    /// Takes the best scale for low ... high at once.
    bool reset(double low, double high);

    /// Comes nearer (factor < 1) to this value; the scale stays as it is from then on, whatever the curves do.
    void zoom(double factor, double about);
    /// Shows low ... high, low < high, and stays.
    void hold(double low, double high);
    /// True between zoom() or hold() and release().
    bool isHeld() const { return held_; }
    /// The curves decide again, with the next fit() or reset().
    void release() { held_ = false; }

    /// How many grid lines there is room for; 2 at least. Takes effect with the next change of the scale.
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
