// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/termination.h"

#ifdef _WIN32
#include <windows.h>

#include <semaphore>
#else
#include <csignal>
#include <ctime>
#include <thread>
#endif

namespace tiller::app {

#ifdef _WIN32
// Follows the documentation of the console API. Not tested in this project's CI.

namespace {
std::binary_semaphore ended{0};
BOOL WINAPI onConsoleEvent(DWORD) {
    ended.release();
    return TRUE;
}
}  // namespace

void holdTerminationSignals() {
    SetConsoleCtrlHandler(onConsoleEvent, TRUE);
}

void waitForTermination() {
    ended.acquire();
}

bool waitForTermination(std::chrono::milliseconds atMost) {
    return ended.try_acquire_for(atMost);
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
    // Poll, because macOS has no sigtimedwait().
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
