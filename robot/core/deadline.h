// SPDX-License-Identifier: MIT
#pragma once

// The time limit of a blocking call, with an optional cancel token. Every blocking call of this library has a
// Deadline parameter.

#include <algorithm>
#include <atomic>
#include <chrono>
#include <functional>
#include <memory>
#include <utility>

namespace tiller {

/// Lets another thread cancel a wait. Copies share the same flag.
/// Threads  any
class CancelToken {
public:
    CancelToken() : CancelToken(nullptr) {}
    /// The token is also cancelled when `asked` returns true. The waiting thread calls `asked` about every 10
    /// ms. Use it for hosts such as Python, which can detect an interrupt only in this thread.
    explicit CancelToken(std::function<bool()> asked) : state_(std::make_shared<State>(std::move(asked))) {}
    /// Cancels all copies.
    void cancel() const { state_->cancelled.store(true, std::memory_order_release); }
    bool isCancelled() const {  ///< True if any copy was cancelled.
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

    /// time  in any unit and representation, e.g. 5s, 0.5s, std::chrono::duration<double>(x). More than a
    ///       century: no limit. A negative value or NaN: already expired
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

    /// A deadline without a time limit, e.g. for a move at 2 % speed. Only the awaited event or the token
    /// ends the wait.
    static Deadline never(const CancelToken& token = CancelToken()) {
        return Deadline(Clock::time_point::max(), token);
    }

    /// True if the time has expired or the token is cancelled.
    bool hasExpired() const { return token_.isCancelled() || Clock::now() >= end_; }
    bool isCancelled() const { return token_.isCancelled(); }  ///< True only if the token is cancelled.
    std::chrono::milliseconds remaining() const {  ///< 0 if expired; one day without a time limit.
        if (token_.isCancelled()) {
            return std::chrono::milliseconds(0);
        }
        if (end_ == Clock::time_point::max()) {
            return std::chrono::hours(24);
        }
        const auto left = std::chrono::ceil<std::chrono::milliseconds>(end_ - Clock::now());
        return std::max(left, std::chrono::milliseconds(0));
    }
    /// Maximum sleep time before the token must be checked again: 10 ms, so that cancelling takes effect
    /// within 20 ms.
    std::chrono::milliseconds nextPoll() const {
        return std::min(remaining(), std::chrono::milliseconds(10));
    }
    /// The token, e.g. to create another deadline.
    const CancelToken& token() const { return token_; }

private:
    Deadline(Clock::time_point end, const CancelToken& token) : end_(end), token_(token) {}
    Clock::time_point end_;
    CancelToken token_;
};

}  // namespace tiller
