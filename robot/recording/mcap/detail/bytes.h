// SPDX-License-Identifier: MIT
#pragma once

// Writes little-endian numbers and length-prefixed strings to a byte string, and reads them with bounds
// checks. Private to robot/recording/mcap.

#include <bit>
#include <concepts>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

#include "robot/recording/mcap/records.h"

namespace tiller::recording::mcap {

static_assert(std::endian::native == std::endian::little, "numbers are copied as they lie in memory");

template <std::unsigned_integral T>
void put(std::string& out, T value) {
    char bytes[sizeof value];
    std::memcpy(bytes, &value, sizeof value);
    out.append(bytes, sizeof value);
}
inline void putText(std::string& out, std::string_view text) {
    put(out, static_cast<std::uint32_t>(text.size()));
    out.append(text);
}
inline void putFacts(std::string& out, const Facts& facts) {
    std::string entries;
    for (const auto& [key, value] : facts) {
        putText(entries, key);
        putText(entries, value);
    }
    putText(out, entries);
}
inline void putRecord(std::string& out, Opcode opcode, std::string_view content) {
    out.push_back(static_cast<char>(opcode));
    put(out, static_cast<std::uint64_t>(content.size()));
    out.append(content);
}

/// Reads values sequentially. Missing data are returned as 0 or empty, and `ok` becomes false.
class ByteReader {
public:
    explicit ByteReader(std::string_view bytes) : rest_(bytes) {}

    bool ok() const { return ok_; }
    bool atEnd() const { return rest_.empty(); }
    std::size_t left() const { return rest_.size(); }
    std::string_view bytes(std::uint64_t count) {
        if (!ok_ || count > rest_.size()) {
            ok_ = false;
            return {};
        }
        const std::string_view taken = rest_.substr(0, static_cast<std::size_t>(count));
        rest_.remove_prefix(taken.size());
        return taken;
    }
    template <std::unsigned_integral T>
    T number() {
        T value = 0;
        if (const std::string_view taken = bytes(sizeof value); ok_) {
            std::memcpy(&value, taken.data(), sizeof value);
        }
        return value;
    }
    std::string_view text() { return bytes(number<std::uint32_t>()); }
    Facts facts() {
        Facts facts;
        ByteReader entries(text());
        while (entries.ok() && !entries.atEnd()) {
            const std::string_view key = entries.text();
            const std::string_view value = entries.text();
            if (entries.ok()) {
                facts[std::string(key)] = std::string(value);
            }
        }
        ok_ = ok_ && entries.ok();
        return facts;
    }

private:
    std::string_view rest_;
    bool ok_ = true;
};

}  // namespace tiller::recording::mcap
