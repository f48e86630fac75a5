// SPDX-License-Identifier: MIT
#include <windows.h>

#include <chrono>
#include <thread>

#include "robot/platform/sleep.h"

namespace tiller {

namespace {

/// CREATE_WAITABLE_TIMER_HIGH_RESOLUTION, which the headers of MinGW-w64 lack.
constexpr DWORD kHighResolution = 0x00000002;

/// A timer with a resolution of about 0.5 ms (Windows 10 version 1803 and newer; otherwise 1 to 16 ms).
class WaitableTimer {
public:
    WaitableTimer() : timer_(create(kHighResolution)) {
        if (timer_ == nullptr) {
            timer_ = create(0);
        }
    }
    ~WaitableTimer() {
        if (timer_ != nullptr) {
            CloseHandle(timer_);
        }
    }
    WaitableTimer(const WaitableTimer&) = delete;
    WaitableTimer& operator=(const WaitableTimer&) = delete;

    bool wait(std::chrono::nanoseconds time) const {
        LARGE_INTEGER due;
        due.QuadPart = -(time.count() + 99) / 100;  // relative, in units of 100 ns
        return timer_ != nullptr && SetWaitableTimer(timer_, &due, 0, nullptr, nullptr, FALSE) != 0 &&
               WaitForSingleObject(timer_, INFINITE) == WAIT_OBJECT_0;
    }

private:
    static HANDLE create(DWORD flags) {
        return CreateWaitableTimerExW(nullptr, nullptr, flags, TIMER_ALL_ACCESS);
    }
    HANDLE timer_;
};

}  // namespace

void sleepUntilNs(std::int64_t until) {
    using Clock = std::chrono::steady_clock;
    thread_local const WaitableTimer timer;
    const Clock::time_point end{std::chrono::nanoseconds(until)};
    // The timer uses another clock than `end`, so it may expire too early.
    for (auto left = end - Clock::now(); left.count() > 0; left = end - Clock::now()) {
        if (!timer.wait(left)) {
            std::this_thread::sleep_until(end);
        }
    }
}

}  // namespace tiller
