// SPDX-License-Identifier: MIT
#pragma once

// The latest value, written by one thread and read by any number of threads without blocking. A reader retries if the
// value was written during the read.

#include <atomic>
#include <cstdint>
#include <cstring>
#include <memory>
#include <span>
#include <type_traits>

namespace tiller::realtime {

/// A fixed number of 64-bit words that are read consistently.
/// Threads  write(): one; read(): any. Real-time: yes (allocates at construction only)
class WordSeqlock {
public:
    explicit WordSeqlock(std::size_t words)
        : size_(words), words_(std::make_unique<std::atomic<std::uint64_t>[]>(words)) {}

    std::size_t size() const { return size_; }  ///< In 64-bit words.
    /// Number of writes. 0: not written yet, read() returns zeros.
    std::uint64_t version() const { return sequence_.load(std::memory_order_acquire) / 2; }

    void write(std::span<const std::uint64_t> values) {  ///< Threads: one writer. Real-time: yes
        const std::uint64_t sequence = sequence_.load(std::memory_order_relaxed);
        sequence_.store(sequence + 1, std::memory_order_relaxed);
        // The release store of each word keeps the odd sequence number ordered before it. A fence would have
        // the same effect, but ThreadSanitizer does not support fences.
        for (std::size_t i = 0; i < size_; ++i) {
            words_[i].store(values[i], std::memory_order_release);
        }
        sequence_.store(sequence + 2, std::memory_order_release);
    }

    /// Returns  the version read; retries during a write
    std::uint64_t read(std::span<std::uint64_t> values) const {
        for (;;) {
            const std::uint64_t before = sequence_.load(std::memory_order_acquire);
            if (before % 2 != 0) {
                continue;
            }
            for (std::size_t i = 0; i < size_; ++i) {
                values[i] = words_[i].load(std::memory_order_acquire);
            }
            if (sequence_.load(std::memory_order_relaxed) == before) {
                return before / 2;
            }
        }
    }

private:
    std::size_t size_;
    std::unique_ptr<std::atomic<std::uint64_t>[]> words_;
    std::atomic<std::uint64_t> sequence_{0};
};

/// A value of one trivially copyable type that is read consistently.
/// Threads  store(): one; load(): any. Real-time: yes
template <class T>
class Seqlock {
    static_assert(std::is_trivially_copyable_v<T>);
    static constexpr std::size_t kWords = (sizeof(T) + 7) / 8;

public:
    Seqlock() : lock_(kWords) { store(T{}); }
    explicit Seqlock(const T& value) : lock_(kWords) { store(value); }

    void store(const T& value) {  ///< Threads: one writer. Real-time: yes
        std::uint64_t words[kWords] = {};
        std::memcpy(words, &value, sizeof(T));
        lock_.write(words);
    }
    T load() const {  ///< Retries during a write.
        std::uint64_t words[kWords];
        lock_.read(words);
        T value{};
        std::memcpy(static_cast<void*>(&value), words, sizeof(T));
        return value;
    }

private:
    WordSeqlock lock_;
};

}  // namespace tiller::realtime
