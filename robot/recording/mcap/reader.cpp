// SPDX-License-Identifier: MIT
#include "robot/recording/mcap/reader.h"

#include <zstd.h>

#include <algorithm>

#include "robot/core/file_reading.h"
#include "robot/recording/mcap/detail/bytes.h"
#include "robot/recording/mcap/detail/crc.h"

namespace tiller::recording::mcap {

namespace {

// Plausibility limits for lengths. Damaged lengths usually exceed them.
constexpr std::uint64_t kLargestSmallRecord = 16u << 20;
constexpr std::uint64_t kLargestChunk = 256u << 20;
constexpr std::uint64_t kLargestAttachment = 256u << 20;
constexpr std::size_t kFooterSize = kRecordHead + 8 + 8 + 4;

Schema schemaFrom(std::string_view content) {
    ByteReader in(content);
    Schema schema;
    schema.id = in.number<std::uint16_t>();
    schema.name = in.text();
    schema.encoding = in.text();
    schema.data = in.text();
    schema.id = in.ok() ? schema.id : std::uint16_t(0);
    return schema;
}

std::optional<Channel> channelFrom(std::string_view content) {
    ByteReader in(content);
    Channel channel;
    channel.id = in.number<std::uint16_t>();
    channel.schema = in.number<std::uint16_t>();
    channel.topic = in.text();
    channel.encoding = in.text();
    channel.metadata = in.facts();
    return in.ok() ? std::optional(channel) : std::nullopt;
}

std::optional<ChunkIndex> chunkIndexFrom(std::string_view content) {
    ByteReader in(content);
    ChunkIndex chunk;
    chunk.startTime = in.number<std::uint64_t>();
    chunk.endTime = in.number<std::uint64_t>();
    chunk.offset = in.number<std::uint64_t>();
    chunk.length = in.number<std::uint64_t>();
    ByteReader indexes(in.text());
    while (indexes.ok() && !indexes.atEnd()) {
        const auto channel = indexes.number<std::uint16_t>();
        chunk.messageIndexes.emplace_back(channel, indexes.number<std::uint64_t>());
    }
    chunk.messageIndexLength = in.number<std::uint64_t>();
    chunk.compression = in.text();
    chunk.compressedSize = in.number<std::uint64_t>();
    chunk.uncompressedSize = in.number<std::uint64_t>();
    return in.ok() && indexes.ok() ? std::optional(chunk) : std::nullopt;
}

}  // namespace

Error Reader::corrupt(const QString& what) const {
    return {ErrorCode::FileCorrupt, path_, what};
}

Result<std::unique_ptr<Reader>> Reader::open(const Text& path) {
    std::unique_ptr<Reader> reader(new Reader(path));
    if (const Result<void> opened = openForReading(reader->file_, path); !opened) {
        return opened.error();
    }
    reader->size_ = static_cast<std::uint64_t>(reader->file_.size());
    if (auto header = reader->readHeader(); !header) {
        return header.error();
    }
    if (!reader->readSummary()) {
        reader->scan();
    }
    return reader;
}

std::string Reader::bytesAt(std::uint64_t offset, std::uint64_t length) const {
    if (offset > size_ || length > size_ - offset || !file_.seek(static_cast<qint64>(offset))) {
        return {};
    }
    std::string bytes(static_cast<std::size_t>(length), '\0');
    const qint64 got = file_.read(bytes.data(), static_cast<qint64>(length));
    return got == static_cast<qint64>(length) ? bytes : std::string();
}

Result<void> Reader::readHeader() {
    const std::string begin = bytesAt(0, kMagic.size() + kRecordHead);
    if (begin.size() < kMagic.size() || !begin.starts_with(kMagic)) {
        return corrupt(QStringLiteral("the file is not an MCAP file"));
    }
    ByteReader head(std::string_view(begin).substr(kMagic.size()));
    const auto opcode = head.number<std::uint8_t>();
    const auto length = head.number<std::uint64_t>();
    if (opcode != static_cast<std::uint8_t>(Opcode::Header) || length > kLargestSmallRecord) {
        return corrupt(QStringLiteral("the MCAP file has no header"));
    }
    const std::string content = bytesAt(begin.size(), length);
    ByteReader in(content);
    profile_ = in.text();
    library_ = in.text();
    if (!in.ok()) {
        return corrupt(QStringLiteral("the header of the MCAP file is damaged"));
    }
    dataStart_ = begin.size() + length;
    return {};
}

bool Reader::readSummary() {
    if (size_ < dataStart_ + kFooterSize + kMagic.size()) {
        return false;
    }
    const std::uint64_t footerAt = size_ - kFooterSize - kMagic.size();
    const std::string end = bytesAt(footerAt, kFooterSize + kMagic.size());
    if (!end.ends_with(kMagic) || end.front() != static_cast<char>(Opcode::Footer)) {
        return false;
    }
    ByteReader footer(std::string_view(end).substr(kRecordHead));
    const auto summaryStart = footer.number<std::uint64_t>();
    const auto offsetsStart = footer.number<std::uint64_t>();
    const auto checksum = footer.number<std::uint32_t>();
    if (summaryStart < dataStart_ || summaryStart > footerAt) {
        return false;
    }
    const std::uint64_t summaryEnd = offsetsStart == 0 ? footerAt : offsetsStart;
    if (summaryEnd < summaryStart || summaryEnd > footerAt) {
        return false;
    }
    const std::string summary = bytesAt(summaryStart, size_ - kMagic.size() - 4 - summaryStart);
    if (checksum != 0 && crcOf(summary) != checksum) {
        problems_ << QStringLiteral("The summary is damaged: the whole file was read instead.");
        return false;
    }
    ByteReader records(
        std::string_view(summary).substr(0, static_cast<std::size_t>(summaryEnd - summaryStart)));
    constexpr std::size_t kMinChunkIndex = 90;
    chunks_.reserve(summary.size() / kMinChunkIndex);
    while (records.ok() && !records.atEnd()) {
        const auto opcode = records.number<std::uint8_t>();
        const std::string_view content = records.bytes(records.number<std::uint64_t>());
        if (records.ok()) {
            takeSummary(static_cast<Opcode>(opcode), content);
        }
    }
    if (!records.ok() || chunks_.empty()) {
        forget();
        return false;
    }
    complete_ = true;
    return true;
}

void Reader::forget() {
    schemas_.clear();
    channels_.clear();
    chunks_.clear();
    attachments_.clear();
    metadata_.clear();
}

void Reader::takeSummary(Opcode opcode, std::string_view content) {
    ByteReader in(content);
    switch (opcode) {
        case Opcode::Schema:
            if (Schema schema = schemaFrom(content); schema.id != 0) {
                schemas_[schema.id] = std::move(schema);
            }
            break;
        case Opcode::Channel:
            if (auto channel = channelFrom(content)) {
                channels_[channel->id] = std::move(*channel);
            }
            break;
        case Opcode::ChunkIndex:
            if (auto chunk = chunkIndexFrom(content)) {
                chunks_.push_back(std::move(*chunk));
            }
            break;
        case Opcode::AttachmentIndex: {
            AttachmentIndex attachment;
            attachment.offset = in.number<std::uint64_t>();
            attachment.length = in.number<std::uint64_t>();
            attachment.logTime = in.number<std::uint64_t>();
            attachment.createTime = in.number<std::uint64_t>();
            attachment.dataSize = in.number<std::uint64_t>();
            attachment.name = in.text();
            attachment.mediaType = in.text();
            if (in.ok()) {
                attachments_.push_back(std::move(attachment));
            }
            break;
        }
        case Opcode::MetadataIndex: {
            MetadataIndex index;
            index.offset = in.number<std::uint64_t>();
            index.length = in.number<std::uint64_t>();
            index.name = in.text();
            if (in.ok()) {
                metadata_.push_back(std::move(index));
            }
            break;
        }
        default:
            break;
    }
}

void Reader::scan() {
    std::uint64_t at = dataStart_;
    while (at < size_) {
        const std::string head = bytesAt(at, std::min<std::uint64_t>(kRecordHead, size_ - at));
        ByteReader in(head);
        const auto opcode = static_cast<Opcode>(in.number<std::uint8_t>());
        const auto length = in.number<std::uint64_t>();
        const bool ends = opcode == Opcode::DataEnd || opcode == Opcode::Footer;
        if (in.ok() && ends) {
            return;
        }
        if (!in.ok() || length > size_ - at - kRecordHead) {
            problems_ << QStringLiteral(
                             "The file ends in the middle of a part: its last %1 bytes could not be read.")
                             .arg(size_ - at);
            return;
        }
        const std::uint64_t contentAt = at + kRecordHead;
        const std::uint64_t next = contentAt + length;
        bool sound = true;
        if (opcode == Opcode::Chunk) {
            sound = takeChunk(at, length);
        } else if (opcode == Opcode::Attachment && length <= kLargestAttachment) {
            const std::string begin = bytesAt(contentAt, std::min<std::uint64_t>(length, 65536));
            ByteReader attached(begin);
            AttachmentIndex attachment;
            attachment.offset = at;
            attachment.length = kRecordHead + length;
            attachment.logTime = attached.number<std::uint64_t>();
            attachment.createTime = attached.number<std::uint64_t>();
            attachment.name = attached.text();
            attachment.mediaType = attached.text();
            attachment.dataSize = attached.number<std::uint64_t>();
            sound = attached.ok();
            if (sound) {
                attachments_.push_back(std::move(attachment));
            }
        } else if (length > kLargestSmallRecord) {
            sound = false;
        } else if (opcode == Opcode::Schema || opcode == Opcode::Channel) {
            takeSummary(opcode, bytesAt(contentAt, length));
        } else if (opcode == Opcode::Metadata) {
            const std::string content = bytesAt(contentAt, length);
            metadata_.push_back({at, kRecordHead + length, std::string(ByteReader(content).text())});
        } else if (opcode == Opcode::MessageIndex && !chunks_.empty()) {
            const std::string begin = bytesAt(contentAt, std::min<std::uint64_t>(length, 2));
            ChunkIndex& chunk = chunks_.back();
            if (begin.size() == 2 && at == chunk.offset + chunk.length + chunk.messageIndexLength) {
                chunk.messageIndexes.emplace_back(ByteReader(begin).number<std::uint16_t>(), at);
                chunk.messageIndexLength += kRecordHead + length;
            }
        }
        if (!sound) {
            problems_ << QStringLiteral(
                             "The file is damaged at byte %1: the %2 bytes from there could not be read.")
                             .arg(at)
                             .arg(size_ - at);
            return;
        }
        at = next;
    }
}

bool Reader::takeChunk(std::uint64_t offset, std::uint64_t length) {
    constexpr std::uint64_t kHead = 8 + 8 + 8 + 4;
    constexpr std::uint64_t kMaxHead = kHead + 4 + 16 + 8;
    const std::string begin = bytesAt(offset + kRecordHead, std::min(length, kMaxHead));
    ByteReader in(begin);
    ChunkIndex chunk;
    chunk.offset = offset;
    chunk.length = kRecordHead + length;
    chunk.startTime = in.number<std::uint64_t>();
    chunk.endTime = in.number<std::uint64_t>();
    chunk.uncompressedSize = in.number<std::uint64_t>();
    in.number<std::uint32_t>();
    chunk.compression = in.text();
    chunk.compressedSize = in.number<std::uint64_t>();
    if (!in.ok()) {
        return false;
    }
    chunks_.push_back(std::move(chunk));
    return true;
}

std::optional<std::uint64_t> Reader::messagesIn(const ChunkIndex& chunk, std::uint16_t channel) const {
    const auto found = std::find_if(chunk.messageIndexes.begin(), chunk.messageIndexes.end(),
                                    [channel](const auto& index) { return index.first == channel; });
    if (found == chunk.messageIndexes.end()) {
        return chunk.messageIndexes.empty() ? std::nullopt : std::optional<std::uint64_t>(0);
    }
    // Records are contiguous, so the start of the next record determines the length of this one.
    std::uint64_t end = chunk.offset + chunk.length + chunk.messageIndexLength;
    for (const auto& [other, offset] : chunk.messageIndexes) {
        if (offset > found->second) {
            end = std::min(end, offset);
        }
    }
    constexpr std::uint64_t kHead = kRecordHead + 2 + 4;
    constexpr std::uint64_t kEntry = 16;
    if (end < found->second + kHead || end > size_) {
        return std::nullopt;
    }
    return (end - found->second - kHead) / kEntry;
}

Result<std::string> Reader::records(const ChunkIndex& chunk) const {
    if (chunk.length > kLargestChunk || chunk.length < kRecordHead) {
        return corrupt(QStringLiteral("a part of the file has an invalid length"));
    }
    const std::string record = bytesAt(chunk.offset, chunk.length);
    if (record.empty() || record.front() != static_cast<char>(Opcode::Chunk)) {
        return corrupt(QStringLiteral("a part of the file is not at the position stated in the summary"));
    }
    ByteReader in(std::string_view(record).substr(kRecordHead));
    in.number<std::uint64_t>();
    in.number<std::uint64_t>();
    const auto size = in.number<std::uint64_t>();
    const auto checksum = in.number<std::uint32_t>();
    const std::string_view compression = in.text();
    const std::string_view stored = in.bytes(in.number<std::uint64_t>());
    if (!in.ok() || size > kLargestChunk) {
        return corrupt(QStringLiteral("a part of the file is damaged"));
    }
    std::string records;
    if (compression.empty()) {
        records = stored;
    } else if (compression == "zstd") {
        records.resize(static_cast<std::size_t>(size));
        const std::size_t got = ZSTD_decompress(records.data(), records.size(), stored.data(), stored.size());
        if (ZSTD_isError(got) != 0) {
            return corrupt(QStringLiteral("a part of the file cannot be decompressed: %1")
                               .arg(QLatin1String(ZSTD_getErrorName(got))));
        }
        records.resize(got);
    } else {
        return corrupt(QStringLiteral("a part of the file uses the unknown compression \"%1\"")
                           .arg(QString::fromUtf8(compression.data(), qsizetype(compression.size()))));
    }
    if (records.size() != size || (checksum != 0 && crcOf(records) != checksum)) {
        return corrupt(QStringLiteral("the checksum of a part of the file is wrong"));
    }
    return records;
}

Result<Facts> Reader::facts(const MetadataIndex& metadata) const {
    if (metadata.length > kLargestSmallRecord) {
        return corrupt(QStringLiteral("the metadata of the recording are damaged"));
    }
    const std::string record = bytesAt(metadata.offset, metadata.length);
    ByteReader in(record);
    const auto opcode = static_cast<Opcode>(in.number<std::uint8_t>());
    in.number<std::uint64_t>();
    in.text();
    Facts facts = in.facts();
    if (!in.ok() || opcode != Opcode::Metadata) {
        return corrupt(QStringLiteral("the metadata of the recording are damaged"));
    }
    return facts;
}

Result<std::string> Reader::attachment(const AttachmentIndex& attachment) const {
    const QString what = QStringLiteral("the attached file \"%1\" is damaged").arg(Text(attachment.name));
    if (attachment.length > kLargestAttachment || attachment.length < kRecordHead + 4) {
        return corrupt(what);
    }
    const std::string record = bytesAt(attachment.offset, attachment.length);
    ByteReader in(record);
    const auto opcode = static_cast<Opcode>(in.number<std::uint8_t>());
    in.number<std::uint64_t>();
    in.number<std::uint64_t>();
    in.number<std::uint64_t>();
    in.text();
    in.text();
    const std::string_view data = in.bytes(in.number<std::uint64_t>());
    const auto checksum = in.number<std::uint32_t>();
    if (!in.ok() || opcode != Opcode::Attachment) {
        return corrupt(what);
    }
    const std::string_view covered =
        std::string_view(record).substr(kRecordHead, record.size() - kRecordHead - 4);
    if (checksum != 0 && crcOf(covered) != checksum) {
        return corrupt(what);
    }
    return std::string(data);
}

bool Reader::forEachMessage(std::string_view records, const std::function<void(const Message&)>& sink) {
    ByteReader in(records);
    while (!in.atEnd()) {
        const auto opcode = static_cast<Opcode>(in.number<std::uint8_t>());
        ByteReader content(in.bytes(in.number<std::uint64_t>()));
        if (!in.ok()) {
            return false;
        }
        if (opcode != Opcode::Message) {
            continue;
        }
        Message message;
        message.channel = content.number<std::uint16_t>();
        message.sequence = content.number<std::uint32_t>();
        message.logTime = content.number<std::uint64_t>();
        message.publishTime = content.number<std::uint64_t>();
        message.data = content.bytes(content.left());
        if (!content.ok()) {
            return false;
        }
        sink(message);
    }
    return true;
}

}  // namespace tiller::recording::mcap
