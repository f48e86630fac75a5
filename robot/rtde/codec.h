// SPDX-License-Identifier: MIT
#pragma once

// Encodes and decodes the packages of the handshake and the text messages, for both ends of an RTDE
// connection and both protocol versions. splitter.h splits a stream into packages; values.h reads and writes
// data packages. The functions perform no I/O, keep no state, and validate every length they read. All
// numbers are big-endian. Source: RTDE guide.

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "robot/core/result.h"
#include "robot/core/version.h"
#include "robot/rtde/protocol.h"

namespace tiller::rtde {

// ---- text messages

struct TextMessage {
    TextLevel level = TextLevel::Info;
    std::string message;  ///< truncated to 255 bytes on the wire
    std::string source;   ///< truncated to 255 bytes; not sent from controller to client in version 1

    friend bool operator==(const TextMessage&, const TextMessage&) = default;
};

// ---- setup

/// The controller's reply for one requested field.
struct FieldAnswer {
    enum class Kind : std::uint8_t { Type, NotFound, InUse };
    Kind kind = Kind::Type;
    DataType type = DataType::Double;  ///< for Kind::Type

    static FieldAnswer of(DataType t) { return {Kind::Type, t}; }                 ///< The field exists.
    static FieldAnswer notFound() { return {Kind::NotFound, DataType::Double}; }  ///< NOT_FOUND
    static FieldAnswer inUse() { return {Kind::InUse, DataType::Double}; }        ///< IN_USE
    friend bool operator==(const FieldAnswer&, const FieldAnswer&) = default;
};

struct SetupOutputsRequest {
    double frequency = 0;  ///< [Hz]; 0 in version 1, which does not transmit it
    std::vector<std::string> names;
};

struct SetupReply {
    /// 0: invalid. Outputs of version 1 contain no id; their id is set to 1 (0 if a field is missing).
    std::uint8_t recipeId = 0;
    std::vector<FieldAnswer> fields;
};

/// Splits at commas. An empty last element (some clients end the list with a comma) is ignored.
std::vector<std::string> splitNames(std::string_view list);
std::string joinNames(std::span<const std::string> names);  ///< Joins the names with commas.

// ---- packages a client writes

// All functions append to `out`.

void writeProtocolRequest(Bytes& out, std::uint16_t version);  ///< Package type 86.
void writeVersionRequest(Bytes& out);                          ///< Package type 118.
/// Package type 79.
/// frequency  [Hz], version 2 only
void writeSetupOutputsRequest(Bytes& out, ProtocolVersion version, double frequency,
                              std::span<const std::string> names);
void writeSetupInputsRequest(Bytes& out, std::span<const std::string> names);  ///< Package type 73.
void writeStartRequest(Bytes& out);                                            ///< Package type 83.
void writePauseRequest(Bytes& out);                                            ///< Package type 80.
/// Package type 77, identical in both versions.
void writeClientText(Bytes& out, const TextMessage& text);

// ---- packages a controller writes

void writeProtocolReply(Bytes& out, bool accepted);                  ///< Package type 86.
void writeVersionReply(Bytes& out, const SoftwareVersion& version);  ///< Package type 118.
/// Package type 79.
void writeSetupOutputsReply(Bytes& out, ProtocolVersion version, std::uint8_t recipeId,
                            std::span<const FieldAnswer> fields);
/// Package type 73.
void writeSetupInputsReply(Bytes& out, std::uint8_t recipeId, std::span<const FieldAnswer> fields);
void writeStartReply(Bytes& out, bool accepted);                                         ///< Package type 83.
void writePauseReply(Bytes& out, bool accepted);                                         ///< Package type 80.
void writeControllerText(Bytes& out, ProtocolVersion version, const TextMessage& text);  ///< Package type 77.
/// types   as in setup replies, one entry per property
/// values  packed without padding; empty if any property has no type
void writeReadPropertiesReply(Bytes& out, std::string_view types, ByteView values);

// ---- payloads a controller reads

// Errors of all readers: ProtocolError with the name of the package and the reason.

Result<std::uint16_t> readProtocolRequest(ByteView payload);  ///< Returns  the requested protocol version
/// Returns  the requested frequency and field names
Result<SetupOutputsRequest> readSetupOutputsRequest(ByteView payload, ProtocolVersion version);
/// Returns  the requested field names
Result<std::vector<std::string>> readSetupInputsRequest(ByteView payload);
Result<TextMessage> readClientText(ByteView payload);  ///< Package type 77.
/// Returns  the names of the requested properties
std::vector<std::string> readPropertiesRequest(ByteView payload);

// ---- payloads a client reads

/// Reads the one-byte reply to protocol, start and pause requests.
/// type  only used in the error message
Result<bool> readAccepted(ByteView payload, PackageType type);
Result<SoftwareVersion> readVersionReply(ByteView payload);                           ///< Package type 118.
Result<SetupReply> readSetupOutputsReply(ByteView payload, ProtocolVersion version);  ///< Package type 79.
Result<SetupReply> readSetupInputsReply(ByteView payload);                            ///< Package type 73.
Result<TextMessage> readControllerText(ByteView payload, ProtocolVersion version);    ///< Package type 77.

}  // namespace tiller::rtde
