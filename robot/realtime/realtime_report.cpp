// SPDX-License-Identifier: MIT
#include "robot/realtime/realtime_report.h"

#include <QFile>
#include <QSysInfo>

#ifdef _WIN32
#include <windows.h>
#else
#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>

#include <cerrno>
#endif

namespace tiller::realtime {

#if defined(_WIN32)

QString bindToCpus(const std::vector<int>& cpus) {
    DWORD_PTR mask = 0;
    for (const int cpu : cpus) {
        if (cpu < 0 || cpu >= static_cast<int>(8 * sizeof mask)) {
            return QStringLiteral("There is no CPU %1.").arg(cpu);
        }
        mask |= DWORD_PTR(1) << cpu;
    }
    if (mask != 0 && SetThreadAffinityMask(GetCurrentThread(), mask) != 0) {
        return {};
    }
    return QStringLiteral("The system refused these CPUs (error %1).")
        .arg(static_cast<unsigned>(GetLastError()));
}

QString lockMemory() {
    return QStringLiteral("Windows cannot lock the memory of a whole process.");
}

bool isRealtimeKernel() {
    return false;
}

QString kernelAdvice() {
    return QStringLiteral(
        "Windows is not a real-time system: delays of several milliseconds are possible under load. Select "
        "the "
        "high-performance power plan, and close other programs.");
}

#elif defined(__APPLE__)

// This code is not tested in the project's CI.
QString bindToCpus(const std::vector<int>&) {
    return QStringLiteral("macOS cannot bind threads to CPUs.");
}

QString lockMemory() {
    return QStringLiteral("macOS cannot lock the memory of a whole process.");
}

bool isRealtimeKernel() {
    return false;
}

QString kernelAdvice() {
    return QStringLiteral(
        "macOS is not a real-time system: delays of several milliseconds are possible under load.");
}

#else

QString bindToCpus(const std::vector<int>& cpus) {
    cpu_set_t set;
    CPU_ZERO(&set);
    for (const int cpu : cpus) {
        if (cpu < 0 || cpu >= CPU_SETSIZE) {
            return QStringLiteral("There is no CPU %1.").arg(cpu);
        }
        CPU_SET(static_cast<unsigned>(cpu), &set);
    }
    const int failure = pthread_setaffinity_np(pthread_self(), sizeof set, &set);
    if (failure == 0) {
        return {};
    }
    return QStringLiteral("The system refused these CPUs: %1").arg(qt_error_string(failure));
}

QString lockMemory() {
    if (mlockall(MCL_CURRENT | MCL_FUTURE) == 0) {
        return {};
    }
    if (errno == EPERM || errno == ENOMEM || errno == EAGAIN) {
        return QStringLiteral(
            "Memory could not be locked. Add the line \"@realtime - memlock unlimited\" to "
            "/etc/security/limits.d/realtime.conf, add the user to the group realtime, and log in again.");
    }
    return QStringLiteral("Memory could not be locked: %1").arg(qt_error_string(errno));
}

bool isRealtimeKernel() {
    QFile flag(QStringLiteral("/sys/kernel/realtime"));
    if (flag.open(QIODevice::ReadOnly) && flag.read(1) == "1") {
        return true;
    }
    QFile version(QStringLiteral("/proc/version"));
    return version.open(QIODevice::ReadOnly) && version.readAll().contains("PREEMPT_RT");
}

QString kernelAdvice() {
    return QStringLiteral(
               "The kernel (%1) is not a real-time kernel: delays of several milliseconds are possible "
               "under load. Debian: apt install linux-image-rt-amd64; Ubuntu: pro enable realtime-kernel.")
        .arg(QSysInfo::kernelVersion());
}

#endif

RealtimeReport requestRealtime(int priority, const std::vector<int>& cpus, bool lockAllMemory) {
    RealtimeReport report;
    report.priority = requestThreadPriority(priority);
    if (!report.priority.ok()) {
        report.advice.append(report.priority.advice);
    }
    if (!cpus.empty()) {
        const QString refused = bindToCpus(cpus);
        report.affinitySet = refused.isEmpty();
        if (!report.affinitySet) {
            report.advice.append(refused);
        }
    }
    if (lockAllMemory) {
        const QString refused = lockMemory();
        report.memoryLocked = refused.isEmpty();
        if (!report.memoryLocked) {
            report.advice.append(refused);
        }
    }
    report.realtimeKernel = isRealtimeKernel();
    if (!report.realtimeKernel) {
        report.advice.append(kernelAdvice());
    }
    return report;
}

}  // namespace tiller::realtime
