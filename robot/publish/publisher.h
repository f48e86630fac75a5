// SPDX-License-Identifier: MIT
#pragma once

// Reads the samples of receivers and passes them to any number of sinks in one thread. Each sink has a separate
// position in the ring buffer of its receiver. Therefore, a slow sink loses only samples of its subscription,
// which are counted. A failing sink ends without effect on other sinks.

#include <chrono>
#include <cstdint>
#include <memory>

#include "robot/core/result.h"
#include "robot/publish/sample_sink.h"
#include "robot/receive/receiver.h"

namespace tiller::publish {

struct PublicationOptions {
    std::shared_ptr<SampleSink> sink;
    receive::Subscription subscription;
    std::shared_ptr<const receive::SampleLayout> layout;  ///< layout of the subscription
    std::chrono::milliseconds every{100};                 ///< interval between two turns
};

/// One sink of a publisher. Valid even after the publisher is destroyed.
/// Threads  any, except the threads of the publisher
class Publication {
public:
    Publication() = default;
    ~Publication() { stop(); }
    Publication(Publication&&) = default;
    Publication& operator=(Publication&& other) noexcept;

    /// Ends the sink after the samples received so far. No effect if it has ended.
    /// Blocks  until SampleSink::close() has returned
    void stop();
    std::uint64_t packets() const;  ///< Samples that the sink has taken.
    std::uint64_t missed() const;   ///< Samples overwritten before a slow sink could take them.

private:
    friend class Publisher;
    struct Entry;
    std::shared_ptr<Entry> entry_;
};

/// Owns the thread "tiller-publish" (normal priority) while it has sinks. Turns that may block run in
/// additional threads "tiller-files": usually one, more only while others are blocked.
/// Threads  any, except the threads of the publisher
class Publisher {
public:
    enum class Sinks {
        One,   ///< for a single sink: all of its turns run in the thread of the publisher
        Many,  ///< turns that may block run in other threads
    };
    explicit Publisher(Sinks sinks = Sinks::Many);
    ~Publisher();  ///< stops all sinks
    Publisher(const Publisher&) = delete;
    Publisher& operator=(const Publisher&) = delete;

    /// Opens the sink. Its turns then run until it or the publication ends.
    /// Errors  those of SampleSink::open()
    /// Blocks  until SampleSink::open() has returned
    Result<Publication> add(PublicationOptions options);

private:
    friend class Publication;
    struct Worker;
    std::shared_ptr<Worker> d_;
};

}  // namespace tiller::publish
