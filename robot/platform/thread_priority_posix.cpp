// SPDX-License-Identifier: MIT
#include <pthread.h>
#include <sched.h>
#include <time.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "robot/platform/thread_priority.h"

namespace tiller::realtime {

PriorityReport requestThreadPriority(int priority) {
    PriorityReport report;
    report.requested = std::clamp(priority, 0, 99);
    if (report.requested == 0) {
        return report;
    }
    sched_param wanted{};
    wanted.sched_priority =
        std::clamp(report.requested, sched_get_priority_min(SCHED_FIFO), sched_get_priority_max(SCHED_FIFO));
    const int failure = pthread_setschedparam(pthread_self(), SCHED_FIFO, &wanted);

    int policy = SCHED_OTHER;
    sched_param actual{};
    if (pthread_getschedparam(pthread_self(), &policy, &actual) == 0 && policy == SCHED_FIFO) {
        // The maximum priority on macOS is 47. If the thread has this priority, the request counts as
        // granted. Not run in this project's CI.
        report.granted =
            wanted.sched_priority < report.requested && actual.sched_priority == wanted.sched_priority
                ? report.requested
                : actual.sched_priority;
    }
    if (report.ok()) {
        return report;
    }
    if (failure == EPERM) {
        report.advice = QStringLiteral(
                            "Real-time priority %1 was refused. Add the lines \"@realtime - rtprio 99\" and "
                            "\"@realtime - memlock unlimited\" to /etc/security/limits.d/realtime.conf, add "
                            "the user to the group realtime, and log in again.")
                            .arg(report.requested);
    } else {
        report.advice = QStringLiteral("Real-time priority %1 was refused: %2")
                            .arg(report.requested)
                            .arg(qt_error_string(failure));
    }
    return report;
}

void nameThread(const char* name) {
#ifdef __APPLE__
    pthread_setname_np(name);
#else
    char text[16] = {};
    std::strncpy(text, name, sizeof text - 1);
    pthread_setname_np(pthread_self(), text);
#endif
}

double threadSeconds() {
    timespec used{};
    return clock_gettime(CLOCK_THREAD_CPUTIME_ID, &used) == 0
               ? static_cast<double>(used.tv_sec) + static_cast<double>(used.tv_nsec) * 1e-9
               : 0.0;
}

}  // namespace tiller::realtime
