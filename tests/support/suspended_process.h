// SPDX-License-Identifier: MIT
#pragma once

// Suspends another process, as a debugger does.

#include <QtGlobal>

#ifdef _WIN32
#include <qt_windows.h>
#else
#include <sys/types.h>

#include <csignal>
#endif

namespace tiller::test {

inline void setSuspended(qint64 process, bool suspended) {
#ifdef _WIN32
    // Windows has no documented function for it.
    using Function = LONG(WINAPI*)(HANDLE);
    const auto function = reinterpret_cast<Function>(reinterpret_cast<void*>(
        GetProcAddress(GetModuleHandleW(L"ntdll.dll"), suspended ? "NtSuspendProcess" : "NtResumeProcess")));
    const HANDLE handle = OpenProcess(PROCESS_SUSPEND_RESUME, FALSE, static_cast<DWORD>(process));
    if (function == nullptr || handle == nullptr || function(handle) != 0) {
        qFatal("process %lld: cannot be %s", process, suspended ? "suspended" : "resumed");
    }
    CloseHandle(handle);
#else
    if (::kill(static_cast<pid_t>(process), suspended ? SIGSTOP : SIGCONT) != 0) {
        qFatal("process %lld: cannot be %s", process, suspended ? "suspended" : "resumed");
    }
#endif
}

}  // namespace tiller::test
