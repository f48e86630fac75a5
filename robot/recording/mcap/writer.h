// SPDX-License-Identifier: MIT
#pragma once

// Generates an MCAP file in parts. Each part consists of complete records and is appended to the file.
// Messages are stored in chunks, compressed with zstd. Message indexes follow every chunk, so a file that
// ends after a chunk lacks only the summary.

#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "robot/recording/mcap/records.h"

struct ZSTD_CCtx_s;

namespace tiller::recording::mcap {

/// Collects the messages of a chunk. Adding messages is cheap. Writer::add() empties the builder.
class ChunkBuilder {
public:
    void add(const Message& message);  ///< Copies the data.

    bool isEmpty() const { return count_ == 0; }
    std::size_t size() const { return records_.size(); }  ///< uncompressed size [bytes]
    std::uint64_t count() const { return count_; }

private:
    friend class Writer;
    std::string records_;
    std::map<std::uint16_t, std::string> indexes_;  ///< pairs of log time and offset, in file format
    std::uint64_t start_ = 0;
    std::uint64_t end_ = 0;
    std::uint64_t count_ = 0;
};

/// Threads  one
class Writer {
public:
    /// profile  "ros2" or empty
    /// library  name of the writer
    /// level    zstd level; 0: uncompressed
    Writer(std::string_view profile, std::string_view library, int level = 1);
    ~Writer();
    Writer(const Writer&) = delete;
    Writer& operator=(const Writer&) = delete;

    /// Returns  the id; the same content always has the same id
    std::uint16_t addSchema(std::string_view name, std::string_view encoding, std::string_view data);
    /// Returns  the id; the same content always has the same id
    std::uint16_t addChannel(std::uint16_t schema, std::string_view topic, std::string_view encoding,
                             const Facts& metadata);
    /// Adds a record of key-value pairs.
    void addMetadata(std::string_view name, const Facts& facts);
    /// Adds an attached file.
    /// time  time of the content [ns since 1970]
    void addAttachment(std::string_view name, std::string_view mediaType, std::string_view data,
                       std::uint64_t time);
    /// Completes a chunk; no effect if it is empty.
    void add(ChunkBuilder& chunk);
    /// Writes the summary and the end of the file. No content can be added after that.
    void finish();

    /// Returns the data since the last call.
    std::string take();

private:
    void record(Opcode opcode, std::string_view content);
    std::uint64_t position() const { return taken_ + out_.size(); }
    void summary();

    std::string out_;
    std::uint64_t taken_ = 0;
    int level_;
    std::unique_ptr<ZSTD_CCtx_s, std::size_t (*)(ZSTD_CCtx_s*)> compressor_;
    std::string compressed_;
    std::vector<Schema> schemas_;
    std::vector<Channel> channels_;
    std::vector<ChunkIndex> chunks_;
    std::vector<AttachmentIndex> attachments_;
    std::vector<MetadataIndex> metadata_;
    std::map<std::uint16_t, std::uint64_t> counts_;
    std::uint64_t start_ = 0;
    std::uint64_t end_ = 0;
};

}  // namespace tiller::recording::mcap
