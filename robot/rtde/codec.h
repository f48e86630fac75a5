// SPDX-License-Identifier: MIT
#pragma once

// The packages of the handshake and text messages, to bytes and back, for both ends of an RTDE connection and
// both protocol versions. splitter.h cuts a stream into packages, values.h reads and writes data packages. No
// socket, no state. Reading never trusts a length. Source: RTDE guide; everything is big-endian.

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
// -----------------------------------------------------------------------------------------

struct TextMessage {
    TextLevel level = TextLevel::Info;
    std::string message;  ///< at most 255 bytes on the wire, cut if longer
    std::string source;   ///< likewise; not carried from controller to client in version 1

    friend bool operator==(const TextMessage&, const TextMessage&) = default;
};

// ---- setup
// -------------------------------------------------------------------------------------------------

/// What a controller says about one requested field.
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
    double frequency = 0;  ///< [Hz]; 0 in version 1, which does not carry one
    std::vector<std::string> names;
};

struct SetupReply {
    std::uint8_t recipeId = 0;  ///< 0: invalid; version 1 outputs carry none and read as 1 (0 if a field is
                                ///< missing)
    std::vector<FieldAnswer> fields;
};

/// Splits at commas; an empty last element (some clients end the list with a comma) is not a field.
std::vector<std::string> splitNames(std::string_view list);
std::string joinNames(std::span<const std::string> names);  ///< With commas.

// ---- packages a client writes
// ----------------------------------------------------------------------------------------

// All append to `out`.

void writeProtocolRequest(Bytes& out, std::uint16_t version);  ///< Type 86.
void writeVersionRequest(Bytes& out);                          ///< Type 118.
/// Type 79. frequency  [Hz], version 2 only
void writeSetupOutputsRequest(Bytes& out, ProtocolVersion version, double frequency,
                              std::span<const std::string> names);
void writeSetupInputsRequest(Bytes& out, std::span<const std::string> names);  ///< Type 73.
void writeStartRequest(Bytes& out);                                            ///< Type 83.
void writePauseRequest(Bytes& out);                                            ///< Type 80.
/// The same in both versions.
void writeClientText(Bytes& out, const TextMessage& text);

// ---- packages a controller writes
// --------------------------------------------------------------------------

void writeProtocolReply(Bytes& out, bool accepted);                  ///< Type 86.
void writeVersionReply(Bytes& out, const SoftwareVersion& version);  ///< Type 118.
/// Type 79.
void writeSetupOutputsReply(Bytes& out, ProtocolVersion version, std::uint8_t recipeId,
                            std::span<const FieldAnswer> fields);
/// Type 73.
void writeSetupInputsReply(Bytes& out, std::uint8_t recipeId, std::span<const FieldAnswer> fields);
void writeStartReply(Bytes& out, bool accepted);                                         ///< Type 83.
void writePauseReply(Bytes& out, bool accepted);                                         ///< Type 80.
void writeControllerText(Bytes& out, ProtocolVersion version, const TextMessage& text);  ///< Type 77.
/// types  as in setup replies, one a property; values  packed behind each other, none when one has no type
void writeReadPropertiesReply(Bytes& out, std::string_view types, ByteView values);

// ---- payloads a controller reads
// -----------------------------------------------------------------------------

// Errors of all readers: ProtocolError with the package's name and what is wrong with it.

Result<std::uint16_t> readProtocolRequest(ByteView payload);  ///< The version asked for.
/// Frequency and names.
Result<SetupOutputsRequest> readSetupOutputsRequest(ByteView payload, ProtocolVersion version);
Result<std::vector<std::string>> readSetupInputsRequest(ByteView payload);  ///< The names.
Result<TextMessage> readClientText(ByteView payload);                       ///< Type 77.
std::vector<std::string> readPropertiesRequest(ByteView payload);           ///< The names.

// ---- payloads a client reads
// -------------------------------------------------------------------------------

/// The one-byte answer of protocol, start and pause requests. type: only for the message.
Result<bool> readAccepted(ByteView payload, PackageType type);
Result<SoftwareVersion> readVersionReply(ByteView payload);                           ///< Type 118.
Result<SetupReply> readSetupOutputsReply(ByteView payload, ProtocolVersion version);  ///< Type 79.
Result<SetupReply> readSetupInputsReply(ByteView payload);                            ///< Type 73.
Result<TextMessage> readControllerText(ByteView payload, ProtocolVersion version);    ///< Type 77.

}  // namespace tiller::rtde
