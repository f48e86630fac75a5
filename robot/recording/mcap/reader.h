// SPDX-License-Identifier: MIT
#pragma once

// Looks into an MCAP file: by its summary where there is a sound one, or else by going through it from the start, as far
// as whole records reach. Nothing of a file is trusted: what is broken is left out and said.

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
    /// Errors   FileNotReadable; FileCorrupt: it is no MCAP file
    /// Blocks   reads the summary, or looks at every record's head
    static Result<std::unique_ptr<Reader>> open(const Text& path);

    const QString& path() const { return path_; }  ///< Of the file.
    /// It ended as it should, with a summary.
    bool isComplete() const { return complete_; }
    const QStringList& problems() const { return problems_; }  ///< What is broken, a sentence each.
    const std::string& profile() const { return profile_; }    ///< "ros2"
    const std::string& library() const { return library_; }    ///< Who wrote it.
    const std::map<std::uint16_t, Schema>& schemas() const { return schemas_; }     ///< By number.
    const std::map<std::uint16_t, Channel>& channels() const { return channels_; }  ///< By number.
    const std::vector<ChunkIndex>& chunks() const { return chunks_; }  ///< In the order of the file.
    const std::vector<AttachmentIndex>& attachments() const { return attachments_; }  ///< In their order.
    const std::vector<MetadataIndex>& metadata() const { return metadata_; }          ///< In their order.

    /// How many messages of a channel the indexes behind a chunk name; nothing where they are missing.
    std::optional<std::uint64_t> messagesIn(const ChunkIndex& chunk, std::uint16_t channel) const;
    /// The records of a chunk, checked and unpacked.
    Result<std::string> records(const ChunkIndex& chunk) const;
    Result<Facts> facts(const MetadataIndex& metadata) const;                 ///< What is in one of them.
    Result<std::string> attachment(const AttachmentIndex& attachment) const;  ///< Its bytes, checked.

    /// Calls sink for each message of unpacked records, in order.
    /// Returns  false when they ended in the middle of something
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
    std::uint64_t dataStart_ = 0;  ///< behind the header
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
