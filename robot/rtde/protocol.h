// SPDX-License-Identifier: MIT
#pragma once

// The words of RTDE (Real-Time Data Exchange, TCP port 30004): package types, data types, versions and
// limits. Nothing here does anything; client and simulated controller share it. Source: RTDE guide.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "robot/core/text.h"

namespace tiller::rtde {

using tiller::operator<<;  // for the enumerations below

using Bytes = std::vector<std::uint8_t>;
using ByteView = std::span<const std::uint8_t>;

inline constexpr std::uint16_t kPort = 30004;

/// Size (2 bytes, itself included) and type (1 byte) in front of every payload.
inline constexpr std::size_t kHeaderSize = 3;
/// What the size field can say.
inline constexpr std::size_t kMaxPackageSize = 65535;
/// Some clients throw larger packages away; a controller should stay at or below.
inline constexpr std::size_t kMaxPortablePackageSize = 4093;
/// Longest comma-separated name list a controller promises to accept in one setup request [bytes].
inline constexpr std::size_t kMaxNameListSize = 2048;

/// A fresh connection speaks V1 until another has been accepted. V3 is V2 with room for more configurable
/// outputs: `configurable_digital_output` and its mask are UINT32. Source: the vendor's Python client.
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

/// The guide's name of a package type, for messages: "RTDE_DATA_PACKAGE"; "unknown" for anything else.
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

/// The spelling in setup replies: "VECTOR6D".
const char* dataTypeName(DataType type);
std::optional<DataType> dataTypeByName(std::string_view name);  ///< "VECTOR6D"

/// Bytes on the wire.
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

/// Numbers in one value: 1, 3 or 6.
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
