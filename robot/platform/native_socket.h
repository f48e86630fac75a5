// SPDX-License-Identifier: MIT
#pragma once

// TCP sockets by descriptor. The 500 Hz loops and the simulated controller use them, because QTcpSocket
// allocates memory. robot/core/tcp_connect.h opens connections with a deadline.

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

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

/// Prepares the process for sockets, which Windows requires. The functions of this file that open sockets call
/// it.
/// Returns  false if the system has no sockets
bool startUp();

/// Makes the socket non-blocking, disables Nagle's algorithm and suppresses SIGPIPE.
void prepare(Descriptor socket);

/// A connection ends if the peer's system has not responded for this time, even if idle. The time covers
/// network interruptions from which TCP recovers. Code that needs a faster reaction monitors the received
/// data.
inline constexpr std::chrono::milliseconds kPeerTimeout(5000);

/// Enables keep-alive probes, because a peer that loses power never closes the connection. On Linux and
/// Windows, the connection ends within kPeerTimeout; on other systems, the time depends on their configuration.
void watchPeer(Descriptor socket);

/// Threads  one reader and one writer at a time. Blocks: never. Real-time: one system call each
Transfer receive(Descriptor socket, std::span<std::uint8_t> into);
/// Threads, blocking and real-time: same as receive().
Transfer send(Descriptor socket, std::span<const std::uint8_t> bytes);

/// Ends the wait of another thread in waitReadable(). On macOS, it has no effect, and the wait lasts until its
/// timeout.
/// Threads  any. Blocks: never. Real-time: one system call each
class EventFd {
public:
    EventFd();
    ~EventFd();
    EventFd(const EventFd&) = delete;
    EventFd& operator=(const EventFd&) = delete;

    void wake() const;  ///< Ends the current wait, or the next wait.
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

/// An address with a port, in the format of the system.
struct Address {
    int family = 0;
    std::vector<std::uint8_t> bytes{};
};

/// The addresses of a host; empty if the name is unknown. Blocks: for the time of the name service
std::vector<Address> resolve(const std::string& host, int port);

struct Attempt {
    Descriptor socket = -1;  ///< negative if the system has no free descriptors
    int error = 0;           ///< error number of the system, for qt_error_string()
    bool isPending = false;  ///< waitWritable() and then connectError() return the result
};

/// Starts to connect with a non-blocking socket, which the caller must close. Blocks: never
Attempt connect(const Address& address);
/// Error number of the system for a completed attempt; 0 if connected.
int connectError(Descriptor socket);
/// True if the error means that the host responds, but no process listens on the port.
bool isRefusal(int error);

/// Listens on a port of all IPv4 interfaces with a non-blocking socket.
/// Returns  a negative number if the port is in use
Descriptor listen(int port, int backlog);
/// Accepts a connection of a listening socket.
/// Returns  a negative number if there is none
Descriptor accept(Descriptor listener);

}  // namespace tiller::native_socket
