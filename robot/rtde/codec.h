// SPDX-License-Identifier: MIT
#pragma once

// Bytes to packages and back, for both ends of an RTDE connection and both protocol versions. No socket, no
// state besides the splitter's buffer. Reading never trusts a length; data packages are read and written
// without allocating. Source: RTDE guide; everything is big-endian.

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "robot/core/result.h"
#include "robot/core/version.h"
#include "robot/rtde/protocol.h"

namespace tiller::rtde {

using Bytes = std::vector<std::uint8_t>;
using ByteView = std::span<const std::uint8_t>;

/// One complete package; the payload points into the splitter's buffer.
struct PackageView {
    PackageType type{};
    ByteView payload;
};

/// Cuts a byte stream into packages, however it was segmented.
/// Threads  one at a time. Real-time: yes (its buffer is allocated once, at construction)
class PackageSplitter {
public:
    enum class Fault {
        None,
        TooSmall,  ///< a size field below 3
        TooLarge,  ///< a size field above the limit
    };

    /// limit  the largest package accepted [bytes, header included]
    explicit PackageSplitter(std::size_t limit = kMaxPackageSize);

    /// Room to receive into, never empty while there is no fault and packages are taken; then say how much
    /// came with commit(). Invalidates views handed out before.
    std::span<std::uint8_t> writable();
    void commit(std::size_t bytes);

    /// Copies bytes in. Invalidates views handed out before.
    /// Returns  how many were taken: less than offered when packages have to be taken out first, or after a
    ///          fault
    std::size_t feed(ByteView bytes);

    /// The next complete package, if there is one. Its view lives until the next writable() or feed().
    std::optional<PackageView> next();
    /// True when next() would return a package.
    bool hasNext() const;

    /// After a fault the stream cannot be understood any more: nothing comes out until reset().
    Fault fault() const { return fault_; }
    /// ProtocolError naming the size field that was wrong; code None when there is no fault.
    Error error() const;
    void reset();

private:
    std::size_t nextSize() const;
    void compact();

    std::size_t limit_;
    Bytes buffer_;
    std::size_t begin_ = 0;
    std::size_t end_ = 0;
    Fault fault_ = Fault::None;
    std::size_t faultSize_ = 0;
};

// ---- values
// ------------------------------------------------------------------------------------------------

/// The types of one recipe in order, with the sums a codec needs.
class ValueLayout {
public:
    ValueLayout() = default;
    explicit ValueLayout(std::vector<DataType> types);

    const std::vector<DataType>& types() const { return types_; }
    std::size_t wireBytes() const { return wireBytes_; }    ///< packed, without recipe id
    std::size_t components() const { return components_; }  ///< numbers in one set of values

private:
    std::vector<DataType> types_;
    std::size_t wireBytes_ = 0;
    std::size_t components_ = 0;
};

/// Values travel as doubles: BOOL is 0 or 1, every 32-bit integer is exact, UINT64 is exact up to 2^53 (bit
/// fields and counters stay far below).
/// Returns  false, and touches nothing, when the sizes do not fit the layout
/// Real-time: yes
bool decodeValues(const ValueLayout& layout, ByteView wire, std::span<double> into);
/// Integers are rounded and held to their type's range; a NaN becomes 0.
bool encodeValues(const ValueLayout& layout, std::span<const double> values, std::span<std::uint8_t> wire);

/// Size of a whole data package with header and, if it has one, recipe id.
constexpr std::size_t dataPackageSize(std::size_t wireBytes, bool withRecipeId) {
    return kHeaderSize + (withRecipeId ? 1 : 0) + wireBytes;
}
/// Writes a whole data package. recipeId: absent only for outputs in protocol version 1.
/// Returns  bytes written; 0 when it does not fit or the sizes do not match
/// Real-time: yes
std::size_t writeDataPackage(std::span<std::uint8_t> into, std::optional<std::uint8_t> recipeId,
                             const ValueLayout& layout, std::span<const double> values);

/// A data package's payload taken apart.
struct DataView {
    std::uint8_t recipeId = 0;  ///< 0 for outputs in protocol version 1, which carry none
    ByteView values;
};
/// Controller to client.
std::optional<DataView> readOutputData(ByteView payload, ProtocolVersion version);
/// Client to controller: both versions carry the recipe id.
std::optional<DataView> readInputData(ByteView payload);

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

    static FieldAnswer of(DataType t) { return {Kind::Type, t}; }
    static FieldAnswer notFound() { return {Kind::NotFound, DataType::Double}; }
    static FieldAnswer inUse() { return {Kind::InUse, DataType::Double}; }
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
std::string joinNames(std::span<const std::string> names);

// ---- packages a client writes
// ------------------------------------------------------------------------------ All append to `out`.

void writeProtocolRequest(Bytes& out, std::uint16_t version);
void writeVersionRequest(Bytes& out);
void writeSetupOutputsRequest(Bytes& out, ProtocolVersion version, double frequency,
                              std::span<const std::string> names);
void writeSetupInputsRequest(Bytes& out, std::span<const std::string> names);
void writeStartRequest(Bytes& out);
void writePauseRequest(Bytes& out);
/// The same in both versions.
void writeClientText(Bytes& out, const TextMessage& text);

// ---- packages a controller writes
// --------------------------------------------------------------------------

void writeProtocolReply(Bytes& out, bool accepted);
void writeVersionReply(Bytes& out, const SoftwareVersion& version);
void writeSetupOutputsReply(Bytes& out, ProtocolVersion version, std::uint8_t recipeId,
                            std::span<const FieldAnswer> fields);
void writeSetupInputsReply(Bytes& out, std::uint8_t recipeId, std::span<const FieldAnswer> fields);
void writeStartReply(Bytes& out, bool accepted);
void writePauseReply(Bytes& out, bool accepted);
void writeControllerText(Bytes& out, ProtocolVersion version, const TextMessage& text);
/// types  as in setup replies, one a property; values  packed behind each other, none when one has no type
void writeReadPropertiesReply(Bytes& out, std::string_view types, ByteView values);

// ---- payloads a controller reads
// --------------------------------------------------------------------------- Errors of all readers:
// ProtocolError with the package's name and what is wrong with it.

Result<std::uint16_t> readProtocolRequest(ByteView payload);
Result<SetupOutputsRequest> readSetupOutputsRequest(ByteView payload, ProtocolVersion version);
Result<std::vector<std::string>> readSetupInputsRequest(ByteView payload);
Result<TextMessage> readClientText(ByteView payload);
std::vector<std::string> readPropertiesRequest(ByteView payload);

// ---- payloads a client reads
// -------------------------------------------------------------------------------

/// The one-byte answer of protocol, start and pause requests. type: only for the message.
Result<bool> readAccepted(ByteView payload, PackageType type);
Result<SoftwareVersion> readVersionReply(ByteView payload);
Result<SetupReply> readSetupOutputsReply(ByteView payload, ProtocolVersion version);
Result<SetupReply> readSetupInputsReply(ByteView payload);
Result<TextMessage> readControllerText(ByteView payload, ProtocolVersion version);

}  // namespace tiller::rtde
