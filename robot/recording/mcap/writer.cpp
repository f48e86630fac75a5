// SPDX-License-Identifier: MIT
#include "robot/recording/mcap/writer.h"

#include <zstd.h>

#include <algorithm>
#include <numeric>

#include "robot/recording/mcap/detail/bytes.h"
#include "robot/recording/mcap/detail/crc.h"

namespace tiller::recording::mcap {

namespace {

std::string content(const Schema& schema) {
    std::string out;
    put(out, schema.id);
    putText(out, schema.name);
    putText(out, schema.encoding);
    putText(out, schema.data);
    return out;
}

std::string content(const Channel& channel) {
    std::string out;
    put(out, channel.id);
    put(out, channel.schema);
    putText(out, channel.topic);
    putText(out, channel.encoding);
    putFacts(out, channel.metadata);
    return out;
}

std::string content(const ChunkIndex& chunk) {
    std::string out;
    put(out, chunk.startTime);
    put(out, chunk.endTime);
    put(out, chunk.offset);
    put(out, chunk.length);
    std::string indexes;
    for (const auto& [channel, offset] : chunk.messageIndexes) {
        put(indexes, channel);
        put(indexes, offset);
    }
    putText(out, indexes);
    put(out, chunk.messageIndexLength);
    putText(out, chunk.compression);
    put(out, chunk.compressedSize);
    put(out, chunk.uncompressedSize);
    return out;
}

std::string content(const AttachmentIndex& attachment) {
    std::string out;
    put(out, attachment.offset);
    put(out, attachment.length);
    put(out, attachment.logTime);
    put(out, attachment.createTime);
    put(out, attachment.dataSize);
    putText(out, attachment.name);
    putText(out, attachment.mediaType);
    return out;
}

std::string content(const MetadataIndex& metadata) {
    std::string out;
    put(out, metadata.offset);
    put(out, metadata.length);
    putText(out, metadata.name);
    return out;
}

}  // namespace

void ChunkBuilder::add(const Message& message) {
    std::string& index = indexes_[message.channel];
    put(index, message.logTime);
    put(index, static_cast<std::uint64_t>(records_.size()));
    records_.push_back(static_cast<char>(Opcode::Message));
    constexpr std::size_t kMessageHead = 2 + 4 + 8 + 8;
    put(records_, static_cast<std::uint64_t>(kMessageHead + message.data.size()));
    put(records_, message.channel);
    put(records_, message.sequence);
    put(records_, message.logTime);
    put(records_, message.publishTime);
    records_.append(message.data);
    start_ = count_ == 0 ? message.logTime : std::min(start_, message.logTime);
    end_ = std::max(end_, message.logTime);
    ++count_;
}

Writer::Writer(std::string_view profile, std::string_view library, int level)
    : level_(level), compressor_(ZSTD_createCCtx(), ZSTD_freeCCtx) {
    out_ = kMagic;
    std::string header;
    putText(header, profile);
    putText(header, library);
    record(Opcode::Header, header);
}

Writer::~Writer() = default;

void Writer::record(Opcode opcode, std::string_view bytes) {
    putRecord(out_, opcode, bytes);
}

std::uint16_t Writer::addSchema(std::string_view name, std::string_view encoding, std::string_view data) {
    for (const Schema& known : schemas_) {
        if (known.name == name && known.encoding == encoding && known.data == data) {
            return known.id;
        }
    }
    const auto id = static_cast<std::uint16_t>(schemas_.size() + 1);
    schemas_.push_back({id, std::string(name), std::string(encoding), std::string(data)});
    record(Opcode::Schema, content(schemas_.back()));
    return id;
}

std::uint16_t Writer::addChannel(std::uint16_t schema, std::string_view topic, std::string_view encoding,
                                 const Facts& metadata) {
    for (const Channel& known : channels_) {
        if (known.schema == schema && known.topic == topic && known.encoding == encoding &&
            known.metadata == metadata) {
            return known.id;
        }
    }
    const auto id = static_cast<std::uint16_t>(channels_.size() + 1);
    channels_.push_back({id, schema, std::string(topic), std::string(encoding), metadata});
    record(Opcode::Channel, content(channels_.back()));
    return id;
}

void Writer::addMetadata(std::string_view name, const Facts& facts) {
    std::string bytes;
    putText(bytes, name);
    putFacts(bytes, facts);
    metadata_.push_back({position(), kRecordHead + bytes.size(), std::string(name)});
    record(Opcode::Metadata, bytes);
}

void Writer::addAttachment(std::string_view name, std::string_view mediaType, std::string_view data,
                           std::uint64_t time) {
    std::string bytes;
    put(bytes, time);
    put(bytes, time);
    putText(bytes, name);
    putText(bytes, mediaType);
    put(bytes, static_cast<std::uint64_t>(data.size()));
    bytes.append(data);
    put(bytes, crcOf(bytes));
    attachments_.push_back({position(), kRecordHead + bytes.size(), time, time, data.size(),
                            std::string(name), std::string(mediaType)});
    record(Opcode::Attachment, bytes);
}

void Writer::add(ChunkBuilder& chunk) {
    if (chunk.isEmpty()) {
        return;
    }
    std::string_view stored = chunk.records_;
    std::string compression;
    if (level_ != 0) {
        compressed_.resize(ZSTD_compressBound(stored.size()));
        const std::size_t size = ZSTD_compressCCtx(compressor_.get(), compressed_.data(), compressed_.size(),
                                                   stored.data(), stored.size(), level_);
        // Compression fails only if memory is exhausted. The messages are then written uncompressed.
        if (ZSTD_isError(size) == 0) {
            stored = std::string_view(compressed_).substr(0, size);
            compression = "zstd";
        }
    }
    ChunkIndex index;
    index.startTime = chunk.start_;
    index.endTime = chunk.end_;
    index.offset = position();
    index.compression = compression;
    index.compressedSize = stored.size();
    index.uncompressedSize = chunk.records_.size();

    std::string head;
    put(head, chunk.start_);
    put(head, chunk.end_);
    put(head, index.uncompressedSize);
    put(head, crcOf(chunk.records_));
    putText(head, compression);
    put(head, index.compressedSize);
    out_.push_back(static_cast<char>(Opcode::Chunk));
    put(out_, static_cast<std::uint64_t>(head.size() + stored.size()));
    out_.append(head);
    out_.append(stored);
    index.length = position() - index.offset;

    const std::uint64_t indexesFrom = position();
    for (const auto& [channel, entries] : chunk.indexes_) {
        constexpr std::size_t kEntry = 16;
        index.messageIndexes.emplace_back(channel, position());
        counts_[channel] += entries.size() / kEntry;
        std::string bytes;
        put(bytes, channel);
        putText(bytes, entries);
        record(Opcode::MessageIndex, bytes);
    }
    index.messageIndexLength = position() - indexesFrom;
    start_ = chunks_.empty() ? index.startTime : std::min(start_, index.startTime);
    end_ = std::max(end_, index.endTime);
    chunks_.push_back(std::move(index));

    chunk.records_.clear();
    chunk.indexes_.clear();
    chunk.start_ = chunk.end_ = chunk.count_ = 0;
}

void Writer::summary() {
    std::string offsets;
    const auto group = [&](Opcode opcode, const auto& records) {
        const std::uint64_t from = position();
        for (const auto& each : records) {
            record(opcode, content(each));
        }
        if (position() > from) {
            std::string entry;
            put(entry, static_cast<std::uint8_t>(opcode));
            put(entry, from);
            put(entry, position() - from);
            putRecord(offsets, Opcode::SummaryOffset, entry);
        }
    };
    const std::uint64_t summaryStart = position();
    const std::size_t summaryAt = out_.size();
    group(Opcode::Schema, schemas_);
    group(Opcode::Channel, channels_);

    std::string statistics;
    put(statistics, std::accumulate(counts_.begin(), counts_.end(), std::uint64_t(0),
                                    [](std::uint64_t sum, const auto& each) { return sum + each.second; }));
    put(statistics, static_cast<std::uint16_t>(schemas_.size()));
    put(statistics, static_cast<std::uint32_t>(channels_.size()));
    put(statistics, static_cast<std::uint32_t>(attachments_.size()));
    put(statistics, static_cast<std::uint32_t>(metadata_.size()));
    put(statistics, static_cast<std::uint32_t>(chunks_.size()));
    put(statistics, start_);
    put(statistics, end_);
    std::string counts;
    for (const auto& [channel, count] : counts_) {
        put(counts, channel);
        put(counts, count);
    }
    putText(statistics, counts);
    const std::uint64_t statisticsAt = position();
    record(Opcode::Statistics, statistics);
    std::string entry;
    put(entry, static_cast<std::uint8_t>(Opcode::Statistics));
    put(entry, statisticsAt);
    put(entry, position() - statisticsAt);
    putRecord(offsets, Opcode::SummaryOffset, entry);

    group(Opcode::ChunkIndex, chunks_);
    group(Opcode::AttachmentIndex, attachments_);
    group(Opcode::MetadataIndex, metadata_);

    const std::uint64_t offsetsStart = position();
    out_.append(offsets);
    out_.push_back(static_cast<char>(Opcode::Footer));
    put(out_, std::uint64_t(8 + 8 + 4));
    put(out_, summaryStart);
    put(out_, offsetsStart);
    put(out_, crcOf(std::string_view(out_).substr(summaryAt)));
}

void Writer::finish() {
    std::string end;
    put(end, std::uint32_t(0));  // checksum of the whole data section: unused, because every chunk has one
    record(Opcode::DataEnd, end);
    summary();
    out_.append(kMagic);
}

std::string Writer::take() {
    taken_ += out_.size();
    return std::exchange(out_, {});
}

}  // namespace tiller::recording::mcap
