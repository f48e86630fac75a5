// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/termination.h"

#ifdef _WIN32
#include <windows.h>
#else
#include <csignal>
#include <ctime>
#include <thread>
#endif

namespace tiller::app {

#ifdef _WIN32

namespace {

/// The event is never reset, because a terminal may send several console events.
HANDLE endRequested() {
    static const HANDLE event = CreateEventW(nullptr, TRUE, FALSE, nullptr);
    return event;
}

BOOL WINAPI onConsoleEvent(DWORD type) {
    SetEvent(endRequested());
    if (type != CTRL_C_EVENT && type != CTRL_BREAK_EVENT) {
        // The window of the terminal closes, or the user logs off: Windows ends the process when this
        // function returns, or after a few seconds. Before that, the main thread stops the motion and ends
        // the process.
        Sleep(INFINITE);
    }
    return TRUE;
}

}  // namespace

void holdTerminationSignals() {
    endRequested();
    SetConsoleCtrlHandler(onConsoleEvent, TRUE);
}

void waitForTermination() {
    WaitForSingleObject(endRequested(), INFINITE);
}

bool waitForTermination(std::chrono::milliseconds atMost) {
    return WaitForSingleObject(endRequested(), static_cast<DWORD>(atMost.count())) == WAIT_OBJECT_0;
}

#else

namespace {
sigset_t terminationSignals() {
    sigset_t set;
    sigemptyset(&set);
    sigaddset(&set, SIGINT);
    sigaddset(&set, SIGTERM);
    return set;
}
}  // namespace

void holdTerminationSignals() {
    const sigset_t set = terminationSignals();
    pthread_sigmask(SIG_BLOCK, &set, nullptr);
}

void waitForTermination() {
    const sigset_t set = terminationSignals();
    int signal = 0;
    sigwait(&set, &signal);
}

bool waitForTermination(std::chrono::milliseconds atMost) {
    const sigset_t set = terminationSignals();
#ifdef __APPLE__
    // macOS has no sigtimedwait(), so wait for the whole time and then check for a pending signal.
    std::this_thread::sleep_for(atMost);
    sigset_t pending;
    sigpending(&pending);
    return sigismember(&pending, SIGINT) == 1 || sigismember(&pending, SIGTERM) == 1;
#else
    const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(atMost);
    timespec time{};
    time.tv_sec = static_cast<time_t>(seconds.count());
    time.tv_nsec = static_cast<long>(std::chrono::nanoseconds(atMost - seconds).count());
    return sigtimedwait(&set, nullptr, &time) > 0;
#endif
}

#endif

}  // namespace tiller::app
