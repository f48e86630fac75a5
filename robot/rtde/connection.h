// SPDX-License-Identifier: MIT
#pragma once

// An RTDE connection: opens a native socket, runs the handshake within a deadline, and then transfers data
// packages without allocating. The class starts no threads: one thread reads, and one thread at a time may
// send. The destructor closes the socket immediately, regardless of the state of the peer.

#include <QString>
#include <chrono>
#include <cstdint>
#include <memory>
#include <span>

#include "robot/core/deadline.h"
#include "robot/core/result.h"
#include "robot/core/text.h"
#include "robot/platform/native_socket.h"
#include "robot/rtde/protocol.h"
#include "robot/rtde/session.h"

namespace tiller::rtde {

struct ConnectionOptions {
    Text host = {};
    std::uint16_t port = kPort;
    SessionRequest request = {};
};

class Connection {
public:
    /// Connects and performs the handshake.
    /// Errors   AddressInvalid, HostUnreachable, ConnectionRefused, ConnectionClosed, Timeout, Cancelled,
    ///          ProtocolError, FieldUnknown (the controller has none of the outputs), RegisterInUse,
    ///          Rejected; the context contains host and port
    /// Threads  any. Blocks: until the deadline at most. Real-time: no
    static Result<std::unique_ptr<Connection>> open(const ConnectionOptions& options,
                                                    const Deadline& deadline);
    ~Connection();
    Connection(const Connection&) = delete;
    Connection& operator=(const Connection&) = delete;

    const SoftwareVersion& version() const;
    ProtocolVersion protocol() const;           ///< V2, or V1 with old software.
    const Recipe& outputs() const;              ///< The output recipe as accepted by the controller.
    const std::vector<Recipe>& inputs() const;  ///< The input recipes as accepted by the controller.
    /// The result of the handshake, including input names in use and text messages.
    const Session& session() const;
    /// Time between two data packages [s].
    double period() const;
    /// Address for messages, e.g. "192.168.0.10:30004".
    const QString& peer() const;
    native_socket::Descriptor descriptor() const;

    enum class Read {
        Package,   ///< the values were filled
        Nothing,   ///< no package arrived in time
        Closed,    ///< the controller ended the connection
        Failed,    ///< the connection failed
        Malformed  ///< the received bytes are not RTDE; see error()
    };
    /// Waits for the next data package and decodes it. Packages of other types are consumed; text messages
    /// are stored in session(). With a zero time, the function only checks for packages that have already
    /// arrived.
    /// values   at least outputs().size() numbers
    /// waker    may end the wait early; the result is then Nothing
    /// Blocks: atMost. Real-time: yes (two system calls per package)
    Read readPackage(std::span<double> values, std::chrono::nanoseconds atMost,
                     const native_socket::EventFd* waker = nullptr);
    /// Like readPackage(), without decoding the values.
    /// wire  set to the bytes that decodeEach() reads with outputs().layout(); valid until the next call
    Read readWire(ByteView& wire, std::chrono::nanoseconds atMost,
                  const native_socket::EventFd* waker = nullptr);
    /// Returns true if another package has already been received, so that readPackage() will not block.
    bool hasPackage() const;

    enum class Send {
        Sent,
        Busy,    ///< the peer is not reading; the package was dropped, but later packages may be sent
        Failed,  ///< the connection failed, or the recipe is not valid
    };
    /// Sends one data package.
    /// recipe   index into inputs()
    /// values   inputs()[recipe].size() numbers in its order
    /// Blocks: never. Real-time: yes (one system call)
    Send sendInputs(std::size_t recipe, std::span<const double> values);

    /// Resumes the data packages.
    /// Errors   Timeout, Cancelled, ConnectionClosed, Rejected, ProtocolError
    /// Blocks: until the deadline
    Result<void> start(const Deadline& deadline);
    /// Stops the data packages until start(). Errors as for start().
    Result<void> pause(const Deadline& deadline);

    /// Closes the socket. Later reads and sends fail. Blocks: never
    void close();
    bool isOpen() const;  ///< False after close() and after a failure.
    /// The reason for the last failed read or send.
    Error error() const;

private:
    struct State;
    explicit Connection(std::unique_ptr<State> state);
    std::unique_ptr<State> d_;
};

}  // namespace tiller::rtde
