// SPDX-License-Identifier: MIT
#include "robot/recording/mcap/mcap_recording.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <list>
#include <unordered_map>

#include "robot/core/clock.h"
#include "robot/recording/detail/ranges.h"
#include "robot/recording/detail/summarize.h"
#include "robot/recording/mcap/detail/summary_levels.h"
#include "robot/recording/mcap/detail/topics.h"
#include "robot/recording/mcap/reader.h"
#include "robot/recording/mcap/robot_state_message.h"
#include "robot/recording/mcap/ros_messages.h"
#include "robot/recording/recorder.h"

namespace tiller::recording {

namespace {

using namespace mcap;

constexpr std::size_t kMaxStateChannels = 64;
constexpr std::size_t kMaxColumns = 20'000;
constexpr int kMaxProblems = 20;
constexpr double kAbsent = receive::kAbsent;
constexpr std::size_t kChunksKept = 24;  // number of chunks in a block of the history

/// A chunk with robot states, in file order.
struct RowChunk {
    std::size_t chunk = 0;  ///< index in the reader's list
    std::uint64_t firstRow = 0;
    std::uint64_t rows = 0;
};

/// An unpacked chunk and the positions of its states.
struct UnpackedRows {
    struct Row {
        std::uint16_t channel;
        std::uint64_t sentNs;
        std::string_view message;
    };
    std::string records;
    std::vector<Row> rows;
};

/// Messages of one channel in one chunk.
struct Share {
    std::size_t chunk = 0;               ///< index in the reader's list
    std::optional<std::uint64_t> count;  ///< empty if the index is missing in the file
};

/// A channel of states: its layout and the column of each number.
struct StateChannel {
    RobotStateLayout layout;
    std::unordered_map<std::size_t, std::size_t> placeOfColumn;
};

class McapRecording : public Recording {
public:
    explicit McapRecording(std::unique_ptr<Reader> reader)
        : reader_(std::move(reader)), problems_(reader_->problems()) {}

    Result<void> prepare() {
        findShares();
        findChannels();
        if (states_.empty()) {
            return Error{ErrorCode::FileCorrupt, path(),
                         QStringLiteral("the file contains no robot states and was not recorded by Tiller")};
        }
        findRows();
        findTimes();
        readFacts();
        readGapsAndEvents();
        return {};
    }

    const QString& path() const override { return reader_->path(); }
    QString format() const override { return QStringLiteral("MCAP"); }
    const std::vector<RecordedColumn>& columns() const override { return columns_; }
    std::uint64_t rows() const override { return rows_; }
    const std::vector<RecordedGap>& gaps() const override { return gaps_; }
    const std::vector<RecordedEvent>& events() const override { return events_; }
    double period() const override { return period_; }
    std::optional<std::int64_t> startUtcNs() const override {
        return rows_ == 0 ? std::nullopt : std::optional(static_cast<std::int64_t>(startNs_));
    }
    const std::map<std::string, std::string>& facts() const override { return facts_; }
    const QStringList& problems() const override { return problems_; }
    const std::vector<RowRange>& unreadable() const override { return unreadable_; }

    QStringList attachments() const override {
        QStringList names;
        for (const AttachmentIndex& attachment : reader_->attachments()) {
            names << Text(attachment.name);
        }
        return names;
    }
    Result<QByteArray> attachment(const QString& name) const override {
        for (const AttachmentIndex& attachment : reader_->attachments()) {
            if (Text(attachment.name) == name) {
                auto bytes = reader_->attachment(attachment);
                return bytes ? Result<QByteArray>(QByteArray::fromStdString(bytes.value())) : bytes.error();
            }
        }
        return Recording::attachment(name);
    }

    Result<std::vector<double>> times(RowRange range) const override {
        std::vector<double> out;
        eachRow(range, [&](const UnpackedRows::Row* row) {
            const double before = out.empty() ? 0 : out.back();
            out.push_back(row == nullptr ? before : std::max(secondsOf(row->sentNs), before));
        });
        return out;
    }

    Result<std::vector<std::vector<double>>> read(std::span<const std::size_t> wanted,
                                                  RowRange range) const override {
        std::vector<std::vector<double>> out(wanted.size());
        for (auto& column : out) {
            column.reserve(static_cast<std::size_t>(within(range, rows_).count));
        }
        std::optional<std::uint16_t> channel;
        std::vector<const RobotStateLayout::Place*> places(wanted.size(), nullptr);
        eachRow(range, [&](const UnpackedRows::Row* row) {
            if (row != nullptr && (!channel || *channel != row->channel)) {
                channel = row->channel;
                const StateChannel& state = states_.at(row->channel);
                for (std::size_t i = 0; i < wanted.size(); ++i) {
                    const auto place = state.placeOfColumn.find(wanted[i]);
                    places[i] =
                        place == state.placeOfColumn.end() ? nullptr : &state.layout.places()[place->second];
                }
            }
            for (std::size_t i = 0; i < wanted.size(); ++i) {
                const bool there = row != nullptr && places[i] != nullptr;
                out[i].push_back(there ? RobotStateLayout::valueAt(*places[i], row->message) : kAbsent);
            }
        });
        return out;
    }

    Result<std::vector<ColumnSummary>> summaries(std::span<const std::size_t> wanted, RowRange range,
                                                 std::uint64_t blocks) const override {
        const RowRange part = within(range, rows_);
        for (std::size_t level = kSummaryLevels; level-- > 0;) {
            const std::uint64_t each = rowsOfLevel(level);
            if (part.count / each < std::max<std::uint64_t>(blocks, 1)) {
                continue;
            }
            if (auto found = fromSummaries(level, wanted, part)) {
                return *std::move(found);
            }
        }
        return Recording::summaries(wanted, part, blocks);
    }

    std::vector<std::uint64_t> summaryRows() const override {
        std::vector<std::uint64_t> kept;
        for (std::size_t level = 0; level < kSummaryLevels; ++level) {
            // After a crash, the last summaries are missing. Compute them from the rows.
            const std::uint64_t each = rowsOfLevel(level);
            std::uint64_t there = 0;
            const auto found = levelChannels_[level] ? shares_.find(*levelChannels_[level]) : shares_.end();
            for (std::size_t i = 0; found != shares_.end() && i < found->second.size(); ++i) {
                there += found->second[i].count.value_or(0);
            }
            if (there > rows_ / each / 2) {
                kept.push_back(each);
            }
        }
        return kept;
    }

    Result<std::vector<TimeMark>> timeMarks() const override {
        std::vector<TimeMark> marks;
        if (rows_ == 0) {
            return marks;
        }
        // Log times are arrival times, so the first row determines the offset.
        const std::uint64_t arrival = reader_->chunks()[rowChunks_.front().chunk].startTime;
        for (const RowChunk& chunk : rowChunks_) {
            const std::uint64_t time = reader_->chunks()[chunk.chunk].startTime;
            const double seconds = static_cast<double>(static_cast<std::int64_t>(time - arrival)) /
                                   static_cast<double>(kNsPerSecond);
            marks.push_back({chunk.firstRow, marks.empty() ? 0 : std::max(seconds, marks.back().seconds)});
        }
        const auto last = times({rows_ - 1, 1});
        if (last && !last->empty() && rows_ - 1 > marks.back().row) {
            marks.push_back({rows_ - 1, std::max(last->front(), marks.back().seconds)});
        }
        return marks;
    }

    Result<std::uint64_t> rowAt(double seconds) const override {
        if (rowChunks_.empty()) {
            return 0;
        }
        // Chunks have time ranges, so only one chunk is unpacked.
        const auto wanted =
            seconds <= 0 ? startNs_ : startNs_ + static_cast<std::uint64_t>(std::min(seconds, 1e9) * 1e9);
        auto chunk = std::upper_bound(rowChunks_.begin(), rowChunks_.end(), wanted,
                                      [&](std::uint64_t time, const RowChunk& each) {
                                          return time < reader_->chunks()[each.chunk].startTime;
                                      });
        // Log times are arrival times, which are later than the send times, so begin with the previous chunk.
        chunk = chunk == rowChunks_.begin() ? chunk : chunk - 1;
        std::uint64_t best = chunk->firstRow;
        for (auto each = chunk; each != rowChunks_.end() && each < chunk + 2; ++each) {
            const UnpackedRows& unpacked = unpack(*each);
            for (std::size_t i = 0; i < unpacked.rows.size() && i < each->rows; ++i) {
                if (secondsOf(unpacked.rows[i].sentNs) <= seconds) {
                    best = each->firstRow + i;
                }
            }
        }
        return best;
    }

private:
    double secondsOf(std::uint64_t ns) const {
        return static_cast<double>(static_cast<std::int64_t>(ns - startNs_)) /
               static_cast<double>(kNsPerSecond);
    }

    void problem(const QString& sentence) const {
        if (problems_.size() < kMaxProblems && !problems_.contains(sentence)) {
            problems_ << sentence;
        }
    }

    /// Adds the problem with a chunk and its position.
    void problemOf(std::size_t chunk, const Error& error) const {
        const auto rows = std::find_if(rowChunks_.begin(), rowChunks_.end(),
                                       [chunk](const RowChunk& each) { return each.chunk == chunk; });
        problem(rows == rowChunks_.end()
                    ? QStringLiteral("At byte %1: %2.")
                          .arg(reader_->chunks()[chunk].offset)
                          .arg(error.controllerMessage)
                    : QStringLiteral("About row %1: %2.").arg(rows->firstRow).arg(error.controllerMessage));
    }

    void findShares() {
        for (std::size_t i = 0; i < reader_->chunks().size(); ++i) {
            const ChunkIndex& chunk = reader_->chunks()[i];
            if (chunk.messageIndexes.empty()) {
                for (const auto& [number, channel] : reader_->channels()) {
                    shares_[number].push_back({i, std::nullopt});
                }
            }
            for (const auto& [number, offset] : chunk.messageIndexes) {
                shares_[number].push_back({i, reader_->messagesIn(chunk, number)});
            }
        }
        for (std::size_t level = 0; level < kSummaryLevels; ++level) {
            levelChannels_[level] = channelOf(kSummaryTopic + std::to_string(rowsOfLevel(level)));
        }
    }

    void findChannels() {
        std::unordered_map<std::string, std::size_t> known;
        for (const auto& [number, channel] : reader_->channels()) {
            const auto schema = reader_->schemas().find(channel.schema);
            if (channel.topic != kStateTopic || schema == reader_->schemas().end() ||
                schema->second.encoding != "ros2msg" || channel.encoding != "cdr" ||
                states_.size() >= kMaxStateChannels) {
                continue;
            }
            const auto names = channel.metadata.find(kStateFields);
            StateChannel state{
                RobotStateLayout(schema->second.data, names == channel.metadata.end() ? "" : names->second),
                {}};
            const auto& places = state.layout.places();
            for (std::size_t i = 0; i < places.size() && columns_.size() < kMaxColumns; ++i) {
                const auto [column, isNew] = known.emplace(places[i].column.name, columns_.size());
                if (isNew) {
                    columns_.push_back(places[i].column);
                }
                state.placeOfColumn[column->second] = i;
            }
            states_.emplace(number, std::move(state));
        }
    }

    void findRows() {
        std::map<std::size_t, std::uint64_t> counts;  // number of rows by chunk index
        for (const auto& [channel, state] : states_) {
            const auto found = shares_.find(channel);
            for (std::size_t i = 0; found != shares_.end() && i < found->second.size(); ++i) {
                const Share& share = found->second[i];
                if (share.count) {
                    counts[share.chunk] += *share.count;
                } else if (!counts.contains(share.chunk)) {
                    counts[share.chunk] =
                        unpack({share.chunk, 0, 0}).rows.size();  // the index is missing: count the messages
                }
            }
        }
        for (const auto& [number, named] : counts) {
            // Minimum size of a message. Limits the number of rows that a damaged index can specify.
            constexpr std::uint64_t kMinMessageSize = 31;
            const std::uint64_t most = reader_->chunks()[number].uncompressedSize / kMinMessageSize;
            const std::uint64_t count = std::min(named, most);
            constexpr std::uint64_t kMaxInChunk = 10'000'000;
            if (count > 0 && count < kMaxInChunk) {
                rowChunks_.push_back({number, rows_, count});
                rows_ += count;
            }
        }
    }

    void findTimes() {
        for (const RowChunk& chunk : rowChunks_) {
            const UnpackedRows& first = unpack(chunk);
            if (first.rows.empty()) {
                continue;
            }
            startNs_ = first.rows.front().sentNs;
            std::vector<std::uint64_t> steps;
            for (std::size_t i = 1; i < first.rows.size(); ++i) {
                if (first.rows[i].sentNs > first.rows[i - 1].sentNs) {
                    steps.push_back(first.rows[i].sentNs - first.rows[i - 1].sentNs);
                }
            }
            if (!steps.empty()) {
                std::sort(steps.begin(), steps.end());
                // Round to microseconds, because this exceeds the error of the clock conversion.
                constexpr double kMicroseconds = 1e6;
                const double seconds =
                    static_cast<double>(steps[steps.size() / 2]) / static_cast<double>(kNsPerSecond);
                period_ = std::round(seconds * kMicroseconds) / kMicroseconds;
            }
            return;
        }
    }

    void readFacts() {
        for (const MetadataIndex& metadata : reader_->metadata()) {
            if (metadata.name != kFactsName) {
                continue;
            }
            if (auto facts = reader_->facts(metadata)) {
                facts_ = std::move(facts).value();
                facts_.erase("columns");
            } else {
                problem(facts.error().controllerMessage);
            }
        }
    }

    std::optional<std::uint16_t> channelOf(const std::string& topic) const {
        for (const auto& [number, channel] : reader_->channels()) {
            if (channel.topic == topic) {
                return number;
            }
        }
        return std::nullopt;
    }

    void eachMessageOf(const Share& share, std::uint16_t channel,
                       const std::function<void(const Message&)>& sink) const {
        const auto records = reader_->records(reader_->chunks()[share.chunk]);
        if (!records) {
            problemOf(share.chunk, records.error());
            return;
        }
        Reader::forEachMessage(records.value(), [&](const Message& message) {
            if (message.channel == channel) {
                sink(message);
            }
        });
    }

    /// Calls sink for each message of a channel. Skips chunks without such messages.
    void eachMessage(std::uint16_t channel, const std::function<void(const Message&)>& sink) const {
        const auto found = shares_.find(channel);
        for (std::size_t i = 0; found != shares_.end() && i < found->second.size(); ++i) {
            eachMessageOf(found->second[i], channel, sink);
        }
    }

    void readGapsAndEvents() {
        if (const auto log = channelOf(kLogTopic)) {
            eachMessage(*log, [&](const Message& message) {
                RecordedNote note;
                if (readLog(message.data, note)) {
                    events_.push_back({secondsOf(static_cast<std::uint64_t>(note.utcNs)), note.level,
                                       note.source, note.text});
                }
            });
            std::stable_sort(events_.begin(), events_.end(),
                             [](const auto& a, const auto& b) { return a.seconds < b.seconds; });
        }
        const auto lost = indexOf(kLostColumn);
        if (!lost) {
            return;
        }
        const std::array<std::size_t, 1> wanted{*lost};
        findGaps(wanted, {0, rows_}, kSummaryLevels);
    }

    /// Searches for lost packets down to the rows, but only where a summary reports any.
    /// level  levels from here on have already been searched
    void findGaps(std::span<const std::size_t> lost, RowRange range, std::size_t level) {
        while (level > 0) {
            --level;
            const auto blocks = levelChannels_[level] ? fromSummaries(level, lost, range) : std::nullopt;
            if (!blocks) {
                continue;
            }
            const ColumnSummary& summary = blocks->front();
            // Process adjacent groups together, so that a shared chunk is unpacked only once.
            for (std::size_t i = 0; i < summary.max.size();) {
                std::size_t end = i;
                while (end < summary.max.size() && summary.max[end] > 0) {
                    ++end;
                }
                if (end > i) {
                    const std::uint64_t first = summary.firstRow + i * summary.rowsEach;
                    findGaps(lost, within({first, (end - i) * summary.rowsEach}, rows_), level);
                }
                i = end + 1;
            }
            return;
        }
        findGaps(lost, range);
    }

    void findGaps(std::span<const std::size_t> lost, RowRange range) {
        const RowRange part = within(range, rows_);
        constexpr std::uint64_t kAtOnce = 16384;
        for (std::uint64_t done = 0; done < part.count; done += kAtOnce) {
            const RowRange some{part.first + done, std::min(kAtOnce, part.count - done)};
            const auto values = read(lost, some);
            for (std::uint64_t i = 0; values && i < values.value().front().size(); ++i) {
                const double packets = values.value().front()[i];
                const std::uint64_t row = some.first + i;
                if (packets > 0 && packets < 1e15 && row > 0) {
                    const auto around = times({row - 1, 2});
                    gaps_.push_back(
                        {row, static_cast<std::uint64_t>(packets),
                         around && around.value().size() == 2 ? around.value()[1] - around.value()[0] : 0});
                }
            }
        }
    }

    /// Reads consecutive complete summaries of one level. The first one begins at the given row.
    /// until  summaries after this row are not needed
    std::vector<ColumnSummary> readLevel(std::size_t level, std::span<const std::size_t> wanted,
                                         std::uint64_t from, std::uint64_t until) const {
        std::vector<ColumnSummary> out(wanted.size());
        const auto channel = levelChannels_[level];
        const auto found = channel ? shares_.find(*channel) : shares_.end();
        if (found == shares_.end()) {
            return {};
        }
        const std::vector<std::size_t> places = summaryPlaces(*channel, wanted);
        const std::uint64_t each = rowsOfLevel(level);
        for (ColumnSummary& column : out) {
            column.firstRow = from;
            column.rowsEach = each;
        }
        std::uint64_t next = from;
        std::uint64_t row = 0;  // first row of the chunk
        SummaryMessage part;
        for (const Share& share : found->second) {
            if (share.count && row + *share.count * each <= from) {
                row += *share.count * each;
                continue;
            }
            if (row >= until) {
                break;
            }
            eachMessageOf(share, *channel, [&](const Message& message) {
                if (!readSummary(message.data, places, part)) {
                    return;
                }
                const bool last = part.firstRow + part.rowsEach == rows_;
                if (part.firstRow != next || (part.rowsEach != each && !last)) {
                    return;
                }
                next += part.rowsEach;
                for (std::size_t i = 0; i < wanted.size(); ++i) {
                    out[i].min.push_back(part.min[i]);
                    out[i].max.push_back(part.max[i]);
                    out[i].mean.push_back(part.mean[i]);
                }
            });
            row = next;
        }
        return out;
    }

    std::vector<std::size_t> summaryPlaces(std::uint16_t channel, std::span<const std::size_t> wanted) const {
        std::unordered_map<std::string_view, std::size_t> place;
        const auto& metadata = reader_->channels().at(channel).metadata;
        const auto names = metadata.find(kSummaryColumns);
        std::string_view rest = names == metadata.end() ? std::string_view() : names->second;
        for (std::size_t i = 0; !rest.empty(); ++i) {
            const std::size_t comma = rest.find(',');
            place.emplace(rest.substr(0, comma), i);
            rest.remove_prefix(comma == std::string_view::npos ? rest.size() : comma + 1);
        }
        std::vector<std::size_t> out;
        for (const std::size_t column : wanted) {
            const auto found = place.find(columns_.at(column).name);
            out.push_back(found == place.end() ? SIZE_MAX : found->second);
        }
        return out;
    }

    /// Returns the summaries that overlap a range. Missing summaries, e.g. after a crash, are computed from
    /// the rows.
    std::optional<std::vector<ColumnSummary>> fromSummaries(std::size_t level,
                                                            std::span<const std::size_t> wanted,
                                                            RowRange range) const {
        const std::uint64_t each = rowsOfLevel(level);
        const std::uint64_t first = range.first / each;
        const std::uint64_t last = (range.first + range.count + each - 1) / each;  // end (exclusive)
        std::vector<ColumnSummary> all = readLevel(level, wanted, first * each, last * each);
        if (all.empty() || wanted.empty()) {
            return std::nullopt;
        }
        const std::uint64_t there = first + all.front().min.size();
        // Missing blocks at the end are computed from the rows below. If most of the blocks are missing, another
        // level may cover the range.
        if (there < first + (last - first + 1) / 2) {
            return std::nullopt;
        }
        for (ColumnSummary& summary : all) {
            for (std::vector<double>* numbers : {&summary.min, &summary.max, &summary.mean}) {
                numbers->resize(static_cast<std::size_t>(std::min(there, last) - first));
            }
        }
        for (std::uint64_t block = there; block < last; ++block) {
            const auto rest = Recording::summaries(wanted, within({block * each, each}, rows_), 1);
            for (std::size_t i = 0; rest && i < wanted.size(); ++i) {
                const ColumnSummary& made = rest.value()[i];
                all[i].min.push_back(made.min.empty() ? kAbsent : made.min.front());
                all[i].max.push_back(made.max.empty() ? kAbsent : made.max.front());
                all[i].mean.push_back(made.mean.empty() ? kAbsent : made.mean.front());
            }
        }
        return all;
    }

    /// Calls sink with each row of a range; the argument is null if the row's chunk is damaged.
    template <class Sink>
    void eachRow(RowRange range, Sink sink) const {
        const RowRange part = within(range, rows_);
        const std::uint64_t end = part.first + part.count;
        auto chunk =
            std::upper_bound(rowChunks_.begin(), rowChunks_.end(), part.first,
                             [](std::uint64_t row, const RowChunk& each) { return row < each.firstRow; });
        chunk -= chunk == rowChunks_.begin() ? 0 : 1;
        for (; chunk != rowChunks_.end() && chunk->firstRow < end; ++chunk) {
            const UnpackedRows& unpacked = unpack(*chunk);
            const std::uint64_t from = std::max(part.first, chunk->firstRow) - chunk->firstRow;
            const std::uint64_t to = std::min(end, chunk->firstRow + chunk->rows) - chunk->firstRow;
            for (std::uint64_t i = from; i < to; ++i) {
                sink(i < unpacked.rows.size() ? &unpacked.rows[static_cast<std::size_t>(i)] : nullptr);
            }
        }
    }

    const UnpackedRows& unpack(const RowChunk& chunk) const {
        for (auto kept = kept_.begin(); kept != kept_.end(); ++kept) {
            if (kept->first == chunk.chunk) {
                kept_.splice(kept_.begin(), kept_, kept);
                return kept_.front().second;
            }
        }
        kept_.emplace_front(chunk.chunk, UnpackedRows());
        UnpackedRows& fresh = kept_.front().second;
        auto records = reader_->records(reader_->chunks()[chunk.chunk]);
        if (records) {
            fresh.records = std::move(records).value();
            const bool whole = Reader::forEachMessage(fresh.records, [&](const Message& message) {
                if (states_.contains(message.channel)) {
                    fresh.rows.push_back({message.channel, message.publishTime, message.data});
                }
            });
            if (!whole) {
                problem(QStringLiteral("A part of the file ends in the middle of a message."));
            }
        } else {
            problemOf(chunk.chunk, records.error());
        }
        const RowRange missing{chunk.firstRow + std::min<std::uint64_t>(fresh.rows.size(), chunk.rows),
                               chunk.rows - std::min<std::uint64_t>(fresh.rows.size(), chunk.rows)};
        const auto isKnown = [&missing](const RowRange& each) { return each.first == missing.first; };
        if (missing.count > 0 && std::none_of(unreadable_.begin(), unreadable_.end(), isKnown)) {
            unreadable_.push_back(missing);
        }
        if (kept_.size() > kChunksKept) {
            kept_.pop_back();
        }
        return fresh;
    }

    std::unique_ptr<Reader> reader_;
    mutable QStringList problems_;
    mutable std::vector<RowRange> unreadable_;
    std::map<std::uint16_t, StateChannel> states_;
    std::vector<RecordedColumn> columns_;
    std::map<std::uint16_t, std::vector<Share>> shares_;  ///< by channel, then in file order
    std::array<std::optional<std::uint16_t>, kSummaryLevels> levelChannels_;
    std::vector<RowChunk> rowChunks_;
    std::uint64_t rows_ = 0;
    std::uint64_t startNs_ = 0;
    double period_ = 0;
    std::map<std::string, std::string> facts_;
    std::vector<RecordedGap> gaps_;
    std::vector<RecordedEvent> events_;
    mutable std::list<std::pair<std::size_t, UnpackedRows>> kept_;  ///< most recently used first
};

}  // namespace

Result<std::unique_ptr<Recording>> openMcap(const Text& path) {
    auto reader = Reader::open(path);
    if (!reader) {
        return reader.error();
    }
    auto recording = std::make_unique<McapRecording>(std::move(reader).value());
    if (auto prepared = recording->prepare(); !prepared) {
        return prepared.error();
    }
    return std::unique_ptr<Recording>(std::move(recording));
}

}  // namespace tiller::recording
