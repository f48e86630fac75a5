// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/termination.h"

#ifdef _WIN32
#include <windows.h>

#include <semaphore>
#else
#include <csignal>
#endif

namespace tiller::app {

#ifdef _WIN32
// Written to the console API's documentation; not run in this project's CI.

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

#endif

}  // namespace tiller::app
