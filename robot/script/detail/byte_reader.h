// SPDX-License-Identifier: MIT
#pragma once

// Reads big-endian values from a package that may be truncated or contain invalid lengths. Reading past the end
// returns zeros and sets an error flag, which the caller checks once at the end.

#include <QString>
#include <bit>
#include <concepts>
#include <cstdint>
#include <span>

namespace tiller::script {

class ByteReader {
public:
    explicit ByteReader(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

    bool ok() const { return ok_; }
    std::size_t remaining() const { return bytes_.size(); }

    std::uint8_t u8() { return integer<std::uint8_t>(); }
    bool boolean() { return u8() != 0; }
    std::int8_t i8() { return static_cast<std::int8_t>(u8()); }
    std::uint32_t u32() { return integer<std::uint32_t>(); }
    std::int32_t i32() { return static_cast<std::int32_t>(u32()); }
    std::uint64_t u64() { return integer<std::uint64_t>(); }
    float f32() { return std::bit_cast<float>(u32()); }
    double f64() { return std::bit_cast<double>(u64()); }

    std::span<const std::uint8_t> take(std::size_t count) {
        if (count > bytes_.size()) {
            ok_ = false;
            bytes_ = {};
            return {};
        }
        const auto taken = bytes_.first(count);
        bytes_ = bytes_.subspan(count);
        return taken;
    }
    void skip(std::size_t count) { take(count); }
    QString text(std::size_t length) {
        const auto taken = take(length);
        return QString::fromUtf8(reinterpret_cast<const char*>(taken.data()),
                                 static_cast<qsizetype>(taken.size()));
    }
    QString rest() { return text(bytes_.size()); }

private:
    template <std::unsigned_integral T>
    T integer() {
        T value = 0;
        for (const std::uint8_t byte : take(sizeof(T))) {
            value = static_cast<T>((static_cast<std::uint64_t>(value) << 8) | byte);
        }
        return value;
    }

    std::span<const std::uint8_t> bytes_;
    bool ok_ = true;
};

}  // namespace tiller::script
