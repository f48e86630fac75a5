// SPDX-License-Identifier: MIT
#include "robot/script/message_limiter.h"

#include <algorithm>
#include <utility>

namespace tiller::script {

void MessageLimiter::limit(std::vector<ControllerMessage>& messages, std::int64_t nowNs) {
    const auto removed = std::erase_if(messages, [&](const ControllerMessage& message) {
        Budget& budget = budgets_[static_cast<std::size_t>(message.kind) % kKinds];
        if (!std::exchange(budget.isInUse, true)) {
            budget = {limits_.burst, nowNs, true};
        }
        const double seconds =
            static_cast<double>(nowNs - budget.updatedNs) / static_cast<double>(kNsPerSecond);
        budget.left = std::min(limits_.burst, budget.left + seconds * limits_.perSecond);
        budget.updatedNs = nowNs;
        if (budget.left < 1) {
            return true;
        }
        budget.left -= 1;
        return false;
    });
    removed_ += removed;
}

std::uint64_t MessageLimiter::takeRemoved(std::int64_t nowNs) {
    if (removed_ == 0 || nowNs - reportedNs_ < kNsPerSecond) {
        return 0;
    }
    reportedNs_ = nowNs;
    return std::exchange(removed_, 0);
}

void MessageLimiter::setDropped(std::uint64_t total) {
    removed_ += total - dropped_;
    dropped_ = total;
}

}  // namespace tiller::script
