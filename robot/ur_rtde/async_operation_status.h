// SPDX-License-Identifier: MIT
#pragma once

// How far a motion started with `asynchronous` has come, as the robot reports it in one word.

namespace ur_rtde {

class AsyncOperationStatus {
public:
    AsyncOperationStatus() = default;
    /// value  bits 30-24 number of the operation, 23-16 count of changes, 15 running, 14-0 progress;
    /// negative: none
    explicit AsyncOperationStatus(int value) : value_(value) {}

    int value() const { return value_; }
    bool isAsyncOperationRunning() const { return value_ >= 0 && (value_ & 0x8000) != 0; }
    int operationId() const { return value_ < 0 ? -1 : (value_ >> 24) & 0x7f; }
    int changeCount() const { return value_ < 0 ? -1 : (value_ >> 16) & 0xff; }
    /// 0 for a single move; the number of the waypoint the arm is on its way to, from 0, in a path.
    int progress() const { return value_ < 0 ? -1 : value_ & 0x7fff; }

    bool equals(const AsyncOperationStatus& other) const { return value_ == other.value_; }
    bool operator==(const AsyncOperationStatus& other) const { return equals(other); }
    bool operator!=(const AsyncOperationStatus& other) const { return !equals(other); }

private:
    int value_ = -1;
};

}  // namespace ur_rtde
