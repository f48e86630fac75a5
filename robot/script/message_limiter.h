// SPDX-License-Identifier: MIT
#pragma once

// Bounds how many messages of a controller are shown. A program that opens popups or writes texts in a loop, or a
// defective controller, sends more than anyone can read and more than a window can lay out.

#include <array>
#include <cstdint>
#include <vector>

#include "robot/core/clock.h"
#include "robot/script/controller_message.h"

namespace tiller::script {

struct MessageLimits {
    double burst = 100;     ///< messages of one kind that pass at once
    double perSecond = 20;  ///< of one kind, once the burst is used up [1/s]
};

/// One budget for each kind of message, so that a flood of popups hides no error.
/// Threads  one
class MessageLimiter {
public:
    explicit MessageLimiter(const MessageLimits& limits = {}) : limits_(limits) {}

    /// Removes the messages beyond the budget of their kind; the order of the others stays.
    /// nowNs  monotonic time
    void limit(std::vector<ControllerMessage>& messages, std::int64_t nowNs);
    /// Returns how many messages were removed since the last count that was not 0, including those of setDropped().
    /// A count is given once a second at most; 0 in between.
    std::uint64_t takeRemoved(std::int64_t nowNs);
    /// total  messages that were dropped before they got here, since the beginning
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
