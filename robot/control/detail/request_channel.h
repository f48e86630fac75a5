// SPDX-License-Identifier: MIT
#pragma once

// Sends queries and settings to the control program, one at a time, within the regular packages to the robot.

#include <array>
#include <mutex>
#include <optional>
#include <span>

#include "robot/control/detail/control_loop.h"
#include "robot/control/detail/registers.h"
#include "robot/core/deadline.h"
#include "robot/core/result.h"
#include "robot/core/turn.h"

namespace tiller::control {

class ControlLink;

/// The result of a request whose answer contains no numbers.
inline Result<void> noAnswer(const Result<Answer>& answer) {
    return answer ? Result<void>() : Result<void>(answer.error());
}

/// Threads  any
class RequestChannel {
public:
    RequestChannel(ControlLoop& loop, const ControlLink& link) : loop_(loop), link_(link) {}

    /// Sends a request to the control program and waits for its answer.
    /// numbers  up to 18 values; values 7 to 18 are sent in advance, unless the program already has them
    /// Errors   NotInControl, LinkLost, NoSolution, Stopped, VersionUnsupported, Timeout, Cancelled
    Result<Answer> request(RequestKind kind, std::int32_t whole, std::span<const double> numbers,
                           const QString& context, const Deadline& deadline);

    /// Blocks requests while `begin` runs, and discards the numbers stored in the previous program.
    template <class Begin>
    void restart(Begin begin) {
        const std::lock_guard lock(turn_);
        stored_ = {};
        begin();
    }
    void forget() {
        restart([] {});
    }

private:
    Result<Answer> exchange(const Request& request, const QString& context, const Deadline& deadline);

    ControlLoop& loop_;
    const ControlLink& link_;
    Turn turn_;
    /// Values 7 to 18 of request() as stored in the program; empty if unknown. Protected by `turn_`.
    std::array<std::optional<std::array<double, 6>>, 2> stored_;
};

}  // namespace tiller::control
