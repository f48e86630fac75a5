// SPDX-License-Identifier: MIT
#include "robot/recording/mcap/mcap_export.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <set>

#include "robot/core/atomic_file.h"
#include "robot/core/clock.h"
#include "robot/recording/detail/exported_events.h"
#include "robot/recording/detail/ranges.h"
#include "robot/recording/mcap/detail/bytes.h"
#include "robot/recording/mcap/detail/topics.h"
#include "robot/recording/mcap/robot_state_message.h"
#include "robot/recording/mcap/ros_messages.h"
#include "robot/recording/mcap/writer.h"
#include "robot/recording/recorder.h"

namespace tiller::recording {

namespace {

using namespace mcap;

constexpr std::uint64_t kRowsPerChunk = 512;
/// Encodes little-endian CDR. Every number in the message has eight bytes, so no padding is necessary.
constexpr std::string_view kCdrHead{"\0\1\0\0", 4};

/// Returns a name that is valid in ROS messages and not in `used`. Capital letters are kept, because the
/// reader restores names from the metadata of the channel.
std::string rosColumnName(std::string_view column, std::set<std::string>& used) {
    std::string name(column);
    const auto isLetter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
    std::replace_if(
        name.begin(), name.end(), [&](char c) { return !isLetter(c) && (c < '0' || c > '9'); }, '_');
    if (name.empty() || !isLetter(name.front())) {
        name.insert(0, "x_");
    }
    const std::string plain = name;
    const auto lower = [](std::string text) {
        std::transform(text.begin(), text.end(), text.begin(),
                       [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
        return text;
    };
    for (int number = 2; !used.insert(lower(name)).second; ++number) {
        name = plain + '_' + std::to_string(number);
    }
    return name;
}

/// Writes the rows and events of one export.
class McapExporter {
public:
    McapExporter(const Recording& recording, const std::vector<std::size_t>& columns, RowRange rows)
        : recording_(recording), columns_(columns), rows_(rows), writer_("ros2", "tiller") {
        Facts facts = recording.facts();
        writer_.addMetadata(kFactsName, facts);
        std::string definition;
        std::string names;
        std::set<std::string> used{kLostColumn};
        for (const std::size_t column : columns_) {
            const RecordedColumn& described = recording.columns()[column];
            const std::string name = rosColumnName(described.name, used);
            std::string lower = name;
            std::transform(lower.begin(), lower.end(), lower.begin(), [](char c) {
                return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
            });
            definition += "float64 " + lower;
            definition += described.unit.empty() ? "\n" : "  # [" + described.unit + "]\n";
            names += name + ',';
        }
        definition += std::string("uint64 ") + kLostColumn + '\n';
        stateChannel_ = channel(kStateType, definition, kStateTopic, {{kStateFields, names + kLostColumn}});
        logChannel_ = channel(logType().name, logType().definition, kLogTopic, {});
        start_ = recording.startUtcNs().value_or(0);
    }

    /// Writes the rows of one chunk.
    Result<std::string> part(RowRange range) {
        const auto times = recording_.times(range);
        const auto values = recording_.read(columns_, range);
        if (!times || !values) {
            return times ? values.error() : times.error();
        }
        ChunkBuilder chunk;
        for (std::uint64_t row = 0; row < range.count; ++row) {
            std::string bytes(kCdrHead);
            for (const std::vector<double>& column : values.value()) {
                mcap::put(bytes, std::bit_cast<std::uint64_t>(column.at(row)));
            }
            mcap::put(bytes, lostBefore(range.first + row));
            add(chunk, stateChannel_, utcNsAt(times->at(row)), bytes);
        }
        writer_.add(chunk);
        return writer_.take();
    }

    /// Writes the events of the export and the end of the file.
    Result<std::string> end(const ExportChoice& choice) {
        const auto events = exportedEvents(recording_, choice, rows_);
        if (!events) {
            return events.error();
        }
        ChunkBuilder chunk;
        for (const auto& [row, event] : *events) {
            std::string bytes;
            const std::int64_t time = utcNsAt(event.seconds);
            writeLog({time, event.level, Text(event.source), Text(event.text)}, bytes);
            add(chunk, logChannel_, time, bytes);
        }
        writer_.add(chunk);
        writer_.finish();
        return writer_.take();
    }

private:
    std::uint16_t channel(const char* type, const std::string& definition, const char* topic, Facts facts) {
        facts["offered_qos_profiles"] = "";
        return writer_.addChannel(writer_.addSchema(type, "ros2msg", definition), topic, "cdr", facts);
    }
    std::int64_t utcNsAt(double seconds) const {
        return std::max<std::int64_t>(0, start_ + std::llround(seconds * static_cast<double>(kNsPerSecond)));
    }
    static void add(ChunkBuilder& chunk, std::uint16_t number, std::int64_t utcNs, const std::string& bytes) {
        Message message;
        message.channel = number;
        message.logTime = message.publishTime = static_cast<std::uint64_t>(utcNs);
        message.data = bytes;
        chunk.add(message);
    }
    std::uint64_t lostBefore(std::uint64_t row) const {
        const auto& gaps = recording_.gaps();
        const auto gap =
            std::lower_bound(gaps.begin(), gaps.end(), row,
                             [](const RecordedGap& each, std::uint64_t at) { return each.row < at; });
        return gap == gaps.end() || gap->row != row ? 0 : std::max<std::uint64_t>(gap->packets, 1);
    }

    const Recording& recording_;
    std::vector<std::size_t> columns_;
    RowRange rows_;
    Writer writer_;
    std::uint16_t stateChannel_ = 0;
    std::uint16_t logChannel_ = 0;
    std::int64_t start_ = 0;
};

}  // namespace

Result<ExportReport> exportMcap(const Recording& recording, const ExportChoice& choice) {
    auto columns = columnsWithTime(recording, choice.columns);
    if (!columns) {
        return columns.error();
    }
    const auto rows = chooseRows(recording, choice);
    if (!rows) {
        return rows.error();
    }
    // `packages_lost` is computed from the gaps of the recording.
    std::erase_if(*columns,
                  [&](std::size_t column) { return recording.columns()[column].name == kLostColumn; });
    AtomicFile file(choice.path);
    if (const Result<void> opened = file.open(); !opened) {
        return opened.error();
    }
    ExportReport report;
    McapExporter exporter(recording, *columns, *rows);
    const auto write = [&](const Result<std::string>& bytes) -> Result<void> {
        if (!bytes) {
            return bytes.error();
        }
        report.bytes += static_cast<std::int64_t>(bytes->size());
        return file.write(std::string_view(*bytes));
    };
    for (std::uint64_t done = 0; done < rows->count; done += kRowsPerChunk) {
        if (choice.progress &&
            !choice.progress(static_cast<double>(done) / static_cast<double>(rows->count))) {
            return Error{ErrorCode::Cancelled, QStringLiteral("export to %1").arg(choice.path), {}};
        }
        const RowRange part{rows->first + done, std::min(kRowsPerChunk, rows->count - done)};
        if (const Result<void> written = write(exporter.part(part)); !written) {
            return written.error();
        }
        report.rows += part.count;
    }
    if (const Result<void> written = write(exporter.end(choice)); !written) {
        return written.error();
    }
    if (const Result<void> committed = file.commit(); !committed) {
        return committed.error();
    }
    return report;
}

}  // namespace tiller::recording
