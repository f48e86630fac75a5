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
    /// backlog  maximum number of bytes buffered for a client that currently does not read
    Peer(native_socket::Descriptor descriptor, std::size_t backlog);
    ~Peer();
    Peer(const Peer&) = delete;
    Peer& operator=(const Peer&) = delete;

    /// The cable of the connection; must outlive this object.
    void attach(Link* link);

    bool isOpen() const { return open_; }
    void close();

    /// Receives once. Returns the number of received bytes; closes when the client has ended the connection.
    std::size_t receive(std::span<std::uint8_t> into);

    /// Sends the data, or buffers what the socket does not accept now. False, without sending anything, when
    /// they do not fit into the backlog because the client does not read.
    /// stamp  time stamp of the bytes, for delivered()
    bool send(std::span<const std::uint8_t> bytes, std::optional<double> stamp = {});
    bool send(std::string_view text);
    /// Time stamp of the newest bytes that the client can read completely; nothing if they have none.
    std::optional<double> delivered() const { return delivered_; }
    std::uint16_t port() const { return port_; }  ///< Of the client's end.
    /// Sends everything that is due and accepted by the socket.
    void flush();
    /// Bytes not yet accepted by the socket; data delayed by a slow link do not count.
    std::size_t pending() const { return out_.size() - sent_; }

    /// Closes once all data have been sent.
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
    std::deque<Segment> held_;      ///< in transit to the client
    std::deque<Segment> arriving_;  ///< in transit from the client
    std::size_t heldBytes_ = 0;
    bool isWatched_ = false;  ///< by the poller of the link, which sets hasArrived_
    bool hasArrived_ = true;  ///< data may be available
    bool open_ = true;
    bool closing_ = false;
    bool isUnresponsive_ = false;  ///< no data reach the client any more
    bool ended_ = false;           ///< the client has closed the connection; remaining data were sent before
};

}  // namespace tiller::simulator
