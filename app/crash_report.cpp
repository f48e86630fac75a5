// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/crash_report.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QStandardPaths>

#include "robot/core/file_reading.h"
#include "tiller_version.h"

#if __has_include(<execinfo.h>)
#define TILLER_HAS_BACKTRACE
#include <execinfo.h>
#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstring>
#endif

namespace tiller::app {
namespace {

/// A file that is larger than this [bytes] cannot be a report.
constexpr qint64 kLargestReport = 1'000'000;

}  // namespace

QString crashReportPath() {
    return QDir(QStandardPaths::writableLocation(QStandardPaths::AppDataLocation))
        .filePath(QStringLiteral("crash-report.txt"));
}

QByteArray readCrashReport(const QString& path) {
    const Result<QByteArray> report = readWholeFile(path, kLargestReport);
    return report ? *report : QByteArray();
}

#ifdef TILLER_HAS_BACKTRACE
namespace {

constexpr std::size_t kLines = 40;
constexpr std::size_t kLineLength = 240;
constexpr int kCalls = 64;
constexpr std::size_t kStack = 64 * 1024;
constexpr std::array kSignals = {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT};

/// Data for the signal handler, which must not allocate memory or lock a mutex.
struct CrashNotes {
    std::array<char, 4096> path{};
    std::array<std::array<char, kLineLength>, kLines> lines{};
    /// Number of lines added so far. Modulo kLines, it is the index of the next line in the ring.
    volatile std::sig_atomic_t next = 0;
    std::array<char, kStack> stack{};  ///< separate stack for the handler, needed after a stack overflow
};
CrashNotes crashNotes;

void put(int file, const char* text) {
    std::size_t rest = std::strlen(text);
    while (rest > 0) {
        const ssize_t written = ::write(file, text, rest);
        if (written <= 0) {
            return;
        }
        text += written;
        rest -= static_cast<std::size_t>(written);
    }
}

const char* nameOf(int signal) {
    switch (signal) {
        case SIGSEGV:
            return "SIGSEGV (invalid memory access)";
        case SIGBUS:
            return "SIGBUS (memory bus error)";
        case SIGFPE:
            return "SIGFPE (arithmetic error)";
        case SIGILL:
            return "SIGILL (illegal instruction)";
        case SIGABRT:
            return "SIGABRT (aborted by the program)";
        default:
            return "a signal";
    }
}

extern "C" void writeCrashReport(int signal) {
    const int file = ::open(crashNotes.path.data(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    if (file >= 0) {
        put(file, "Tiller " TILLER_VERSION " was terminated by ");
        put(file, nameOf(signal));
        put(file, "\n\nCall stack, most recent call first:\n");
        std::array<void*, kCalls> calls{};
        ::backtrace_symbols_fd(calls.data(), ::backtrace(calls.data(), kCalls), file);
        put(file, "\nLast lines of the log:\n");
        const auto next = static_cast<std::size_t>(crashNotes.next);
        for (std::size_t i = next - std::min(next, kLines); i < next; ++i) {
            put(file, crashNotes.lines[i % kLines].data());
            put(file, "\n");
        }
        ::close(file);
    }
    // SA_RESETHAND has restored the default action, so raising the signal again terminates the process by
    // this signal.
    ::raise(signal);
}

}  // namespace

void keepCrashReports(const QString& path) {
    QDir().mkpath(QFileInfo(path).absolutePath());
    const QByteArray bytes = QFile::encodeName(path);
    if (static_cast<std::size_t>(bytes.size()) >= crashNotes.path.size()) {
        return;
    }
    std::copy(bytes.begin(), bytes.end(), crashNotes.path.begin());
    // Call backtrace() once in advance. The first call loads a library, which is not permitted in the signal
    // handler.
    std::array<void*, 1> once{};
    ::backtrace(once.data(), 1);

    stack_t stack{};
    stack.ss_sp = crashNotes.stack.data();
    stack.ss_size = crashNotes.stack.size();
    ::sigaltstack(&stack, nullptr);
    struct sigaction action {};
    action.sa_handler = writeCrashReport;
    action.sa_flags = static_cast<int>(SA_ONSTACK | SA_RESETHAND | SA_NODEFER);
    for (const int signal : kSignals) {
        ::sigaction(signal, &action, nullptr);
    }
}

void rememberForCrash(const QString& line) {
    const QByteArray bytes = QString(line).replace(QLatin1Char('\n'), QLatin1Char(' ')).toUtf8();
    const auto next = static_cast<std::size_t>(crashNotes.next);
    auto& place = crashNotes.lines[next % kLines];
    const std::size_t length = std::min(static_cast<std::size_t>(bytes.size()), kLineLength - 1);
    std::copy_n(bytes.begin(), length, place.begin());
    place[length] = '\0';
    crashNotes.next = static_cast<std::sig_atomic_t>(next + 1);
}

#else

void keepCrashReports(const QString&) {}
void rememberForCrash(const QString&) {}

#endif

}  // namespace tiller::app
