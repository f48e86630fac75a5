// SPDX-License-Identifier: MIT
#pragma once

// One accepted connection: reads received data, sends as much as possible, buffers a limited rest. Never blocks.
// The link conditions (see Link) are applied here, so that services do not need to know them.

#include <cstdint>
#include <deque>
#include <optional>
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

    /// Sends, or keeps for later what the socket does not take now. False, with nothing taken, when the
    /// backlog has no room for it: this peer does not read.
    /// stamp  of the bytes, for delivered()
    bool send(std::span<const std::uint8_t> bytes, std::optional<double> stamp = {});
    bool send(std::string_view text);
    /// Of the newest bytes that the client can read completely; nothing: none with a stamp.
    std::optional<double> delivered() const { return delivered_; }
    std::uint16_t port() const { return port_; }  ///< Of the client's end.
    /// Sends what is due and what the socket takes now.
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
        std::optional<double> stamp = {};
    };

    std::size_t receiveNow(std::span<std::uint8_t> into);
    std::size_t receiveThroughCable(std::span<std::uint8_t> into);
    std::size_t sendNow(std::span<const std::uint8_t> bytes);
    void endSending();
    bool hold(std::span<const std::uint8_t> bytes, std::optional<double> stamp);
    void releaseHeld();
    void put(std::span<const std::uint8_t> bytes);
    void noteDelivered(std::optional<double> stamp);
    bool isPlain() const;

    native_socket::Descriptor descriptor_;
    std::uint16_t port_;
    std::optional<double> delivered_;
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
