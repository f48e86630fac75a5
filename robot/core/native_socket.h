// SPDX-License-Identifier: MIT
#pragma once

// Reads and writes connected TCP sockets by descriptor. The 500 Hz loops and the simulated controller use it,
// because QTcpSocket allocates memory. tcp_connect.h opens such sockets.

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <span>

namespace tiller::native_socket {

using Descriptor = std::intptr_t;

enum class Status {
    Ok,          ///< some bytes were transferred
    WouldBlock,  ///< no bytes transferred; retry when the socket is ready
    Closed,      ///< the peer closed the connection
    Failed,      ///< the connection failed
};

struct Transfer {
    Status status = Status::Failed;
    std::size_t bytes = 0;
};

/// Makes the socket non-blocking, disables Nagle's algorithm and suppresses SIGPIPE.
void prepare(Descriptor socket);

/// A connection ends if the peer's system has not responded for this time, even if idle. The time covers
/// network interruptions from which TCP recovers. Code that needs a faster reaction monitors the received
/// data.
inline constexpr std::chrono::milliseconds kPeerTimeout(5000);

/// Enables keep-alive probes, because a peer that loses power never closes the connection. On Linux, the
/// connection ends within kPeerTimeout; on other systems, the time depends on their configuration.
void watchPeer(Descriptor socket);

/// Threads  one reader and one writer at a time. Blocks: never. Real-time: one system call each
Transfer receive(Descriptor socket, std::span<std::uint8_t> into);
/// Threads, blocking and real-time: same as receive().
Transfer send(Descriptor socket, std::span<const std::uint8_t> bytes);

/// Ends the wait of another thread in waitReadable(). On unsupported systems, it has no effect, and the wait
/// lasts until its timeout.
/// Threads  any. Blocks: never. Real-time: one system call each
class EventFd {
public:
    EventFd();
    ~EventFd();
    EventFd(const EventFd&) = delete;
    EventFd& operator=(const EventFd&) = delete;

    void wake() const;  ///< Ends the current wait, or the next one.
    /// Resets the object after calls to wake().
    /// Returns  true if wake() was called
    bool take() const;
    Descriptor descriptor() const { return descriptor_; }  ///< negative if unsupported by the system

private:
    Descriptor descriptor_ = -1;
};

/// Waits until the socket is readable (data, end of stream or error), the waker is triggered, or the time has
/// expired.
/// Returns  true if the socket is readable
bool waitReadable(Descriptor socket, std::chrono::nanoseconds atMost, const EventFd* waker = nullptr);

/// Waits until the socket is writable, the connection has failed, or the time has expired.
/// Returns  true in the first two cases
bool waitWritable(Descriptor socket, std::chrono::milliseconds atMost);

void close(Descriptor socket);
/// Makes close() reset the connection, which discards data that have not been delivered yet.
void discardOnClose(Descriptor socket);

/// Local port of the connection; 0 if not connected.
std::uint16_t localPort(Descriptor socket);
std::uint16_t peerPort(Descriptor socket);  ///< Remote port of the connection; 0 if not connected.

/// Returns a second descriptor of the connection, which can outlive the Qt socket that opened it. Negative if
/// the system has no free descriptors.
Descriptor duplicate(Descriptor socket);

}  // namespace tiller::native_socket
