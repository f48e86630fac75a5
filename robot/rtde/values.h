// SPDX-License-Identifier: MIT
#pragma once

// Converts the values of a data package from and to wire format without allocating. All numbers are big-endian.
// Source: RTDE guide.

#include <optional>
#include <span>
#include <vector>

#include "robot/rtde/big_endian.h"
#include "robot/rtde/protocol.h"

namespace tiller::rtde {

/// The types of a recipe in order, with the totals required by the codec.
class ValueLayout {
public:
    ValueLayout() = default;
    explicit ValueLayout(std::vector<DataType> types);

    const std::vector<DataType>& types() const { return types_; }  ///< Types in the order of the package.
    std::size_t wireBytes() const { return wireBytes_; }           ///< size without recipe id [bytes]
    std::size_t components() const { return components_; }         ///< numbers in one package

private:
    std::vector<DataType> types_;
    std::size_t wireBytes_ = 0;
    std::size_t components_ = 0;
};

/// Values are doubles: BOOL is 0 or 1, all 32-bit integers are exact, UINT64 is exact up to 2^53 (bit fields
/// and counters stay far below).
/// Returns  false, without writing anything, if the sizes do not match the layout
/// Real-time: yes
bool decodeValues(const ValueLayout& layout, ByteView wire, std::span<double> into);
/// Like decodeValues(), with a callback for each number: sink(index, value), in the order of the package.
template <class Sink>
bool decodeEach(const ValueLayout& layout, ByteView wire, Sink sink) {
    if (wire.size() != layout.wireBytes()) {
        return false;
    }
    const std::uint8_t* in = wire.data();
    std::size_t index = 0;
    for (const DataType type : layout.types()) {
        switch (type) {
            case DataType::Bool:
                sink(index++, *in++ != 0 ? 1.0 : 0.0);
                break;
            case DataType::UInt8:
                sink(index++, static_cast<double>(*in++));
                break;
            case DataType::UInt64:
                sink(index++, static_cast<double>(big_endian::read64(in)));
                in += 8;
                break;
            case DataType::UInt32:
            case DataType::Vector6UInt32:
                for (std::size_t n = componentCount(type); n > 0; --n, in += 4) {
                    sink(index++, static_cast<double>(big_endian::read32(in)));
                }
                break;
            case DataType::Int32:
            case DataType::Vector6Int32:
                for (std::size_t n = componentCount(type); n > 0; --n, in += 4) {
                    sink(index++, static_cast<double>(static_cast<std::int32_t>(big_endian::read32(in))));
                }
                break;
            case DataType::Double:
            case DataType::Vector3D:
            case DataType::Vector6D:
                for (std::size_t n = componentCount(type); n > 0; --n, in += 8) {
                    sink(index++, big_endian::readDouble(in));
                }
                break;
        }
    }
    return true;
}
/// Integers are rounded and clamped to the range of their type; NaN becomes 0.
bool encodeValues(const ValueLayout& layout, std::span<const double> values, std::span<std::uint8_t> wire);

/// Size of a complete data package including the header and, if present, the recipe id [bytes].
constexpr std::size_t dataPackageSize(std::size_t wireBytes, bool withRecipeId) {
    return kHeaderSize + (withRecipeId ? 1 : 0) + wireBytes;
}
/// Writes a complete data package.
/// recipeId  absent only for outputs in protocol version 1
/// Returns   the number of bytes written; 0 if the sizes do not match or `into` is too small
/// Real-time: yes
std::size_t writeDataPackage(std::span<std::uint8_t> into, std::optional<std::uint8_t> recipeId,
                             const ValueLayout& layout, std::span<const double> values);

/// The parts of a data package's payload.
struct DataView {
    std::uint8_t recipeId = 0;  ///< 0 for outputs in protocol version 1, which contain no id
    ByteView values;
};
/// Reads a package sent by the controller.
std::optional<DataView> readOutputData(ByteView payload, ProtocolVersion version);
/// Reads a package sent by a client. Both protocol versions contain the recipe id.
std::optional<DataView> readInputData(ByteView payload);

}  // namespace tiller::rtde
