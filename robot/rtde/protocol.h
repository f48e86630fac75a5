// SPDX-License-Identifier: MIT
#pragma once

// Constants of RTDE (Real-Time Data Exchange, TCP port 30004): package types, data types, versions and limits,
// shared by the client and the simulated controller. Source: RTDE guide.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "robot/core/text.h"

namespace tiller::rtde {

using tiller::operator<<;  // makes the enumerations below printable

using Bytes = std::vector<std::uint8_t>;
using ByteView = std::span<const std::uint8_t>;

inline constexpr std::uint16_t kPort = 30004;

/// Size of the header that precedes every payload: package size (2 bytes, header included) and type (1 byte).
inline constexpr std::size_t kHeaderSize = 3;
/// Largest value of the size field [bytes].
inline constexpr std::size_t kMaxPackageSize = 65535;
/// Some clients discard larger packages; a controller should not exceed this size [bytes].
inline constexpr std::size_t kMaxPortablePackageSize = 4093;
/// Longest comma-separated name list that every controller accepts in one setup request [bytes].
inline constexpr std::size_t kMaxNameListSize = 2048;

/// A new connection uses V1 until another version has been accepted. V3 equals V2, except that
/// `configurable_digital_output` and its mask are UINT32. Source: the vendor's Python client.
enum class ProtocolVersion : std::uint16_t { V1 = 1, V2 = 2, V3 = 3 };

enum class PackageType : std::uint8_t {
    RequestProtocolVersion = 'V',
    GetUrControlVersion = 'v',
    TextMessage = 'M',
    Data = 'U',
    SetupOutputs = 'O',
    SetupInputs = 'I',
    Start = 'S',
    Pause = 'P',
    ReadProperties = 'R',  ///< since 5.26 and 10.15
};

/// Name of a package type as in the RTDE guide, e.g. "RTDE_DATA_PACKAGE"; "unknown" for other values.
const char* packageTypeName(PackageType type);

enum class TextLevel : std::uint8_t { Exception = 0, Error = 1, Warning = 2, Info = 3 };

enum class DataType : std::uint8_t {
    Bool,
    UInt8,
    UInt32,
    UInt64,
    Int32,
    Double,
    Vector3D,
    Vector6D,
    Vector6Int32,
    Vector6UInt32,
};

/// Spelling of a data type in setup replies, e.g. "VECTOR6D".
const char* dataTypeName(DataType type);
std::optional<DataType> dataTypeByName(std::string_view name);  ///< The inverse of dataTypeName().

/// Size of one value on the wire [bytes].
constexpr std::size_t wireSize(DataType type) {
    switch (type) {
        case DataType::Bool:
        case DataType::UInt8:
            return 1;
        case DataType::UInt32:
        case DataType::Int32:
            return 4;
        case DataType::UInt64:
        case DataType::Double:
            return 8;
        case DataType::Vector3D:
        case DataType::Vector6Int32:
        case DataType::Vector6UInt32:
            return 24;
        case DataType::Vector6D:
            return 48;
    }
    return 0;
}

/// Numbers in one value of the type: 1, 3 or 6.
constexpr std::size_t componentCount(DataType type) {
    switch (type) {
        case DataType::Vector3D:
            return 3;
        case DataType::Vector6D:
        case DataType::Vector6Int32:
        case DataType::Vector6UInt32:
            return 6;
        default:
            return 1;
    }
}

}  // namespace tiller::rtde
