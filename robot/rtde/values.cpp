// SPDX-License-Identifier: MIT
#include "robot/rtde/values.h"

// Encodes and decodes data packages, 500 times per second.
#include <cmath>
#include <limits>

namespace tiller::rtde {

namespace {

/// Rounds and clamps to the range of an integer type. NaN becomes 0.
template <class Integer>
Integer toInteger(double value) {
    if (std::isnan(value)) {
        return 0;
    }
    const double rounded = std::nearbyint(value);
    // The upper bound is exact as a double for 8 and 32 bits. For 64 bits it is rounded up to 2^64, so the
    // comparison is >=.
    if (rounded >= static_cast<double>(std::numeric_limits<Integer>::max())) {
        return std::numeric_limits<Integer>::max();
    }
    if (rounded <= static_cast<double>(std::numeric_limits<Integer>::min())) {
        return std::numeric_limits<Integer>::min();
    }
    return static_cast<Integer>(rounded);
}

}  // namespace

ValueLayout::ValueLayout(std::vector<DataType> types) : types_(std::move(types)) {
    for (const DataType type : types_) {
        wireBytes_ += wireSize(type);
        components_ += componentCount(type);
    }
}

bool decodeValues(const ValueLayout& layout, ByteView wire, std::span<double> into) {
    return into.size() >= layout.components() &&
           decodeEach(layout, wire, [out = into.data()](std::size_t i, double value) { out[i] = value; });
}

bool encodeValues(const ValueLayout& layout, std::span<const double> values, std::span<std::uint8_t> wire) {
    if (wire.size() != layout.wireBytes() || values.size() < layout.components()) {
        return false;
    }
    const double* in = values.data();
    std::uint8_t* out = wire.data();
    for (const DataType type : layout.types()) {
        switch (type) {
            case DataType::Bool:
                *out++ = *in++ != 0.0 ? 1 : 0;
                break;
            case DataType::UInt8:
                *out++ = toInteger<std::uint8_t>(*in++);
                break;
            case DataType::UInt64:
                big_endian::write64(out, toInteger<std::uint64_t>(*in++));
                out += 8;
                break;
            case DataType::UInt32:
            case DataType::Vector6UInt32:
                for (std::size_t n = componentCount(type); n > 0; --n, out += 4) {
                    big_endian::write32(out, toInteger<std::uint32_t>(*in++));
                }
                break;
            case DataType::Int32:
            case DataType::Vector6Int32:
                for (std::size_t n = componentCount(type); n > 0; --n, out += 4) {
                    big_endian::write32(out, static_cast<std::uint32_t>(toInteger<std::int32_t>(*in++)));
                }
                break;
            case DataType::Double:
            case DataType::Vector3D:
            case DataType::Vector6D:
                for (std::size_t n = componentCount(type); n > 0; --n, out += 8) {
                    big_endian::writeDouble(out, *in++);
                }
                break;
        }
    }
    return true;
}

std::size_t writeDataPackage(std::span<std::uint8_t> into, std::optional<std::uint8_t> recipeId,
                             const ValueLayout& layout, std::span<const double> values) {
    const std::size_t size = dataPackageSize(layout.wireBytes(), recipeId.has_value());
    if (size > into.size() || size > kMaxPackageSize) {
        return 0;
    }
    big_endian::write16(into.data(), static_cast<std::uint16_t>(size));
    into[2] = static_cast<std::uint8_t>(PackageType::Data);
    std::size_t at = kHeaderSize;
    if (recipeId) {
        into[at++] = *recipeId;
    }
    return encodeValues(layout, values, into.subspan(at, layout.wireBytes())) ? size : 0;
}

std::optional<DataView> readOutputData(ByteView payload, ProtocolVersion version) {
    if (version == ProtocolVersion::V1) {
        return DataView{0, payload};
    }
    return readInputData(payload);
}

std::optional<DataView> readInputData(ByteView payload) {
    if (payload.empty()) {
        return std::nullopt;
    }
    return DataView{payload[0], payload.subspan(1)};
}

}  // namespace tiller::rtde
