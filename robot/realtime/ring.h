// SPDX-License-Identifier: MIT
#pragma once

// A stream of fixed-size records from one producer to any number of consumers. The producer never waits for
// consumers. If a consumer is too slow, the oldest records are overwritten, and the consumer can query how
// many it missed.

#include <atomic>
#include <cstdint>
#include <memory>
#include <span>

namespace tiller::realtime {

/// Threads  push(): one; each consumer uses a separate Cursor, from one thread at a time. Real-time: yes
/// (allocates at construction only)
class BroadcastRing {
public:
    /// The reading position of one consumer.
    struct Cursor {
        std::uint64_t next = 0;  ///< number of the next record
        std::uint64_t lost = 0;  ///< records overwritten before they were read
    };

    /// words     number of 64-bit words in a record
    /// capacity  number of records kept, rounded up to a power of two
    BroadcastRing(std::size_t words, std::size_t capacity)
        : words_(words)
        , mask_(roundUp(capacity) - 1)
        , stamps_(std::make_unique<std::atomic<std::uint64_t>[]>(mask_ + 1))
        , data_(std::make_unique<std::uint64_t[]>((mask_ + 1) * words)) {}

    std::size_t words() const { return words_; }        ///< Number of 64-bit words per record.
    std::size_t capacity() const { return mask_ + 1; }  ///< Number of records, a power of two.
    /// Number of records pushed so far.
    std::uint64_t count() const { return head_.load(std::memory_order_acquire); }

    /// Returns a cursor for the records pushed after this call.
    Cursor atEnd() const { return {count(), 0}; }
    /// Returns a cursor at the oldest available record.
    Cursor atBegin() const {
        const std::uint64_t head = count();
        return {head > capacity() ? head - capacity() : 0, 0};
    }
    /// Number of records not yet read.
    std::uint64_t pending(const Cursor& cursor) const { return count() - cursor.next; }

    /// The record being written. All words must be set, in any order.
    class Slot {
    public:
        /// Sets one word of the record; index < words().
        void set(std::size_t index, std::uint64_t word) const {
            std::atomic_ref(words_[index]).store(word, std::memory_order_release);
        }
        /// Returns a word that was set earlier.
        std::uint64_t get(std::size_t index) const { return words_[index]; }

    private:
        friend class BroadcastRing;
        explicit Slot(std::uint64_t* words) : words_(words) {}
        std::uint64_t* words_;
    };

    void push(std::span<const std::uint64_t> record) {  ///< Threads: one writer. Real-time: yes
        pushWith([&](Slot slot) {
            for (std::size_t i = 0; i < words_; ++i) {
                slot.set(i, record[i]);
            }
        });
    }
    /// Like push(), without a copy: fill(Slot) writes the record in place.
    template <class Fill>
    void pushWith(Fill fill) {
        const std::uint64_t number = head_.load(std::memory_order_relaxed);
        const std::size_t slot = number & mask_;
        stamps_[slot].store(2 * number + 1, std::memory_order_relaxed);
        fill(Slot(&data_[slot * words_]));
        stamps_[slot].store(2 * number + 2, std::memory_order_release);
        head_.store(number + 1, std::memory_order_release);
    }

    /// Reads the next record.
    /// Returns  false if there is no unread record
    bool pop(Cursor& cursor, std::span<std::uint64_t> record) const {
        return popEach(cursor, [&](std::size_t i, std::uint64_t word) { record[i] = word; });
    }
    /// Calls sink(index, word) for every word of the next record, without an intermediate copy. If the
    /// producer overwrites the record in the meantime, the function starts again at index 0 with the next
    /// record. If it returns true, the words of the last record passed to `sink` are valid.
    /// Returns  false if there is no unread record
    template <class Sink>
    bool popEach(Cursor& cursor, Sink sink) const {
        for (;;) {
            const std::uint64_t head = count();
            if (cursor.next >= head) {
                return false;
            }
            if (head - cursor.next > capacity()) {
                cursor.lost += head - capacity() - cursor.next;
                cursor.next = head - capacity();
            }
            if (read(cursor.next++, sink)) {
                return true;
            }
            ++cursor.lost;  // The producer is overwriting this record.
        }
    }
    /// Reads the newest record. Does not affect the cursors.
    /// Returns  false if no record has been pushed yet
    template <class Sink>
    bool newest(Sink sink) const {
        for (;;) {
            const std::uint64_t head = count();
            if (head == 0) {
                return false;
            }
            if (read(head - 1, sink)) {
                return true;
            }
        }
    }

private:
    /// Returns  false if the record has been overwritten
    template <class Sink>
    bool read(std::uint64_t number, Sink& sink) const {
        const std::size_t slot = number & mask_;
        const std::uint64_t whole = 2 * number + 2;
        if (stamps_[slot].load(std::memory_order_acquire) != whole) {
            return false;
        }
        std::uint64_t* words = &data_[slot * words_];
        for (std::size_t i = 0; i < words_; ++i) {
            sink(i, std::atomic_ref(words[i]).load(std::memory_order_acquire));
        }
        return stamps_[slot].load(std::memory_order_relaxed) == whole;
    }

    static std::size_t roundUp(std::size_t capacity) {
        std::size_t size = 2;
        while (size < capacity) {
            size *= 2;
        }
        return size;
    }

    std::size_t words_;
    std::size_t mask_;
    std::unique_ptr<std::atomic<std::uint64_t>[]> stamps_;
    /// Zero-initialized, so that all pages are mapped before the producer uses them.
    std::unique_ptr<std::uint64_t[]> data_;
    std::atomic<std::uint64_t> head_{0};
};

}  // namespace tiller::realtime
