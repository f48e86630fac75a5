// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Which stretch of time the plots show. It follows the newest sample until somebody pauses it or goes back in
// history; data go on arriving meanwhile.

namespace tiller {

class TimeWindow {
public:
    static constexpr double kShortest = 0.05;    ///< [s]
    static constexpr double kLongest = 86400.0;  ///< [s]

    double span() const { return span_; }
    double end() const { return end_; }
    double start() const { return end_ - span_; }
    /// The newest sample known [s].
    double newest() const { return newest_; }
    bool follows() const { return follows_; }
    /// How far the right edge is behind the newest sample [s]; 0 while following.
    double behind() const { return follows_ ? 0 : newest_ - end_; }

    /// The history reaches from oldest to newest.
    void setHistory(double oldest, double newest);
    /// Keeps the right edge while following, the middle otherwise.
    void setSpan(double seconds);
    void pause() { follows_ = false; }
    void follow();
    /// Exactly this stretch, where it lies within the history.
    void showRange(double from, double to);
    double oldest() const { return oldest_; }
    /// Negative goes back. Coming back to the newest sample does not start following: a pause stays one.
    void scrollBy(double seconds);
    /// factor < 1 zooms in. The moment `anchor` keeps its place on the screen, unless following.
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
