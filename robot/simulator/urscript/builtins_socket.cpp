// SPDX-License-Identifier: MIT
// TCP sockets of the program. Read functions check the received data in each frame until there are enough
// data, the connection ends, or the timeout expires.

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "robot/simulator/urscript/builtin_table.h"
#include "robot/simulator/urscript/call.h"
#include "robot/simulator/urscript/value_format.h"

namespace tiller::simulator::urscript {

namespace {

constexpr std::int64_t kConnectNs = 2'000'000'000;
constexpr int kMaxReadCount = 30;

// The script of a gripper manufacturer passes socket numbers: 1 is the socket "1".
const std::string& socketName(Call& c, std::size_t i) {
    if (c.args[i].isNumber()) {
        c.args[i] = Value(toStr(c.args[i], kMaxStringLength));
    }
    return c.string(i);
}

bool expired(const Call& c, std::size_t timeoutArgument) {
    const double seconds = c.number(timeoutArgument);
    return seconds > 0 && static_cast<double>(c.waitedNs) >= seconds * 1e9 - 1.0;
}

// Returns true if no more bytes can arrive. Must be called only if the received bytes are not sufficient. A
// read that fails at once uses the rest of the frame. Otherwise, a loop that reads from a closed socket would
// exceed the operation limit.
bool over(Call& c, const std::string& socket, std::size_t timeoutArgument) {
    const bool ended = c.host.socketState(socket) != SocketHost::State::Open || expired(c, timeoutArgument);
    c.endFrame = ended && c.first;
    return ended;
}

// Removes the bytes that have been read.
void consume(Call& c, const std::string& socket, std::size_t bytes) {
    constexpr std::int64_t kCost = 20;
    c.host.consumeBytes(socket, bytes);
    c.readSocket = true;
    c.cost += kCost;
}

Status socketOpen(Call& c) {
    const std::string& name = socketName(c, 2);
    // A failed connection attempt, e.g. without a network, also takes a period. Otherwise, a loop that
    // retries would exceed the operation limit.
    if (c.first && !c.host.openSocket(name, c.string(0), c.integerIn(1, 1, 65535))) {
        c.result = false;
        c.endFrame = true;
        return Status::Done;
    }
    switch (c.host.socketState(name)) {
        case SocketHost::State::Open:
            c.result = true;
            return Status::Done;
        case SocketHost::State::Closed:
            c.result = false;
            c.endFrame = c.first;
            return Status::Done;
        case SocketHost::State::Connecting:
            break;
    }
    if (c.waitedNs >= kConnectNs) {
        c.host.closeSocket(name);
        c.result = false;
        return Status::Done;
    }
    return Status::Again;
}

Status socketClose(Call& c) {
    c.host.closeSocket(socketName(c, 0));
    return Status::Done;
}

Status readBinaryInteger(Call& c) {
    const auto count = static_cast<std::size_t>(c.integerIn(0, 0, kMaxReadCount));
    const std::string& name = socketName(c, 1);
    const std::string_view bytes = c.host.receivedBytes(name);
    std::vector<std::int32_t> out(count + 1, -1);
    if (bytes.size() >= 4 * count && count > 0) {
        out[0] = static_cast<std::int32_t>(count);
        for (std::size_t i = 0; i < count; ++i) {
            std::uint32_t value = 0;
            for (std::size_t k = 0; k < 4; ++k) {
                value = value << 8 | static_cast<unsigned char>(bytes[4 * i + k]);
            }
            out[i + 1] = static_cast<std::int32_t>(value);
        }
        consume(c, name, 4 * count);
    } else if (!over(c, name, 2)) {
        return Status::Again;
    } else {
        out[0] = 0;
    }
    c.result = Value::ints(out.data(), out.size());
    return Status::Done;
}

Status readByteList(Call& c) {
    const auto count = static_cast<std::size_t>(c.integerIn(0, 0, kMaxReadCount));
    const std::string& name = socketName(c, 1);
    const std::string_view bytes = c.host.receivedBytes(name);
    std::vector<std::int32_t> out(count + 1, -1);
    if (bytes.size() >= count && count > 0) {
        out[0] = static_cast<std::int32_t>(count);
        std::transform(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(count), out.begin() + 1,
                       [](char b) { return static_cast<unsigned char>(b); });
        consume(c, name, count);
    } else if (!over(c, name, 2)) {
        return Status::Again;
    } else {
        out[0] = 0;
    }
    c.result = Value::ints(out.data(), out.size());
    return Status::Done;
}

// A message such as "( 1.4 , 3.1 )" ends at the closing bracket.
Status readAsciiFloat(Call& c) {
    const auto count = static_cast<std::size_t>(c.integerIn(0, 0, kMaxReadCount));
    const std::string& name = socketName(c, 1);
    const std::string_view bytes = c.host.receivedBytes(name);
    std::vector<double> out(count + 1, std::numeric_limits<double>::quiet_NaN());
    out[0] = 0;
    const std::size_t close = bytes.find(')');
    if (close != std::string_view::npos) {
        const std::size_t open = bytes.find('(');
        std::string_view rest = open < close ? bytes.substr(open + 1, close - open - 1) : std::string_view();
        std::size_t got = 0;
        while (got < count && !rest.empty()) {
            const std::size_t comma = std::min(rest.find(','), rest.size());
            std::string_view item = rest.substr(0, comma);
            rest.remove_prefix(std::min(comma + 1, rest.size()));
            item.remove_prefix(std::min(item.find_first_not_of(" \t\r\n+"), item.size()));
            double value = 0;
            if (std::from_chars(item.data(), item.data() + item.size(), value).ec != std::errc()) {
                break;
            }
            out[++got] = value;
        }
        out[0] = static_cast<double>(got);
        consume(c, name, close + 1);
    } else if (!over(c, name, 2)) {
        return Status::Again;
    }
    c.result = Value::floats(out.data(), out.size());
    return Status::Done;
}

std::string unescaped(const std::string& s) {
    std::string out;
    for (std::size_t i = 0; i < s.size(); ++i) {
        if (s[i] == '\\' && i + 1 < s.size()) {
            ++i;
            out += s[i] == 'n' ? '\n' : s[i] == 'r' ? '\r' : s[i] == 't' ? '\t' : s[i];
        } else {
            out += s[i];
        }
    }
    return out;
}

Status readString(Call& c) {
    const std::string& name = socketName(c, 0);
    const bool escapes = c.boolean(3);
    const std::string prefix = escapes ? unescaped(c.string(1)) : c.string(1);
    const std::string suffix = escapes ? unescaped(c.string(2)) : c.string(2);
    const std::string_view bytes = c.host.receivedBytes(name);
    const std::size_t start = bytes.find(prefix);
    std::size_t end = std::string_view::npos;  // end of the text
    if (start != std::string_view::npos && !bytes.empty()) {
        const std::size_t text = start + prefix.size();
        end = suffix.empty() ? bytes.size() : bytes.find(suffix, text);
        if (end != std::string_view::npos) {
            c.result = Value(std::string(bytes.substr(text, std::min(end - text, kMaxStringLength))));
            // Text beyond the maximum string length is kept for the next read.
            const std::size_t taken =
                end - text > kMaxStringLength ? text + kMaxStringLength : end + suffix.size();
            consume(c, name, taken);
            return Status::Done;
        }
    }
    if (!over(c, name, 4)) {
        return Status::Again;
    }
    c.result = Value(std::string());
    return Status::Done;
}

Status readLine(Call& c) {
    const std::string& name = socketName(c, 0);
    const std::string_view bytes = c.host.receivedBytes(name);
    const std::size_t newline = bytes.find('\n');
    if (newline != std::string_view::npos) {
        std::string_view line = bytes.substr(0, newline);
        if (!line.empty() && line.back() == '\r') {
            line.remove_suffix(1);
        }
        c.result = Value(std::string(line.substr(0, kMaxStringLength)));
        consume(c, name, newline + 1);
        return Status::Done;
    }
    if (!over(c, name, 1)) {
        return Status::Again;
    }
    c.result = Value(std::string());
    return Status::Done;
}

Status sendByte(Call& c) {
    const char byte = static_cast<char>(c.integer(0) & 0xff);
    c.result = c.host.sendSocket(socketName(c, 1), {&byte, 1});
    return Status::Done;
}

Status sendInt(Call& c) {
    const auto value = static_cast<std::uint32_t>(c.integer(0));
    const char bytes[4] = {static_cast<char>(value >> 24), static_cast<char>(value >> 16 & 0xff),
                           static_cast<char>(value >> 8 & 0xff), static_cast<char>(value & 0xff)};
    c.result = c.host.sendSocket(socketName(c, 1), {bytes, 4});
    return Status::Done;
}

Status sendLine(Call& c) {
    c.result = c.host.sendSocket(socketName(c, 1), toStr(c.args[0], kMaxStringLength) + "\n");
    return Status::Done;
}

Status sendString(Call& c) {
    c.result = c.host.sendSocket(socketName(c, 1), toStr(c.args[0], kMaxStringLength));
    return Status::Done;
}

// Sends "GET name" and waits for "name value".
Status getVar(Call& c) {
    const std::string& variable = c.string(0);
    const std::string& name = socketName(c, 1);
    c.result = std::int32_t{0};
    if (c.first && !c.host.sendSocket(name, "GET " + variable + "\n")) {
        return Status::Done;
    }
    const std::string_view bytes = c.host.receivedBytes(name);
    const std::size_t newline = bytes.find('\n');
    if (newline == std::string_view::npos) {
        const bool ended = c.host.socketState(name) != SocketHost::State::Open || c.waitedNs >= kConnectNs;
        return ended ? Status::Done : Status::Again;
    }
    std::string_view line = bytes.substr(0, newline);
    if (line.substr(0, variable.size()) == variable) {
        line.remove_prefix(variable.size());
        line.remove_prefix(std::min(line.find_first_not_of(' '), line.size()));
        std::int32_t value = 0;
        std::from_chars(line.data(), line.data() + line.size(), value);
        c.result = value;
    }
    consume(c, name, newline + 1);
    return Status::Done;
}

Status setVar(Call& c) {
    c.host.sendSocket(socketName(c, 2), "SET " + c.string(0) + " " + std::to_string(c.integer(1)) + "\n");
    return Status::Done;
}

constexpr BuiltinRow kSocketRows[] = {
    {"socket_open(address, port, socket_name=\"socket_0\")", socketOpen},
    {"socket_close(socket_name=\"socket_0\")", socketClose},
    {"socket_read_binary_integer(number, socket_name=\"socket_0\", timeout=2)", readBinaryInteger},
    {"socket_read_ascii_float(number, socket_name=\"socket_0\", timeout=2)", readAsciiFloat},
    {"socket_read_byte_list(number, socket_name=\"socket_0\", timeout=2)", readByteList},
    {"socket_read_string(socket_name=\"socket_0\", prefix=\"\", suffix=\"\", interpret_escape=False, "
     "timeout=2)",
     readString},
    {"socket_read_line(socket_name=\"socket_0\", timeout=2)", readLine},
    {"socket_send_byte(value, socket_name=\"socket_0\")", sendByte},
    {"socket_send_int(value, socket_name=\"socket_0\")", sendInt},
    {"socket_send_line(str, socket_name=\"socket_0\")", sendLine},
    {"socket_send_string(str, socket_name=\"socket_0\")", sendString},
    {"socket_get_var(name, socket_name=\"socket_0\")", getVar},
    {"socket_set_var(name, value, socket_name=\"socket_0\")", setVar},
};

}  // namespace

std::span<const BuiltinRow> socketBuiltins() {
    return kSocketRows;
}

}  // namespace tiller::simulator::urscript
