// SPDX-License-Identifier: MIT
#pragma once

// Appends numbers in network byte order to a buffer, for the packages of the primary, secondary and realtime
// interfaces.

#include <bit>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace tiller::simulator {

class ByteWriter {
public:
    explicit ByteWriter(std::vector<std::uint8_t>& into) : out_(into) {}

    ByteWriter& u8(unsigned value) {
        out_.push_back(static_cast<std::uint8_t>(value & 0xFFU));
        return *this;
    }
    ByteWriter& flag(bool value) { return u8(value ? 1 : 0); }
    ByteWriter& u16(unsigned value) { return u8(value >> 8).u8(value); }
    ByteWriter& u32(std::uint32_t value) { return u8(value >> 24).u8(value >> 16).u8(value >> 8).u8(value); }
    ByteWriter& i32(std::int32_t value) { return u32(static_cast<std::uint32_t>(value)); }
    ByteWriter& u64(std::uint64_t value) {
        return u32(static_cast<std::uint32_t>(value >> 32)).u32(static_cast<std::uint32_t>(value));
    }
    ByteWriter& f32(double value) { return u32(std::bit_cast<std::uint32_t>(static_cast<float>(value))); }
    ByteWriter& f64(double value) { return u64(std::bit_cast<std::uint64_t>(value)); }
    template <class Numbers>
    ByteWriter& f64s(const Numbers& numbers) {
        for (const double value : numbers) {
            f64(value);
        }
        return *this;
    }
    ByteWriter& text(std::string_view value) {
        out_.insert(out_.end(), value.begin(), value.end());
        return *this;
    }

    /// Reserves a length field of four bytes, which closeLength() fills in. The length includes the field
    /// itself.
    std::size_t openLength() {
        const std::size_t at = out_.size();
        u32(0);
        return at;
    }
    void closeLength(std::size_t at) {
        const auto size = static_cast<std::uint32_t>(out_.size() - at);
        for (std::size_t i = 0; i < 4; ++i) {
            out_[at + i] = static_cast<std::uint8_t>((size >> (24 - 8 * i)) & 0xFFU);
        }
    }

private:
    std::vector<std::uint8_t>& out_;
};

}  // namespace tiller::simulator
