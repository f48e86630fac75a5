// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The displayed time range of the plots. It follows the newest sample until it is paused or scrolled back.
// Data are still received while it does not follow.

namespace tiller {

class TimeWindow {
public:
    static constexpr double kShortest = 0.05;    ///< [s]
    static constexpr double kLongest = 86400.0;  ///< [s]

    double span() const { return span_; }
    double end() const { return end_; }
    double start() const { return end_ - span_; }
    /// Time of the newest sample [s].
    double newest() const { return newest_; }
    bool follows() const { return follows_; }
    /// Distance of the right edge from the newest sample [s]; 0 while following.
    double behind() const { return follows_ ? 0 : newest_ - end_; }

    /// Sets the times of the oldest and the newest sample [s].
    void setHistory(double oldest, double newest);
    /// Sets the span. Keeps the right edge while following the newest sample, and the centre otherwise.
    void setSpan(double seconds);
    void pause() { follows_ = false; }
    void follow();
    /// Shows exactly this range, limited to the history.
    void showRange(double from, double to);
    double oldest() const { return oldest_; }
    /// Scrolls by this time [s]; negative values scroll back. Returning to the newest sample does not end a
    /// pause.
    void scrollBy(double seconds);
    /// Zooms in (factor < 1). The time `anchor` keeps its position on the screen, unless the range follows
    /// the newest sample.
    void zoom(double factor, double anchor);

private:
    void keepInside();

    double span_ = 30;
    double end_ = 0;
    double oldest_ = 0;
    double newest_ = 0;
    bool follows_ = true;
};

}  // namespace tiller
