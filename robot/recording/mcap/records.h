// SPDX-License-Identifier: MIT
#pragma once

// The records of an MCAP file that this library uses, with the names of the specification. Source:
// mcap.dev/spec

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace tiller::recording::mcap {

inline constexpr std::string_view kMagic{"\x89MCAP0\r\n", 8};
/// Opcode (1 byte) and length of the content (8 bytes) before every record.
inline constexpr std::size_t kRecordHead = 9;

enum class Opcode : std::uint8_t {
    Header = 0x01,
    Footer = 0x02,
    Schema = 0x03,
    Channel = 0x04,
    Message = 0x05,
    Chunk = 0x06,
    MessageIndex = 0x07,
    ChunkIndex = 0x08,
    Attachment = 0x09,
    AttachmentIndex = 0x0A,
    Statistics = 0x0B,
    Metadata = 0x0C,
    MetadataIndex = 0x0D,
    SummaryOffset = 0x0E,
    DataEnd = 0x0F,
};

using Facts = std::map<std::string, std::string>;

struct Schema {
    std::uint16_t id = 0;  ///< 0: no schema
    std::string name{};
    std::string encoding{};
    std::string data{};
};

struct Channel {
    std::uint16_t id = 0;
    std::uint16_t schema = 0;
    std::string topic{};
    std::string encoding{};
    Facts metadata{};
};

/// Nanoseconds since 1970 (UTC), as for all times below.
struct Message {
    std::uint16_t channel = 0;
    std::uint32_t sequence = 0;
    std::uint64_t logTime = 0;
    std::uint64_t publishTime = 0;
    std::string_view data{};
};

struct ChunkIndex {
    std::uint64_t startTime = 0;  ///< minimum and maximum log time
    std::uint64_t endTime = 0;
    std::uint64_t offset = 0;  ///< offset of the chunk record in the file
    std::uint64_t length = 0;  ///< length of the whole record
    /// Channels and the offsets of their index records. A vector instead of a map, because a recording of
    /// several hours has a hundred thousand chunks.
    std::vector<std::pair<std::uint16_t, std::uint64_t>> messageIndexes{};
    std::uint64_t messageIndexLength = 0;  ///< total length of the index records
    std::string compression{};
    std::uint64_t compressedSize = 0;
    std::uint64_t uncompressedSize = 0;
};

struct AttachmentIndex {
    std::uint64_t offset = 0;
    std::uint64_t length = 0;
    std::uint64_t logTime = 0;
    std::uint64_t createTime = 0;
    std::uint64_t dataSize = 0;
    std::string name{};
    std::string mediaType{};
};

struct MetadataIndex {
    std::uint64_t offset = 0;
    std::uint64_t length = 0;
    std::string name{};
};

}  // namespace tiller::recording::mcap
