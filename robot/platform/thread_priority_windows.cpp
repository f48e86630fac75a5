// SPDX-License-Identifier: MIT
#include <windows.h>

#include <algorithm>

#include "robot/platform/thread_priority.h"

namespace tiller::realtime {

PriorityReport requestThreadPriority(int priority) {
    PriorityReport report;
    report.requested = std::clamp(priority, 0, 99);
    if (report.requested == 0) {
        return report;
    }
    const int wanted = report.requested >= 80 ? THREAD_PRIORITY_TIME_CRITICAL : THREAD_PRIORITY_HIGHEST;
    if (SetThreadPriority(GetCurrentThread(), wanted)) {
        report.granted = report.requested;
    } else {
        report.advice = QStringLiteral("The system refused a higher thread priority (error %1).")
                            .arg(static_cast<unsigned>(GetLastError()));
    }
    return report;
}

void nameThread(const char* name) {
    // Windows 10 version 1607 and newer.
    using SetDescription = HRESULT(WINAPI*)(HANDLE, PCWSTR);
    static const auto setDescription = reinterpret_cast<SetDescription>(
        reinterpret_cast<void*>(GetProcAddress(GetModuleHandleW(L"kernel32.dll"), "SetThreadDescription")));
    if (setDescription != nullptr) {
        setDescription(GetCurrentThread(), QString::fromUtf8(name).toStdWString().c_str());
    }
}

double threadSeconds() {
    FILETIME created{};
    FILETIME ended{};
    FILETIME kernel{};
    FILETIME user{};
    if (GetThreadTimes(GetCurrentThread(), &created, &ended, &kernel, &user) == 0) {
        return 0;
    }
    // Converts a time to a number of 100 ns units.
    const auto ticks = [](const FILETIME& time) {
        return static_cast<double>(time.dwHighDateTime) * 4294967296.0 +
               static_cast<double>(time.dwLowDateTime);
    };
    return (ticks(kernel) + ticks(user)) * 1e-7;
}

}  // namespace tiller::realtime
