// SPDX-License-Identifier: MIT
#pragma once

// Limits the number of displayed controller messages. A defective controller, or a program that opens popups
// or writes text in a loop, can send more messages than a user can read or a window can display.

#include <array>
#include <cstdint>
#include <vector>

#include "robot/core/clock.h"
#include "robot/script/controller_message.h"

namespace tiller::script {

struct MessageLimits {
    double burst = 100;     ///< messages of each kind that pass before the rate limit applies
    double perSecond = 20;  ///< rate limit of each kind [1/s]
};

/// Each kind of message has a separate budget, so that a flood of popups does not hide errors.
/// Threads  one
class MessageLimiter {
public:
    explicit MessageLimiter(const MessageLimits& limits = {}) : limits_(limits) {}

    /// Removes the messages beyond the budget of their kind and keeps the order of the remaining messages.
    /// nowNs  monotonic time [ns]
    void limit(std::vector<ControllerMessage>& messages, std::int64_t nowNs);
    /// Returns the number of messages removed since the last nonzero result, including those passed to
    /// setDropped(). The result is nonzero at most once per second.
    std::uint64_t takeRemoved(std::int64_t nowNs);
    /// total  number of messages dropped by the source so far
    void setDropped(std::uint64_t total);

private:
    struct Budget {
        double left = 0;
        std::int64_t updatedNs = 0;
        bool isInUse = false;
    };
    static constexpr std::size_t kKinds = 16;

    MessageLimits limits_;
    std::array<Budget, kKinds> budgets_{};
    std::uint64_t removed_ = 0;
    std::uint64_t dropped_ = 0;
    std::int64_t reportedNs_ = 0;
};

}  // namespace tiller::script
