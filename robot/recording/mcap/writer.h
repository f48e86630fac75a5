// SPDX-License-Identifier: MIT
#pragma once

// Makes the bytes of an MCAP file, part by part: what is taken is whole records, in order, and belongs at the end of
// the file. Messages go into chunks, compressed by zstd; every chunk is followed by its message indexes, so a file
// that ends behind one is as good as a finished one, but for the summary.

#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "robot/recording/mcap/records.h"

struct ZSTD_CCtx_s;

namespace tiller::recording::mcap {

/// Messages that will lie together. Cheap to fill, empty again after Writer::add().
class ChunkBuilder {
public:
    void add(const Message& message);  ///< Copies its data.

    bool isEmpty() const { return count_ == 0; }          ///< Nothing was added.
    std::size_t size() const { return records_.size(); }  ///< [bytes], uncompressed
    std::uint64_t count() const { return count_; }        ///< Messages in it.

private:
    friend class Writer;
    std::string records_;
    std::map<std::uint16_t, std::string> indexes_;  ///< pairs of log time and offset, as they are written
    std::uint64_t start_ = 0;
    std::uint64_t end_ = 0;
    std::uint64_t count_ = 0;
};

/// Threads  one
class Writer {
public:
    /// profile  "ros2" or empty
    /// library  who writes
    /// level    of zstd; 0: not compressed
    Writer(std::string_view profile, std::string_view library, int level = 1);
    ~Writer();
    Writer(const Writer&) = delete;
    Writer& operator=(const Writer&) = delete;

    /// Returns  its number, the same one for the same content
    std::uint16_t addSchema(std::string_view name, std::string_view encoding, std::string_view data);
    /// The same for a channel.
    std::uint16_t addChannel(std::uint16_t schema, std::string_view topic, std::string_view encoding,
                             const Facts& metadata);
    /// Keys and values under one name.
    void addMetadata(std::string_view name, const Facts& facts);
    /// A file inside the file. time  when it was as it is [ns since 1970]
    void addAttachment(std::string_view name, std::string_view mediaType, std::string_view data,
                       std::uint64_t time);
    /// Closes a chunk; nothing happens when it is empty.
    void add(ChunkBuilder& chunk);
    /// Writes the summary and the end. Nothing can be added afterwards.
    void finish();

    /// Everything since it was last taken.
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
