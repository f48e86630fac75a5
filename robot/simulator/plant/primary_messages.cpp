// SPDX-License-Identifier: MIT
#include "robot/simulator/plant/primary_messages.h"

#include <algorithm>

#include "robot/simulator/net/byte_writer.h"
#include "robot/simulator/plant/personality.h"

namespace tiller::simulator::primary {

namespace {

constexpr unsigned kRobotMessage = 20;

enum Source : int { RealTimeMachine = -3, RobotInterface = -2, ControllerItself = 7 };
enum Kind : unsigned {
    Text = 0,
    Label = 1,
    Popup = 2,
    Version = 3,
    SafetyModeChange = 5,
    Error = 6,
    Key = 7,
    RequestValue = 9,
    Exception = 10
};

/// Adds the package frame and header to the content written by `body`.
template <class Body>
Bytes message(std::uint64_t timestampNs, Source source, Kind kind, Body body) {
    Bytes bytes;
    ByteWriter out(bytes);
    const std::size_t length = out.openLength();
    out.u8(kRobotMessage).u64(timestampNs).u8(static_cast<unsigned>(source)).u8(kind);
    body(out);
    out.closeLength(length);
    return bytes;
}

/// Writes a text preceded by its length in one byte.
void counted(ByteWriter& out, std::string_view text) {
    text = text.substr(0, 255);
    out.u8(static_cast<unsigned>(text.size())).text(text);
}

/// Limits the length of a text, because clients drop packages of 4092 bytes or more.
std::string_view bounded(std::string_view text) {
    return text.substr(0, 3800);
}

}  // namespace

Bytes version(const SoftwareVersion& software) {
    // Robots send this value instead of a time stamp. Source: recorded messages.
    constexpr std::uint64_t kNoTime = ~std::uint64_t{0};
    return message(kNoTime, RobotInterface, Version, [&](ByteWriter& out) {
        counted(out, "URControl");
        out.u8(software.major).u8(software.minor);
        out.u32(software.bugfix).u32(software.build);
        out.text(buildDate(software));
    });
}

Bytes text(std::uint64_t timestampNs, std::string_view words) {
    return message(timestampNs, RealTimeMachine, Text, [&](ByteWriter& out) { out.text(bounded(words)); });
}

Bytes label(std::uint64_t timestampNs, std::int32_t id, std::string_view words) {
    return message(timestampNs, RobotInterface, Label,
                   [&](ByteWriter& out) { out.i32(id).text(bounded(words)); });
}

Bytes key(std::uint64_t timestampNs, std::string_view title, std::string_view words) {
    return message(timestampNs, RobotInterface, Key, [&](ByteWriter& out) {
        out.i32(0).i32(0);
        counted(out, title);
        out.text(bounded(words));
    });
}

Bytes errorCode(std::uint64_t timestampNs, const ErrorCode& error) {
    return message(timestampNs, ControllerItself, Error, [&](ByteWriter& out) {
        out.i32(error.code).i32(error.argument).i32(static_cast<std::int32_t>(error.level));
        out.u32(0).u32(0).text(bounded(error.text));
    });
}

Bytes runtimeException(std::uint64_t timestampNs, std::int32_t line, std::int32_t column,
                       std::string_view words) {
    return message(timestampNs, RealTimeMachine, Exception,
                   [&](ByteWriter& out) { out.i32(line).i32(column).text(bounded(words)); });
}

Bytes safetyMode(std::uint64_t timestampNs, tiller::SafetyMode mode) {
    return message(timestampNs, RealTimeMachine, SafetyModeChange,
                   [&](ByteWriter& out) { out.i32(0).i32(0).u8(static_cast<unsigned>(mode)).u32(1).u32(0); });
}

bool isSafetyMode(const Bytes& message) {
    constexpr std::size_t kKindAt = 14;
    return message.size() > kKindAt && message[4] == kRobotMessage && message[kKindAt] == SafetyModeChange;
}

Bytes requestValue(std::uint64_t timestampNs, std::uint32_t id, std::uint32_t kind, std::string_view words) {
    return message(timestampNs, RobotInterface, RequestValue,
                   [&](ByteWriter& out) { out.u32(id).u32(kind).text(bounded(words)); });
}

Bytes popup(std::uint64_t timestampNs, const PopupMessage& popup, const SoftwareVersion& software) {
    constexpr std::uint32_t kPlainPopup = 8;
    const bool hasRequests =
        software >= (software.isCb3() ? SoftwareVersion{3, 12, 0, 0} : SoftwareVersion{5, 6, 0, 0});
    return message(timestampNs, RobotInterface, Popup, [&](ByteWriter& out) {
        if (hasRequests) {
            out.u32(popup.id).u32(kPlainPopup);
        }
        out.flag(popup.warning).flag(popup.error);
        if (hasRequests) {
            out.flag(popup.blocking);
        }
        counted(out, popup.title);
        out.text(bounded(popup.text));
    });
}

}  // namespace tiller::simulator::primary
