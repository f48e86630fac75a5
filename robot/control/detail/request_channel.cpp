// SPDX-License-Identifier: MIT
#include "robot/control/detail/request_channel.h"

#include <algorithm>

#include "robot/control/detail/control_link.h"
#include "robot/core/wait_until.h"

namespace tiller::control {

using std::chrono::milliseconds;

namespace {

Error overdue(const Deadline& deadline, const QString& context) {
    return {deadline.isCancelled() ? ErrorCode::Cancelled : ErrorCode::Timeout, context,
            QStringLiteral("the control program does not respond")};
}

}  // namespace

Result<Answer> RequestChannel::exchange(const Request& request, const QString& context,
                                        const Deadline& deadline) {
    const std::int32_t number = loop_.ask(request);
    Answer answer;
    bool inControl = false;
    const auto settled = [&] {
        answer = loop_.answer();
        inControl = loop_.isInControl();
        return answer.number == number || !inControl;
    };
    const bool settledInTime = waitUntil(deadline, settled, std::chrono::microseconds(500));
    if (!inControl || !settledInTime) {
        loop_.withdraw();  // a request must not be executed when no caller waits for it
    }
    if (!inControl) {
        return Error{link_.isRunning() ? ErrorCode::NotInControl : ErrorCode::LinkLost, context, {}};
    }
    if (!settledInTime) {
        return overdue(deadline, context);
    }
    switch (answer.outcome) {
        case Outcome::Done:
            return answer;
        case Outcome::NoSolution:
            return Error{ErrorCode::NoSolution, context, {}};
        case Outcome::NotPermitted:
            return Error{ErrorCode::Stopped, context, QStringLiteral("interrupted by a stop")};
        case Outcome::Unknown:
            break;
    }
    return Error{ErrorCode::VersionUnsupported, context,
                 QStringLiteral("the control program does not support this request")};
}

Result<Answer> RequestChannel::request(RequestKind kind, std::int32_t whole, std::span<const double> numbers,
                                       const QString& context, const Deadline& deadline) {
    if (!loop_.isInControl()) {
        return Error{ErrorCode::NotInControl, context, {}};
    }
    std::unique_lock lock(turn_, std::defer_lock);
    while (!lock.try_lock_for(std::max(deadline.nextPoll(), milliseconds(1)))) {
        if (deadline.hasExpired()) {
            return overdue(deadline, context);
        }
    }
    constexpr std::size_t kInOnePackage = 6;
    Request asked{0, kind, whole, {}};
    std::copy_n(numbers.begin(), std::min(numbers.size(), kInOnePackage), asked.numbers.begin());
    for (std::size_t page = 0; page < stored_.size() && numbers.size() > (page + 1) * kInOnePackage; ++page) {
        const auto rest = numbers.subspan((page + 1) * kInOnePackage);
        std::array<double, kInOnePackage> kept{};
        std::copy_n(rest.begin(), std::min(rest.size(), kInOnePackage), kept.begin());
        if (stored_[page] == kept) {
            continue;
        }
        stored_[page].reset();
        const auto place = static_cast<std::int32_t>(page * kInOnePackage);
        if (auto answer = exchange({0, RequestKind::Store, place, kept}, context, deadline); !answer) {
            return answer;
        }
        stored_[page] = kept;
    }
    return exchange(asked, context, deadline);
}

}  // namespace tiller::control
