// SPDX-License-Identifier: MIT
#pragma once

// Numbers in network byte order. The bytes are accessed individually; compilers merge them into one load or
// store.

#include <bit>
#include <cstdint>

namespace tiller::rtde::big_endian {

inline std::uint16_t read16(const std::uint8_t* p) {
    return static_cast<std::uint16_t>((p[0] << 8) | p[1]);
}

inline std::uint32_t read32(const std::uint8_t* p) {
    return (std::uint32_t{p[0]} << 24) | (std::uint32_t{p[1]} << 16) | (std::uint32_t{p[2]} << 8) |
           std::uint32_t{p[3]};
}

inline std::uint64_t read64(const std::uint8_t* p) {
    return (std::uint64_t{read32(p)} << 32) | read32(p + 4);
}

inline double readDouble(const std::uint8_t* p) {
    return std::bit_cast<double>(read64(p));
}

inline void write16(std::uint8_t* p, std::uint16_t v) {
    p[0] = static_cast<std::uint8_t>(v >> 8);
    p[1] = static_cast<std::uint8_t>(v & 0xFF);
}

inline void write32(std::uint8_t* p, std::uint32_t v) {
    p[0] = static_cast<std::uint8_t>(v >> 24);
    p[1] = static_cast<std::uint8_t>((v >> 16) & 0xFF);
    p[2] = static_cast<std::uint8_t>((v >> 8) & 0xFF);
    p[3] = static_cast<std::uint8_t>(v & 0xFF);
}

inline void write64(std::uint8_t* p, std::uint64_t v) {
    write32(p, static_cast<std::uint32_t>(v >> 32));
    write32(p + 4, static_cast<std::uint32_t>(v & 0xFFFFFFFFU));
}

inline void writeDouble(std::uint8_t* p, double v) {
    write64(p, std::bit_cast<std::uint64_t>(v));
}

}  // namespace tiller::rtde::big_endian
