// SPDX-License-Identifier: MIT
#pragma once

// How long a blocking call may take, and how to end it sooner. Every call of this library that can wait takes
// one.

#include <algorithm>
#include <atomic>
#include <chrono>
#include <functional>
#include <memory>
#include <utility>

namespace tiller {

/// Shared between the one who waits and the one who may lose patience. Copies refer to the same flag.
/// Threads  any
class CancelToken {
public:
    CancelToken() : CancelToken(nullptr) {}
    /// Also cancelled once `asked` says true; it is asked in the thread that waits, about every 10 ms. For
    /// hosts that can tell only there that the user lost patience, as Python does.
    explicit CancelToken(std::function<bool()> asked) : state_(std::make_shared<State>(std::move(asked))) {}
    /// Every copy is cancelled.
    void cancel() const { state_->cancelled.store(true, std::memory_order_release); }
    bool isCancelled() const {  ///< By any copy.
        if (!state_->cancelled.load(std::memory_order_acquire) && state_->asked && state_->asked()) {
            cancel();
        }
        return state_->cancelled.load(std::memory_order_acquire);
    }

private:
    struct State {
        explicit State(std::function<bool()> a) : asked(std::move(a)) {}
        std::atomic<bool> cancelled{false};
        const std::function<bool()> asked;
    };
    std::shared_ptr<State> state_;
};

class Deadline {
public:
    using Clock = std::chrono::steady_clock;

    /// time  in any unit and representation: 5s, 0.5s, std::chrono::duration<double>(x). Longer than a
    ///       century means never; below zero, or not a number, now.
    template <class Rep, class Period>
    static Deadline after(std::chrono::duration<Rep, Period> time, const CancelToken& token = CancelToken()) {
        using Seconds = std::chrono::duration<double>;
        constexpr Seconds kCentury = std::chrono::hours(24 * 36525);
        if (!(time > time.zero())) {
            return Deadline(Clock::now(), token);
        }
        return Seconds(time) >= kCentury
                   ? never(token)
                   : Deadline(Clock::now() + std::chrono::ceil<Clock::duration>(time), token);
    }

    /// For waits that only the event itself, or the token, may end: a move at 2 % speed takes its time.
    static Deadline never(const CancelToken& token = CancelToken()) {
        return Deadline(Clock::time_point::max(), token);
    }

    /// By time or by the token.
    bool hasExpired() const { return token_.isCancelled() || Clock::now() >= end_; }
    bool isCancelled() const { return token_.isCancelled(); }  ///< By the token, not by time.
    std::chrono::milliseconds remaining() const {              ///< 0 when over; a day when never.
        if (token_.isCancelled()) {
            return std::chrono::milliseconds(0);
        }
        if (end_ == Clock::time_point::max()) {
            return std::chrono::hours(24);
        }
        const auto left = std::chrono::ceil<std::chrono::milliseconds>(end_ - Clock::now());
        return std::max(left, std::chrono::milliseconds(0));
    }
    /// The longest a poll may sleep before it looks at the token again: at most 10 ms, so that a cancel
    /// takes effect within 20 ms.
    std::chrono::milliseconds nextPoll() const {
        return std::min(remaining(), std::chrono::milliseconds(10));
    }
    /// To end the wait, or to make another deadline with.
    const CancelToken& token() const { return token_; }

private:
    Deadline(Clock::time_point end, const CancelToken& token) : end_(end), token_(token) {}
    Clock::time_point end_;
    CancelToken token_;
};

}  // namespace tiller
