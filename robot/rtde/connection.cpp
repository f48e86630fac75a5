// SPDX-License-Identifier: MIT
#include "robot/rtde/connection.h"

#include <algorithm>
#include <array>
#include <mutex>
#include <optional>

#include "robot/core/tcp_connect.h"

namespace tiller::rtde {

namespace {

using native_socket::Descriptor;
using Status = native_socket::Status;
using std::chrono::nanoseconds;

constexpr Descriptor kNoSocket = -1;
constexpr QLatin1String kMisfit("a data packet does not match the output recipe");

}  // namespace

struct Connection::State {
    explicit State(SessionRequest request) : session(std::move(request)) {}

    Session session;
    PackageSplitter splitter;
    Descriptor socket = kNoSocket;
    QString peer;
    mutable std::mutex errorMutex;
    Error error;    ///< protected by the mutex
    Bytes replies;  ///< bytes that the session must send
    // The data package being sent. Bytes remain here only while the peer is not reading.
    std::array<std::uint8_t, kMaxPackageSize> outgoing{};
    std::size_t outgoingBegin = 0;
    std::size_t outgoingEnd = 0;

    ~State() { close(); }

    void close() {
        if (socket != kNoSocket) {
            native_socket::close(socket);
            socket = kNoSocket;
        }
    }

    // Thread-safe, because both the reader and the writer may detect a broken connection.
    void failWith(ErrorCode code, const QString& what) { keep({code, peer, what}); }
    void keep(const Error& reason) {
        const std::lock_guard lock(errorMutex);
        error = reason;
    }

    Status flush() {
        while (outgoingBegin < outgoingEnd) {
            const auto sent = native_socket::send(
                socket, ByteView(outgoing).subspan(outgoingBegin, outgoingEnd - outgoingBegin));
            if (sent.status != Status::Ok) {
                return sent.status;
            }
            outgoingBegin += sent.bytes;
        }
        outgoingBegin = outgoingEnd = 0;
        return Status::Ok;
    }

    Result<void> sendReplies(const Deadline& deadline) {
        for (std::size_t at = 0; at < replies.size();) {
            const auto sent = native_socket::send(socket, ByteView(replies).subspan(at));
            if (sent.status == Status::Ok) {
                at += sent.bytes;
                continue;
            }
            if (sent.status != Status::WouldBlock) {
                return Error{ErrorCode::ConnectionClosed, where(), {}};
            }
            if (deadline.hasExpired()) {
                return expired(deadline);
            }
            native_socket::waitReadable(socket, deadline.nextPoll());
        }
        replies.clear();
        return {};
    }

    QString where() const {
        return session.awaited().isEmpty()
                   ? QStringLiteral("RTDE at %1").arg(peer)
                   : QStringLiteral("RTDE at %1, waiting for %2").arg(peer, session.awaited());
    }

    Error expired(const Deadline& deadline) const {
        return {deadline.isCancelled() ? ErrorCode::Cancelled : ErrorCode::Timeout, where(), {}};
    }

    Error located(const Error& inner) const {
        return {inner.code, QStringLiteral("RTDE at %1: %2").arg(peer, inner.context),
                inner.controllerMessage};
    }

    /// Advances the session until `done` returns true.
    template <class Done>
    Result<void> converse(const Deadline& deadline, Done done) {
        if (socket == kNoSocket) {
            return Error{ErrorCode::NotConnected, QStringLiteral("RTDE at %1").arg(peer), {}};
        }
        for (;;) {
            if (auto sent = sendReplies(deadline); !sent) {
                return sent;
            }
            // Stop as soon as `done` is true, because the remaining bytes in the buffer are data for the
            // caller.
            while (!done() && !session.isFailed()) {
                const auto package = splitter.next();
                if (!package) {
                    break;
                }
                session.handle(*package, replies);
            }
            if (session.isFailed()) {
                return located(session.error());
            }
            if (splitter.fault() != PackageSplitter::Fault::None) {
                return located(splitter.error());
            }
            if (!replies.empty()) {
                continue;
            }
            if (done()) {
                return {};
            }
            const auto got = native_socket::receive(socket, splitter.writable());
            if (got.status == Status::Ok) {
                splitter.commit(got.bytes);
                continue;
            }
            if (got.status == Status::Closed || got.status == Status::Failed) {
                return Error{ErrorCode::ConnectionClosed, where(), {}};
            }
            if (deadline.hasExpired()) {
                return expired(deadline);
            }
            native_socket::waitReadable(socket, deadline.nextPoll());
        }
    }
};

Connection::Connection(std::unique_ptr<State> state) : d_(std::move(state)) {}

Connection::~Connection() = default;

Result<std::unique_ptr<Connection>> Connection::open(const ConnectionOptions& options,
                                                     const Deadline& deadline) {
    auto state = std::make_unique<State>(options.request);
    state->peer = QStringLiteral("%1:%2").arg(options.host.trimmed()).arg(options.port);
    const auto socket = connectTcp(options.host, options.port, deadline,
                                   QStringLiteral("connect to RTDE at %1").arg(state->peer));
    if (!socket) {
        Error error = socket.error();
        if (error.code == ErrorCode::Timeout) {
            error.code = ErrorCode::HostUnreachable;  // Timeout is only used if the host was reached.
        }
        return error;
    }
    state->socket = *socket;
    Session& session = state->session;
    session.begin(state->replies);
    if (auto shaken = state->converse(deadline, [&] { return session.isReady(); }); !shaken) {
        return shaken.error();
    }
    return std::unique_ptr<Connection>(new Connection(std::move(state)));
}

const SoftwareVersion& Connection::version() const {
    return d_->session.version();
}

ProtocolVersion Connection::protocol() const {
    return d_->session.protocol();
}

const Recipe& Connection::outputs() const {
    return d_->session.outputs();
}

const std::vector<Recipe>& Connection::inputs() const {
    return d_->session.inputs();
}

const Session& Connection::session() const {
    return d_->session;
}

double Connection::period() const {
    return d_->session.period();
}

const QString& Connection::peer() const {
    return d_->peer;
}

Descriptor Connection::descriptor() const {
    return d_->socket;
}

bool Connection::hasPackage() const {
    return d_->splitter.hasNext();
}

Connection::Read Connection::readPackage(std::span<double> values, nanoseconds atMost,
                                         const native_socket::EventFd* waker) {
    ByteView wire;
    const Read read = readWire(wire, atMost, waker);
    if (read == Read::Package && !decodeValues(outputs().layout(), wire, values)) {
        d_->failWith(ErrorCode::ProtocolError, QString(kMisfit));
        return Read::Malformed;
    }
    return read;
}

Connection::Read Connection::readWire(ByteView& wire, nanoseconds atMost,
                                      const native_socket::EventFd* waker) {
    State& d = *d_;
    if (d.socket == kNoSocket) {
        return Read::Failed;
    }
    const auto end = std::chrono::steady_clock::now() + atMost;
    const bool onlyLook = atMost.count() <= 0;
    bool timeIsUp = false;
    for (;;) {
        while (const auto package = d.splitter.next()) {
            if (package->type != PackageType::Data || d.session.state() != Session::State::Running) {
                d.session.handle(*package, d.replies);
                continue;
            }
            const auto data = readOutputData(package->payload, d.session.protocol());
            const Recipe& recipe = d.session.outputs();
            const bool numbered = d.session.protocol() != ProtocolVersion::V1;
            if (!data || (numbered && data->recipeId != recipe.id()) ||
                data->values.size() != recipe.layout().wireBytes()) {
                d.failWith(ErrorCode::ProtocolError, QString(kMisfit));
                return Read::Malformed;
            }
            wire = data->values;
            return Read::Package;
        }
        if (d.splitter.fault() != PackageSplitter::Fault::None) {
            d.keep(d.located(d.splitter.error()));
            return Read::Malformed;
        }
        if (timeIsUp) {
            return Read::Nothing;
        }
        // Waiting before reading costs two system calls per package. Reading first would cost three.
        if (!onlyLook) {
            const auto left = end - std::chrono::steady_clock::now();
            if (left.count() <= 0 || !native_socket::waitReadable(d.socket, left, waker)) {
                return Read::Nothing;
            }
        }
        const auto got = native_socket::receive(d.socket, d.splitter.writable());
        switch (got.status) {
            case Status::Ok:
                d.splitter.commit(got.bytes);
                // A peer that floods the connection with other packages must not block this call.
                timeIsUp = std::chrono::steady_clock::now() >= end;
                break;
            case Status::WouldBlock:
                timeIsUp = onlyLook;
                break;
            case Status::Closed:
                d.failWith(ErrorCode::ConnectionClosed,
                           QStringLiteral("the controller ended the connection"));
                return Read::Closed;
            case Status::Failed:
                d.failWith(ErrorCode::LinkLost, QStringLiteral("the connection was lost"));
                return Read::Failed;
        }
    }
}

Connection::Send Connection::sendInputs(std::size_t recipe, std::span<const double> values) {
    State& d = *d_;
    const auto& recipes = d.session.inputs();
    if (d.socket == kNoSocket || recipe >= recipes.size() || !recipes[recipe].isValid()) {
        return Send::Failed;
    }
    // The remaining bytes of an earlier package must be sent first to keep the stream intact.
    Status status = d.flush();
    if (status == Status::Ok) {
        d.outgoingEnd = writeDataPackage(d.outgoing, recipes[recipe].id(), recipes[recipe].layout(), values);
        if (d.outgoingEnd == 0) {
            return Send::Failed;
        }
        status = d.flush();
        if (status == Status::WouldBlock) {
            // If no byte of the package was sent, drop the package. Otherwise the remaining bytes are sent
            // with the next package.
            const bool begun = d.outgoingBegin > 0;
            if (!begun) {
                d.outgoingEnd = 0;
            }
            return begun ? Send::Sent : Send::Busy;
        }
    } else if (status == Status::WouldBlock) {
        return Send::Busy;
    }
    if (status != Status::Ok) {
        d.failWith(ErrorCode::LinkLost, QStringLiteral("the connection was lost while sending"));
        return Send::Failed;
    }
    return Send::Sent;
}

Result<void> Connection::start(const Deadline& deadline) {
    Session& session = d_->session;
    if (!session.outputs().isValid()) {
        return Error{
            ErrorCode::Rejected, QStringLiteral("RTDE at %1: start without outputs").arg(d_->peer), {}};
    }
    session.start(d_->replies);
    return d_->converse(deadline, [&] { return session.state() == Session::State::Running; });
}

Result<void> Connection::pause(const Deadline& deadline) {
    Session& session = d_->session;
    session.pause(d_->replies);
    return d_->converse(deadline, [&] { return session.state() == Session::State::Ready; });
}

void Connection::close() {
    d_->close();
}

bool Connection::isOpen() const {
    return d_->socket != kNoSocket;
}

Error Connection::error() const {
    const std::lock_guard lock(d_->errorMutex);
    return d_->error;
}

}  // namespace tiller::rtde
