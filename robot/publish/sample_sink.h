// SPDX-License-Identifier: MIT
#pragma once

// The destination of the samples that a Publisher reads: a file, a network server, a database.

#include <cstdint>

#include "robot/core/result.h"
#include "robot/receive/sample.h"

namespace tiller::publish {

/// The publisher calls a sink in turns: beginTurn(), take() for each new sample, endTurn().
/// Threads  one at a time. Turns that may block run in separate threads
class SampleSink {
public:
    /// Action of the publisher after a sample.
    enum class Next {
        Continue,
        NewTurn,  ///< ends the turn; the next turn begins at once, e.g. because it may block
        End,      ///< ends the turn, then the sink
    };
    virtual ~SampleSink() = default;

    /// True if the next turn may wait for a disk or a peer. Until it ends, the turns of other sinks continue.
    /// Sinks that need an event loop or always run in the same thread return false.
    virtual bool mayBlock() const { return false; }
    /// Called once, before the first turn.
    /// Errors  those of the sink; no other function is then called
    virtual Result<void> open() { return {}; }
    virtual void beginTurn() {}
    /// missing  packets lost before this sample, for any reason; 0 for the first sample
    virtual Next take(const receive::Sample& sample, std::uint64_t missing) = 0;
    /// last  true if the publisher is ending the sink and has passed all samples to take()
    /// Returns  false to end the sink
    virtual bool endTurn(bool last) { return !last; }
    /// Called once, after the last turn.
    virtual void close() {}
};

}  // namespace tiller::publish
