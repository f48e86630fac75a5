// SPDX-License-Identifier: MIT
#pragma once

// The latest value for a reader that must never wait, not even for a writer that was preempted during a
// write.

#include <array>
#include <atomic>

namespace tiller::realtime {

/// Threads  publish(): one at a time; take() and newest(): one. Real-time: yes, wait-free on both sides
template <class T>
class TripleBuffer {
public:
    void publish(const T& value) {  ///< Threads: one writer. Real-time: yes
        slots_[back_] = value;
        back_ = middle_.exchange(back_ | kFresh, std::memory_order_acq_rel) & ~kFresh;
    }

    /// For the reader: the newest published value, or a default value before the first publish(). Valid until
    /// the next call.
    const T& newest() {
        fetch();
        return slots_[front_];
    }
    /// For the reader: the newest value, at most once; null if there is no new value.
    const T* take() { return fetch() ? &slots_[front_] : nullptr; }

private:
    bool fetch() {
        if ((middle_.load(std::memory_order_relaxed) & kFresh) == 0) {
            return false;
        }
        front_ = middle_.exchange(front_, std::memory_order_acq_rel) & ~kFresh;
        return true;
    }

    // The writer fills `back_` and the reader uses `front_`. The third slot is exchanged through `middle_`,
    // which contains its index and a flag for a new value.
    static constexpr unsigned kFresh = 4;
    std::array<T, 3> slots_{};
    std::atomic<unsigned> middle_{1};
    unsigned back_ = 0;
    unsigned front_ = 2;
};

}  // namespace tiller::realtime
