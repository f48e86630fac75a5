// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// One line on a terminal that is written over and over; nothing where there is none, as under systemd.

#include <QString>
#include <chrono>

namespace tiller::app {

class ProgressLine {
public:
    explicit ProgressLine(bool wanted);
    ~ProgressLine() { clear(); }
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;

    /// At most twice a second.
    void show(const QString& text);
    void clear();

private:
    bool wanted_;
    qsizetype width_ = 0;
    std::chrono::steady_clock::time_point due_ = {};
};

}  // namespace tiller::app
