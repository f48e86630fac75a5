// SPDX-License-Identifier: MIT
#pragma once

// An RTDE connection: opens a native socket, runs the handshake within a deadline, and then moves data packages
// over it without allocating. Its owner reads it in one thread and may send from others, one at a time; it has
// none of its own. The destructor closes it, at once, whatever the peer does.

#include <QString>
#include <chrono>
#include <cstdint>
#include <memory>
#include <span>

#include "robot/core/deadline.h"
#include "robot/core/native_socket.h"
#include "robot/core/result.h"
#include "robot/core/text.h"
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
    /// Connects and shakes hands.
    /// Errors   AddressInvalid, HostUnreachable, ConnectionRefused, ConnectionClosed, Timeout, Cancelled,
    ///          ProtocolError, FieldUnknown (none of the outputs exists), RegisterInUse, Rejected; the
    ///          context names host and port
    /// Threads  any. Blocks: until the deadline at most. Real-time: no
    static Result<std::unique_ptr<Connection>> open(const ConnectionOptions& options,
                                                    const Deadline& deadline);
    ~Connection();
    Connection(const Connection&) = delete;
    Connection& operator=(const Connection&) = delete;

    const SoftwareVersion& version() const;     ///< Of the controller.
    ProtocolVersion protocol() const;           ///< 2, or 1 on old software.
    const Recipe& outputs() const;              ///< As the controller answered.
    const std::vector<Recipe>& inputs() const;  ///< As the controller answered.
    /// The whole answer of the handshake: names in use, text messages.
    const Session& session() const;
    /// Time between two data packages [s].
    double period() const;
    /// "192.168.0.10:30004", for messages.
    const QString& peer() const;
    native_socket::Descriptor descriptor() const;  ///< Of the socket.

    enum class Read {
        Package,   ///< values were filled
        Nothing,   ///< no package within the time
        Closed,    ///< the controller ended the connection
        Failed,    ///< the connection broke
        Malformed  ///< bytes that are no RTDE; see error()
    };
    /// Waits for the next data package and decodes it. Packages of other kinds are taken in silently (text
    /// messages are kept in session()). A zero time only looks.
    /// values   at least outputs().size() numbers
    /// waker    may end the wait early: Nothing then
    /// Blocks: atMost. Real-time: yes (two system calls a package)
    Read readPackage(std::span<double> values, std::chrono::nanoseconds atMost,
                     const native_socket::Waker* waker = nullptr);
    /// The same without decoding, for who has a better place for the numbers than a row of them.
    /// wire  becomes what decodeEach() takes with outputs().layout(); there until the next call
    Read readWire(ByteView& wire, std::chrono::nanoseconds atMost,
                  const native_socket::Waker* waker = nullptr);
    /// True when another package has already been received: readPackage() will not wait.
    bool hasPackage() const;

    enum class Send {
        Sent,
        Busy,    ///< the peer does not read; the package was dropped, a later one may pass
        Failed,  ///< the connection broke, or the recipe is not valid
    };
    /// Sends one data package.
    /// recipe   index into inputs()
    /// values   inputs()[recipe].size() numbers in its order
    /// Blocks: never. Real-time: yes (one system call)
    Send sendInputs(std::size_t recipe, std::span<const double> values);

    /// Errors  Timeout, Cancelled, ConnectionClosed, Rejected, ProtocolError. Blocks: deadline
    Result<void> start(const Deadline& deadline);
    Result<void> pause(const Deadline& deadline);  ///< Data stop until start().

    /// Closes the socket. Reading and sending fail from now on. Blocks: never
    void close();
    bool isOpen() const;  ///< Neither closed nor failed.
    /// Why the last read or send did not work.
    Error error() const;

private:
    struct State;
    explicit Connection(std::unique_ptr<State> state);
    std::unique_ptr<State> d_;
};

}  // namespace tiller::rtde
