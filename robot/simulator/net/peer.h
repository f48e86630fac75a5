// SPDX-License-Identifier: MIT
#pragma once

// One accepted connection: reads data, sends as much as possible, and buffers a limited amount of remaining
// data. Never blocks. This class applies the link faults (see Link), so that services need not handle them.

#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "robot/platform/native_socket.h"

namespace tiller::simulator {

class Link;

class Peer {
public:
    /// backlog  maximum number of bytes buffered for a client that is not reading
    Peer(native_socket::Descriptor descriptor, std::size_t backlog);
    ~Peer();
    Peer(const Peer&) = delete;
    Peer& operator=(const Peer&) = delete;

    /// Sets the link of the connection, which must outlive this object.
    void attach(Link* link);

    bool isOpen() const { return open_; }
    void close();

    /// Reads from the socket once. Closes this end if the client has closed the connection.
    /// Returns  the number of bytes received
    std::size_t receive(std::span<std::uint8_t> into);

    /// Sends the data, and buffers the bytes that the socket does not accept.
    /// stamp  time stamp of the bytes, for delivered()
    /// Returns  false, without sending anything, if the data do not fit into the backlog because the client
    ///          is not reading
    bool send(std::span<const std::uint8_t> bytes, std::optional<double> stamp = {});
    bool send(std::string_view text);
    /// Time stamp of the newest stamped bytes that the client can read completely; empty if there are none.
    std::optional<double> delivered() const { return delivered_; }
    std::uint16_t port() const { return port_; }  ///< Port of the client.
    /// Sends all data that are due and that the socket accepts.
    void flush();
    /// Number of bytes that the socket has not accepted yet. Excludes data delayed by the link.
    std::size_t pending() const { return out_.size() - sent_; }

    void closeAfterFlush();

private:
    struct Segment {
        double due;  ///< [s] controller time of delivery
        std::vector<std::uint8_t> bytes;
        std::size_t gone = 0;
        std::optional<double> stamp = {};
    };

    std::size_t receiveNow(std::span<std::uint8_t> into);
    void receiveAfterOutage();
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
    std::deque<Segment> held_;      ///< data in transit to the client
    std::deque<Segment> arriving_;  ///< data in transit from the client
    std::size_t heldBytes_ = 0;
    bool isWatched_ = false;  ///< the link's poller watches the socket and sets hasArrived_
    bool hasArrived_ = true;  ///< data may be available
    bool open_ = true;
    bool closing_ = false;
    bool isUnresponsive_ = false;  ///< data no longer reach the client
    bool wasLost_ = false;         ///< the cable has been unplugged since the last read from the socket
    bool ended_ = false;           ///< the client has closed the connection; earlier data may still arrive
};

}  // namespace tiller::simulator
