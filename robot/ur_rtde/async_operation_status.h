// SPDX-License-Identifier: MIT
#pragma once

// How far a motion started with `asynchronous` has come, as the robot reports it in one word.

#include <cstdint>

namespace ur_rtde {

class AsyncOperationStatus {
public:
    /// value  bits 30-24 number of the operation, 23-16 count of changes, 15 running, 14-0 progress. A plain
    /// number
    ///        may stand where a status is wanted, as programs are used to
    AsyncOperationStatus(int value = 0) : value_(static_cast<std::uint32_t>(value)) {}

    std::uint32_t value() const { return value_; }
    bool isAsyncOperationRunning() const { return (value_ & 0x8000U) != 0; }
    int operationId() const { return static_cast<int>((value_ >> 24) & 0x7fU); }
    int changeCount() const { return static_cast<int>((value_ >> 16) & 0xffU); }
    /// 0 for a single move; the number of the waypoint the arm is on its way to, from 0, in a path; -1 when
    /// no operation is under way.
    int progress() const { return isAsyncOperationRunning() ? static_cast<int>(value_ & 0x7fffU) : -1; }

    bool equals(const AsyncOperationStatus& other) const { return value_ == other.value_; }
    bool operator==(const AsyncOperationStatus& other) const { return equals(other); }
    bool operator!=(const AsyncOperationStatus& other) const { return !equals(other); }

private:
    std::uint32_t value_;
};

}  // namespace ur_rtde
