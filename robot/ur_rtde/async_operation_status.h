// SPDX-License-Identifier: MIT
#pragma once

// Progress of a motion started with `asynchronous`, reported by the robot in one integer.

#include <cstdint>

namespace ur_rtde {

class AsyncOperationStatus {
public:
    /// value  bits 30-24: number of the operation, 23-16: change count, 15: running, 14-0: progress. The
    ///        constructor is implicit, so that existing programs can pass a plain number
    AsyncOperationStatus(int value = 0) : value_(static_cast<std::uint32_t>(value)) {}

    std::uint32_t value() const { return value_; }
    bool isAsyncOperationRunning() const { return (value_ & 0x8000U) != 0; }
    int operationId() const { return static_cast<int>((value_ >> 24) & 0x7fU); }
    int changeCount() const { return static_cast<int>((value_ >> 16) & 0xffU); }
    /// 0 for a single move; index of the current target waypoint in a path, from 0; -1 if no operation is
    /// active.
    int progress() const { return isAsyncOperationRunning() ? static_cast<int>(value_ & 0x7fffU) : -1; }

    bool equals(const AsyncOperationStatus& other) const { return value_ == other.value_; }
    bool operator==(const AsyncOperationStatus& other) const { return equals(other); }
    bool operator!=(const AsyncOperationStatus& other) const { return !equals(other); }

private:
    std::uint32_t value_;
};

}  // namespace ur_rtde
