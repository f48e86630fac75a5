// SPDX-License-Identifier: MIT
#pragma once

// Reads an MCAP file through its summary. If the summary is missing or damaged, scans all complete records.
// All content is validated: damaged parts are skipped and reported.

#include <QFile>
#include <QStringList>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "robot/core/result.h"
#include "robot/core/text.h"
#include "robot/recording/mcap/records.h"

namespace tiller::recording::mcap {

/// Threads  one at a time
class Reader {
public:
    /// Errors   FileNotReadable; FileCorrupt: not an MCAP file
    /// Blocks   reads the summary, or all record headers
    static Result<std::unique_ptr<Reader>> open(const Text& path);

    const QString& path() const { return path_; }
    /// True if both the summary and the end of the file are valid.
    bool isComplete() const { return complete_; }
    const QStringList& problems() const { return problems_; }  ///< One sentence per damaged part.
    const std::string& profile() const { return profile_; }    ///< e.g. "ros2"
    const std::string& library() const { return library_; }    ///< Name of the writer.
    const std::map<std::uint16_t, Schema>& schemas() const { return schemas_; }
    const std::map<std::uint16_t, Channel>& channels() const { return channels_; }
    const std::vector<ChunkIndex>& chunks() const { return chunks_; }                 ///< In file order.
    const std::vector<AttachmentIndex>& attachments() const { return attachments_; }  ///< In file order.
    const std::vector<MetadataIndex>& metadata() const { return metadata_; }          ///< In file order.

    /// Number of messages of a channel according to the message indexes of a chunk; empty without message
    /// indexes.
    std::optional<std::uint64_t> messagesIn(const ChunkIndex& chunk, std::uint16_t channel) const;
    /// The records of a chunk, validated and decompressed.
    Result<std::string> records(const ChunkIndex& chunk) const;
    Result<Facts> facts(const MetadataIndex& metadata) const;  ///< Content of a metadata record.
    /// Content of an attachment, validated.
    Result<std::string> attachment(const AttachmentIndex& attachment) const;

    /// Calls sink for each message in decompressed records, in order.
    /// Returns  false if the data are truncated
    static bool forEachMessage(std::string_view records, const std::function<void(const Message&)>& sink);

private:
    explicit Reader(const Text& path) : path_(path), file_(path) {}
    Result<void> readHeader();
    bool readSummary();
    void takeSummary(Opcode opcode, std::string_view content);
    void scan();
    bool takeChunk(std::uint64_t offset, std::uint64_t length);
    void forget();
    std::string bytesAt(std::uint64_t offset, std::uint64_t length) const;
    Error corrupt(const QString& what) const;

    QString path_;
    mutable QFile file_;
    std::uint64_t size_ = 0;
    std::uint64_t dataStart_ = 0;  ///< offset after the header
    bool complete_ = false;
    QStringList problems_;
    std::string profile_;
    std::string library_;
    std::map<std::uint16_t, Schema> schemas_;
    std::map<std::uint16_t, Channel> channels_;
    std::vector<ChunkIndex> chunks_;
    std::vector<AttachmentIndex> attachments_;
    std::vector<MetadataIndex> metadata_;
};

}  // namespace tiller::recording::mcap
