// SPDX-License-Identifier: MIT
#include "robot/io/robotiq_client.h"

#include <algorithm>
#include <charconv>
#include <span>

#include "robot/core/ascii.h"
#include "robot/core/tcp_connect.h"
#include "robot/platform/native_socket.h"

namespace tiller::io {

namespace {

using std::chrono::milliseconds;
using Status = native_socket::Status;

/// Maximum length of a line [bytes]. A longer line is not a valid reply of a gripper.
constexpr std::size_t kMaxReplyLength = 1024;
constexpr std::size_t kQuoted = 80;  // quoted length of an invalid reply [bytes]
/// Polling interval while waiting.
constexpr milliseconds kAskEvery(10);
/// No further request is sent when less time is left, because interrupting a request closes the connection.
constexpr milliseconds kLastAnswer(250);

std::optional<int> numberIn(std::string_view text) {
    int value = 0;
    const auto parsed = std::from_chars(text.data(), text.data() + text.size(), value);
    return parsed.ec == std::errc() && parsed.ptr == text.data() + text.size() ? std::optional(value)
                                                                               : std::nullopt;
}

ErrorCode expired(const Deadline& deadline) {
    return deadline.isCancelled() ? ErrorCode::Cancelled : ErrorCode::Timeout;
}

bool isByte(int value) {
    return value >= 0 && value <= kRobotiqMost;
}

/// True if the variable is a gripper register with a byte value. Other variables, such as the cycle counter,
/// can have larger values.
bool isRegister(std::string_view name) {
    constexpr std::string_view kRegisters[] = {"ACT", "GTO", "ATR", "ARD", "STA", "OBJ", "FLT",
                                               "POS", "PRE", "SPE", "FOR", "COU", "MOD"};
    return std::ranges::find(kRegisters, name) != std::end(kRegisters);
}

}  // namespace

struct RobotiqClient::Link {
    Text host;
    int port = kRobotiqPort;
    native_socket::Descriptor descriptor = -1;
    std::string received;

    void close() {
        if (descriptor >= 0) {
            native_socket::close(descriptor);
            descriptor = -1;
        }
        received.clear();
    }

    Error error(ErrorCode code, const std::string& line) const {
        return {
            code,
            QStringLiteral("gripper at %1:%2, \"%3\"").arg(host).arg(port).arg(QString::fromStdString(line)),
            {}};
    }
    Error broken(ErrorCode code, const std::string& line) {
        close();
        return error(code, line);
    }

    Result<std::string> ask(const std::string& line, const Deadline& deadline) {
        if (descriptor < 0) {
            return broken(ErrorCode::NotConnected, line);
        }
        const std::string text = line + "\n";
        for (std::size_t at = 0; at < text.size();) {
            const auto sent = native_socket::send(
                descriptor,
                std::span(reinterpret_cast<const std::uint8_t*>(text.data()) + at, text.size() - at));
            at += sent.bytes;
            if (sent.status == Status::Failed || sent.status == Status::Closed) {
                return broken(ErrorCode::ConnectionClosed, line);
            }
            if (at < text.size()) {
                if (deadline.hasExpired()) {
                    return broken(expired(deadline), line);
                }
                native_socket::waitWritable(descriptor, deadline.nextPoll());
            }
        }
        return readReply(line, deadline);
    }

    // The real URCap sends acknowledgements without a line end. All other replies end with a line end.
    std::optional<std::string> takeReply() {
        while (true) {
            const std::size_t end = received.find('\n');
            if (end == std::string::npos && received != "ack" && received != "nack") {
                return std::nullopt;
            }
            std::string reply = received.substr(0, std::min(end, received.size()));
            received.erase(0, end == std::string::npos ? received.size() : end + 1);
            if (!reply.empty() && reply.back() == '\r') {
                reply.pop_back();
            }
            if (!reply.empty()) {
                return reply;
            }
        }
    }

    Result<std::string> readReply(const std::string& line, const Deadline& deadline) {
        while (true) {
            if (auto reply = takeReply()) {
                return std::move(*reply);
            }
            // Check the deadline in every iteration, because the loop would never end with a peer that sends
            // continuously.
            if (received.size() > kMaxReplyLength) {
                const QString begin = QString::fromStdString(received.substr(0, kQuoted));
                Error error = broken(ErrorCode::ProtocolError, line);
                error.controllerMessage = begin;
                return error;
            }
            if (deadline.hasExpired()) {
                return broken(expired(deadline), line);
            }
            std::uint8_t bytes[256];
            const auto got = native_socket::receive(descriptor, bytes);
            if (got.status == Status::Ok) {
                received.append(reinterpret_cast<const char*>(bytes), got.bytes);
            } else if (got.status != Status::WouldBlock) {
                return broken(ErrorCode::ConnectionClosed, line);
            } else {
                native_socket::waitReadable(descriptor, deadline.nextPoll());
            }
        }
    }

    /// Waits until the next request. Unexpected input or a closed connection ends the wait early.
    void pause(const Deadline& deadline) const {
        native_socket::waitReadable(descriptor, std::min(deadline.remaining(), kAskEvery));
    }
};

RobotiqClient::RobotiqClient(Text host, int port) : d_(std::make_unique<Link>()) {
    d_->host = std::move(host);
    d_->port = port;
}

RobotiqClient::~RobotiqClient() {
    close();
}

Result<void> RobotiqClient::connect(const Deadline& deadline) {
    close();
    const auto connected = connectTcp(d_->host, d_->port, deadline);
    if (!connected) {
        return connected.error();
    }
    d_->descriptor = *connected;
    return {};
}

void RobotiqClient::close() {
    d_->close();
}

bool RobotiqClient::isConnected() const {
    return d_->descriptor >= 0;
}

Result<std::optional<int>> RobotiqClient::get(const std::string& name, const Deadline& deadline) {
    const std::string line = "GET " + name;
    const Result<std::string> reply = d_->ask(line, deadline);
    if (!reply) {
        return reply.error();
    }
    const std::string prefix = name + " ";
    if (reply->starts_with(prefix)) {
        const std::string_view value = trimmed(std::string_view(*reply).substr(prefix.size()));
        if (const auto number = numberIn(value); number && (isByte(*number) || !isRegister(name))) {
            return number;
        }
        if (value == "?") {
            return std::optional<int>();
        }
    }
    Error error = d_->error(ErrorCode::ProtocolError, line);
    error.controllerMessage = QString::fromStdString(*reply);
    return error;
}

Result<void> RobotiqClient::set(const Values& values, const Deadline& deadline) {
    std::string line = "SET";
    for (const auto& [name, value] : values) {
        line += " " + name + " " + std::to_string(value);
    }
    const Result<std::string> reply = d_->ask(line, deadline);
    if (!reply) {
        return reply.error();
    }
    if (*reply == "ack") {
        return {};
    }
    Error error = d_->error(ErrorCode::Rejected, line);
    error.controllerMessage = QString::fromStdString(*reply);
    return error;
}

Result<std::optional<RobotiqState>> RobotiqClient::look(const Deadline& deadline) {
    RobotiqState state;
    int activation = 0;
    int object = 0;
    int fault = 0;
    int goTo = 0;
    const std::pair<const char*, int*> wanted[] = {{"STA", &activation}, {"FLT", &fault},
                                                   {"GTO", &goTo},       {"PRE", &state.requested},
                                                   {"OBJ", &object},     {"POS", &state.position}};
    for (const auto& [name, value] : wanted) {
        const Result<std::optional<int>> got = get(name, deadline);
        if (!got) {
            return got.error();
        }
        if (!got->has_value()) {
            return std::optional<RobotiqState>();
        }
        *value = **got;
    }
    state.activation = static_cast<RobotiqActivation>(activation);
    state.object = static_cast<RobotiqObject>(object);
    state.fault = static_cast<RobotiqFault>(fault);
    state.goTo = goTo != 0;
    return std::optional(state);
}

Result<void> RobotiqClient::beginActivation(const Deadline& deadline) {
    if (auto done = set({{"ACT", 0}, {"ATR", 0}}, deadline); !done) {
        return done;
    }
    while (true) {
        const Result<std::optional<int>> status = get("STA", deadline);
        if (!status) {
            return status.error();
        }
        if (*status == static_cast<int>(RobotiqActivation::Reset)) {
            return set({{"ACT", 1}}, deadline);
        }
        if (deadline.remaining() < kLastAnswer) {
            return d_->error(deadline.isCancelled() ? ErrorCode::Cancelled : ErrorCode::Rejected,
                             "SET ACT 0");
        }
        d_->pause(deadline);
    }
}

Result<void> RobotiqClient::move(int position, int speed, int force, const Deadline& deadline) {
    const Values values{{"POS", position}, {"SPE", speed}, {"FOR", force}, {"GTO", 1}};
    for (const auto& [name, value] : values) {
        if (!isByte(value)) {
            return Error{ErrorCode::InvalidArgument,
                         QStringLiteral("gripper: %1 %2 is outside the range 0 to 255")
                             .arg(QString::fromStdString(name))
                             .arg(value),
                         {}};
        }
    }
    if (auto done = set(values, deadline); !done) {
        return done;
    }
    while (true) {
        const Result<std::optional<int>> taken = get("PRE", deadline);
        if (!taken) {
            return taken.error();
        }
        if (*taken == position) {
            return {};
        }
        if (deadline.remaining() < kLastAnswer) {
            return d_->error(deadline.isCancelled() ? ErrorCode::Cancelled : ErrorCode::Rejected, "SET POS");
        }
        d_->pause(deadline);
    }
}

Result<void> RobotiqClient::stop(const Deadline& deadline) {
    return set({{"GTO", 0}}, deadline);
}

}  // namespace tiller::io
