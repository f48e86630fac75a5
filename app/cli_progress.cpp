// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli_progress.h"

#include <QTextStream>
#include <cstdio>

#ifdef _WIN32
#include <io.h>
#else
#include <unistd.h>
#endif

namespace tiller::app {

namespace {

bool isTerminal() {
#ifdef _WIN32
    return _isatty(_fileno(stderr)) != 0;
#else
    return ::isatty(STDERR_FILENO) != 0;
#endif
}

}  // namespace

ProgressLine::ProgressLine(bool wanted) : wanted_(wanted && isTerminal()) {}

void ProgressLine::show(const QString& text) {
    const auto now = std::chrono::steady_clock::now();
    if (!wanted_ || now < due_) {
        return;
    }
    constexpr std::chrono::milliseconds kEvery{500};
    due_ = now + kEvery;
    QTextStream(stderr) << '\r' << text.leftJustified(width_) << Qt::flush;
    width_ = text.size();
}

void ProgressLine::clear() {
    if (width_ > 0) {
        QTextStream(stderr) << '\r' << QString(width_, ' ') << '\r' << Qt::flush;
        width_ = 0;
    }
}

}  // namespace tiller::app
