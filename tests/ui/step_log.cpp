// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/step_log.h"

#include <QByteArray>
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>

#ifdef Q_OS_UNIX
#include <signal.h>
#include <unistd.h>
#endif

namespace tiller::test {
namespace {

// Preallocated memory, because no memory can be allocated after a crash.
constexpr std::size_t kLength = 240;
using Line = std::array<char, kLength>;
Line titleLine{};
std::array<Line, StepLog::kKept> lines{};
int next = 0;

void put(Line& line, const QString& text) {
    const QByteArray bytes = text.toUtf8();
    const std::size_t length = std::min(static_cast<std::size_t>(bytes.size()), kLength - 2);
    std::memcpy(line.data(), bytes.constData(), length);
    line[length] = '\n';
    line[length + 1] = '\0';
}

template <class Visitor>
void visit(const Visitor& visitor) {
    visitor(titleLine);
    for (int i = 0; i < StepLog::kKept; ++i) {
        visitor(lines[static_cast<std::size_t>((next + i) % StepLog::kKept)]);
    }
}

#ifdef Q_OS_UNIX
constexpr int kSignals[] = {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT};
struct sigaction before[std::size(kSignals)];

void onCrash(int number) {
    visit([](const Line& line) {
        const std::size_t length = std::strlen(line.data());
        if (length > 0 && ::write(STDERR_FILENO, line.data(), length) < 0) {
            return;
        }
    });
    // Restore the previous handlers, so that the crash occurs again and is reported as before.
    for (std::size_t i = 0; i < std::size(kSignals); ++i) {
        if (kSignals[i] == number) {
            ::sigaction(number, &before[i], nullptr);
        }
    }
}
#endif

}  // namespace

void StepLog::begin(const QString& title) {
    next = 0;
    for (Line& line : lines) {
        line[0] = '\0';
    }
    put(titleLine, title);
}

void StepLog::add(const QString& step) {
    put(lines[static_cast<std::size_t>(next)], step);
    next = (next + 1) % kKept;
}

QString StepLog::text() {
    QString all;
    visit([&all](const Line& line) { all += QString::fromUtf8(line.data()); });
    return all;
}

void StepLog::printOnCrash() {
#ifdef Q_OS_UNIX
    struct sigaction action {};
    action.sa_handler = onCrash;
    action.sa_flags = SA_ONSTACK;
    for (std::size_t i = 0; i < std::size(kSignals); ++i) {
        ::sigaction(kSignals[i], &action, &before[i]);
    }
#endif
}

}  // namespace tiller::test
