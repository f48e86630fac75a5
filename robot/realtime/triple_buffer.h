// SPDX-License-Identifier: MIT
#pragma once

// "The newest value" for a reader that must never wait, not even for a writer that was interrupted half-way.

#include <array>
#include <atomic>

namespace tiller::realtime {

/// Threads  publish(): one at a time; take() and newest(): one. Real-time: yes, wait-free on both sides
template <class T>
class TripleBuffer {
public:
    void publish(const T& value) {  ///< One writer. Real-time: yes
        slots_[back_] = value;
        back_ = middle_.exchange(back_ | kFresh, std::memory_order_acq_rel) & ~kFresh;
    }

    /// Reader: the value published last; a default one before the first. Valid until the next call.
    const T& newest() {
        fetch();
        return slots_[front_];
    }
    /// Reader: the same, but each value once; null when there is no new one.
    const T* take() { return fetch() ? &slots_[front_] : nullptr; }

private:
    bool fetch() {
        if ((middle_.load(std::memory_order_relaxed) & kFresh) == 0) {
            return false;
        }
        front_ = middle_.exchange(front_, std::memory_order_acq_rel) & ~kFresh;
        return true;
    }

    // The writer fills `back_`, the reader looks at `front_`; the third changes hands through `middle_`, its
    // index, marked as fresh when the writer put it there.
    static constexpr unsigned kFresh = 4;
    std::array<T, 3> slots_{};
    std::atomic<unsigned> middle_{1};
    unsigned back_ = 0;
    unsigned front_ = 2;
};

}  // namespace tiller::realtime
