// SPDX-License-Identifier: MIT
#pragma once

// One accepted connection: reads what has come, sends what fits, keeps a bounded rest. Never blocks.

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "robot/core/native_socket.h"

namespace tiller::simulator {

class Peer {
public:
    /// backlog  bytes kept for a peer that does not read at the moment
    Peer(native_socket::Descriptor descriptor, std::size_t backlog);
    ~Peer();
    Peer(const Peer&) = delete;
    Peer& operator=(const Peer&) = delete;

    bool isOpen() const { return open_; }
    void close();

    /// Receives once. Returns how many bytes came; closes when the peer has ended the connection.
    std::size_t receive(std::span<std::uint8_t> into);

    /// Sends, or keeps for later what the socket does not take now. False, with nothing taken, when the
    /// backlog has no room for it: this peer does not read.
    bool send(std::span<const std::uint8_t> bytes);
    bool send(std::string_view text);
    /// Sends from the backlog what the socket takes now.
    void flush();
    /// Bytes the socket did not take yet.
    std::size_t pending() const { return out_.size() - sent_; }

    /// Closes once the backlog has gone out.
    void closeAfterFlush();

private:
    std::size_t sendNow(std::span<const std::uint8_t> bytes);

    native_socket::Descriptor descriptor_;
    std::size_t backlog_;
    std::vector<std::uint8_t> out_;
    std::size_t sent_ = 0;
    bool open_ = true;
    bool closing_ = false;
};

}  // namespace tiller::simulator
