// SPDX-License-Identifier: MIT
#pragma once

// Detects received data and new connections with one system call for all clients and ports. This is
// efficient, because neither occurs in most control periods of the simulated controller.

#include <vector>

#include "robot/platform/native_socket.h"

namespace tiller {

/// Threads  one
class SocketPoller {
public:
    SocketPoller();
    ~SocketPoller();
    SocketPoller(const SocketPoller&) = delete;
    SocketPoller& operator=(const SocketPoller&) = delete;

    /// Makes poll() set `rung` when data or the end of the connection can be read. Call remove() before
    /// closing the descriptor.
    /// Returns  false if the descriptor cannot be watched
    bool add(native_socket::Descriptor descriptor, bool* rung);
    void remove(native_socket::Descriptor descriptor);
    /// Watches a listening port until it is closed.
    void addPort(native_socket::Descriptor descriptor);

    /// Returns  true if a client may be waiting to connect. Does not block.
    bool poll();

private:
    struct Watched {
        native_socket::Descriptor descriptor;
        bool* rung;
    };
    native_socket::Descriptor descriptor_ = -1;  ///< Linux: epoll
    std::vector<Watched> watched_;               ///< other systems
    bool isBlind_ = false;                       ///< some ports cannot be watched
    bool hasClient_ = false;
};

}  // namespace tiller
