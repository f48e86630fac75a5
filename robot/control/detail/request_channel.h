// SPDX-License-Identifier: MIT
#pragma once

// Questions to the control program, and settings of it: one at a time, through the packages that go to the
// robot anyway.

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

/// That it came, or why not: of a request whose answer holds no numbers.
inline Result<void> noAnswer(const Result<Answer>& answer) {
    return answer ? Result<void>() : Result<void>(answer.error());
}

/// Threads  any
class RequestChannel {
public:
    RequestChannel(ControlLoop& loop, const ControlLink& link) : loop_(loop), link_(link) {}

    /// Asks the control program and waits for its answer.
    /// numbers  up to 18; those after the sixth go ahead, unless the program has them already
    /// Errors   NotInControl, LinkLost, NoSolution, Stopped, VersionUnsupported, Timeout, Cancelled
    Result<Answer> request(RequestKind kind, std::int32_t whole, std::span<const double> numbers,
                           const QString& context, const Deadline& deadline);

    /// Nobody asks while `begin` runs, and what the program before had kept is forgotten.
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
    /// Under it: numbers 6 to 17 as the program keeps them; nothing where that is not known.
    std::array<std::optional<std::array<double, 6>>, 2> stored_;
};

}  // namespace tiller::control
