// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A progress line on a terminal. Each update overwrites the line. Without a terminal, e.g. under systemd,
// nothing is printed.

#include <QString>
#include <chrono>

namespace tiller::app {

class ProgressLine {
public:
    explicit ProgressLine(bool wanted);
    ~ProgressLine() { clear(); }
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;

    /// Updates the line at most twice per second.
    void show(const QString& text);
    void clear();

private:
    bool wanted_;
    qsizetype width_ = 0;
    std::chrono::steady_clock::time_point due_ = {};
};

}  // namespace tiller::app
