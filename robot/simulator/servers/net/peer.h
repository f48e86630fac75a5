// SPDX-License-Identifier: MIT
#pragma once

// One accepted connection: reads received data, sends as much as possible, buffers a limited rest. Never blocks.
// The link conditions (see Link) are applied here, so that services do not need to know them.

#include <cstdint>
#include <deque>
#include <span>
#include <string_view>
#include <vector>

#include "robot/core/native_socket.h"

namespace tiller::simulator {

class Link;

class Peer {
public:
    /// backlog  bytes kept for a peer that does not read at the moment
    Peer(native_socket::Descriptor descriptor, std::size_t backlog);
    ~Peer();
    Peer(const Peer&) = delete;
    Peer& operator=(const Peer&) = delete;

    /// The cable it is connected by; outlives this object.
    void attach(Link* link);

    bool isOpen() const { return open_; }
    void close();

    /// Receives once. Returns how many bytes came; closes when the peer has ended the connection.
    std::size_t receive(std::span<std::uint8_t> into);

    /// Sends data, or buffers the part that the socket does not accept now. Returns false and takes nothing when
    /// the buffer is full, because the peer does not read.
    bool send(std::span<const std::uint8_t> bytes);
    bool send(std::string_view text);
    /// Sends due data as far as the socket accepts them.
    void flush();
    /// Bytes not yet accepted by the socket; data delayed by a slow link do not count.
    std::size_t pending() const { return out_.size() - sent_; }

    /// Closes once everything has gone out.
    void closeAfterFlush();

private:
    struct Segment {
        double due;  ///< [s] controller time
        std::vector<std::uint8_t> bytes;
        std::size_t gone = 0;
    };

    std::size_t receiveNow(std::span<std::uint8_t> into);
    std::size_t receiveThroughCable(std::span<std::uint8_t> into);
    std::size_t sendNow(std::span<const std::uint8_t> bytes);
    void endSending();
    bool hold(std::span<const std::uint8_t> bytes);
    void releaseHeld();
    void put(std::span<const std::uint8_t> bytes);
    bool isPlain() const;

    native_socket::Descriptor descriptor_;
    Link* link_ = nullptr;
    std::size_t backlog_;
    std::vector<std::uint8_t> out_;
    std::size_t sent_ = 0;
    std::deque<Segment> held_;      ///< on their way to the client
    std::deque<Segment> arriving_;  ///< on their way from it
    std::size_t heldBytes_ = 0;
    bool isWatched_ = false;  ///< by the poller of the link, which sets:
    bool hasArrived_ = true;  ///< there may be something to read
    bool open_ = true;
    bool closing_ = false;
    bool isMute_ = false;  ///< nothing reaches the client any more
    bool ended_ = false;   ///< the client has closed the connection; remaining data were sent before
};

}  // namespace tiller::simulator
