// SPDX-License-Identifier: MIT
#pragma once

// Reading and writing a connected TCP socket by its descriptor: what the 500 Hz loops and the simulated
// controller use, because QTcpSocket allocates on the way. tcp_connect.h opens such sockets.

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <span>

namespace tiller::native_socket {

using Descriptor = std::intptr_t;

enum class Status {
    Ok,          ///< some bytes were moved
    WouldBlock,  ///< none now; try again when the socket is ready
    Closed,      ///< the peer ended the connection in good order
    Failed,      ///< the connection is broken
};

struct Transfer {
    Status status = Status::Failed;
    std::size_t bytes = 0;
};

/// Makes the socket non-blocking, switches Nagle's algorithm off, keeps SIGPIPE away.
void prepare(Descriptor socket);

/// After so long without a sign of life from the peer's system a connection ends, idle or not. Long enough for the
/// hiccups of a network that TCP bridges; code that has to know sooner watches what the peer sends.
inline constexpr std::chrono::milliseconds kPeerTimeout(5000);

/// Has the system probe the peer: one without power never ends the connection. On Linux within kPeerTimeout,
/// elsewhere as the system is set up.
void watchPeer(Descriptor socket);

/// Threads  one reader and one writer at a time. Blocks: never. Real-time: one system call each
Transfer receive(Descriptor socket, std::span<std::uint8_t> into);
Transfer send(Descriptor socket, std::span<const std::uint8_t> bytes);  ///< As receive().

/// Ends the wait of another thread in waitReadable(). Where the system has no means for it, it does nothing
/// and the wait lasts as long as it would have. Threads  any. Blocks: never. Real-time: one system call each
class Waker {
public:
    Waker();
    ~Waker();
    Waker(const Waker&) = delete;
    Waker& operator=(const Waker&) = delete;

    void wake() const;  ///< Ends the wait under way, or the next one.
    /// Forgets the calls of wake() until now.
    /// Returns  whether there were any
    bool take() const;
    Descriptor descriptor() const { return descriptor_; }  ///< negative: there is no means

private:
    Descriptor descriptor_ = -1;
};

/// Waits until the socket can be read (data, end of stream or error), the waker, if any, wakes, or the time
/// is over. Returns  true when the socket can be read
bool waitReadable(Descriptor socket, std::chrono::nanoseconds atMost, const Waker* waker = nullptr);

/// Waits until something can be sent, or the connection has failed, or the time is over.
/// Returns  true in the first two cases
bool waitWritable(Descriptor socket, std::chrono::milliseconds atMost);

void close(Descriptor socket);  ///< Frees the descriptor.

/// The port of this end of a connection; 0 where there is none.
std::uint16_t localPort(Descriptor socket);
std::uint16_t peerPort(Descriptor socket);  ///< The same of the other end.

/// A second descriptor of the same connection, so that it can outlive the Qt socket that opened it. Negative
/// when the system has none left.
Descriptor duplicate(Descriptor socket);

}  // namespace tiller::native_socket
