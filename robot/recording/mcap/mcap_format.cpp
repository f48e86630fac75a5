// SPDX-License-Identifier: MIT
#include "robot/recording/mcap/mcap_format.h"

#include <array>
#include <chrono>
#include <limits>
#include <optional>
#include <utility>

#include "robot/recording/mcap/detail/clock_map.h"
#include "robot/recording/mcap/detail/summary_levels.h"
#include "robot/recording/mcap/detail/topics.h"
#include "robot/recording/mcap/robot_state_message.h"
#include "robot/recording/mcap/ros_messages.h"
#include "robot/recording/mcap/writer.h"
#include "robot/recording/recorder.h"

namespace tiller::recording {

namespace {

using namespace mcap;
using std::chrono::steady_clock;

constexpr std::size_t kCloseAt = 4u << 20;
constexpr std::size_t kCloseSummaryAt = 1u << 20;
constexpr std::size_t kMaxSummaries =
    300;  // messages per chunk; messages lost in a crash are recomputed from the rows

constexpr std::size_t kNowhere = std::numeric_limits<std::size_t>::max();

class McapEncoder : public RecordingEncoder {
public:
    McapEncoder(const RecordingSetup& setup, const McapFormatOptions& options)
        : options_(options)
        , fields_(setup.fields)
        , writer_("ros2", "tiller", options.compression)
        , levels_(columnsOf(*setup.layout),
                  [this](std::size_t level, const SummaryMessage& message) { keepSummary(level, message); }) {
        Facts facts = options.facts;
        facts["columns"] = columnNames_;
        writer_.addMetadata(kFactsName, facts);
        if (!options.attachmentName.empty()) {
            const auto now = std::chrono::system_clock::now().time_since_epoch();
            writer_.addAttachment(options.attachmentName, "application/octet-stream", options.attachment,
                                  static_cast<std::uint64_t>(
                                      std::chrono::duration_cast<std::chrono::nanoseconds>(now).count()));
        }
    }

    bool hasColumns() const { return !components_.empty(); }

    void add(const receive::Sample& sample, std::uint64_t lost, std::int64_t utcNs) override {
        if (!state_ || sample.connection != connection_ || sample.layout != layout_) {
            connection_ = sample.connection;
            follow(sample.layout);
            state_.emplace(fields_, sample);
            stateChannel_ = channel(kStateType, state_->definition(), kStateTopic,
                                    {{kStateFields, state_->fieldNames()}});
        }
        if (rows_.isEmpty()) {
            opened_ = steady_clock::now();
        }
        const std::int64_t sent = clock_.toUtc(timestampOf(sample), utcNs, sample.connection);
        Message message;
        message.logTime = static_cast<std::uint64_t>(std::max(utcNs, lastLog_));
        message.publishTime = static_cast<std::uint64_t>(sent);
        message.sequence = static_cast<std::uint32_t>(sample.sequence);
        lastLog_ = static_cast<std::int64_t>(message.logTime);
        state_->write(sample, lost, bytes_);
        put(rows_, message, stateChannel_);
        if (options_.ros) {
            if (writeJointState(sample, sent, bytes_)) {
                put(companions_, message, channel(jointStateType(), "/joint_states"));
            }
            if (writeWrench(sample, sent, bytes_)) {
                put(companions_, message, channel(wrenchType(), "/wrench"));
            }
            if (writeTransform(sample, sent, bytes_)) {
                put(companions_, message, channel(transformType(), "/tf"));
            }
        }
        levels_.addRow([&](std::size_t i) {
            return i < columns_.size() ? sample.at(columns_[i]) : static_cast<double>(lost);
        });
        ++part_.rows;
        part_.lost += lost;
        if (rows_.size() >= kCloseAt) {
            closeRows();
        }
    }

    void add(const RecordedNote& note) override {
        if (companions_.isEmpty() && rows_.isEmpty()) {
            opened_ = steady_clock::now();
        }
        writeLog(note, bytes_);
        Message message;
        message.logTime = message.publishTime = static_cast<std::uint64_t>(note.utcNs);
        put(companions_, message, channel(logType(), kLogTopic));
    }

    RecordedPart take(Close how) override {
        const bool due = steady_clock::now() - opened_ >= options_.closeAfter;
        if (how == Close::Last || (due && !(rows_.isEmpty() && companions_.isEmpty()))) {
            closeRows();
        }
        if (how == Close::Last) {
            levels_.finish();
            for (ChunkBuilder& summary : summaries_) {
                writer_.add(summary);
            }
            writer_.finish();
        }
        RecordedPart out = std::exchange(closed_, {});
        out.bytes = writer_.take();
        return out;
    }

    std::size_t keepOf(std::string_view /*written*/, std::uint64_t& rows) const override {
        rows = 0;
        return 0;
    }

private:
    /// Also fills the names of the columns, which the constructor needs.
    std::size_t columnsOf(const receive::SampleLayout& layout) {
        for (const std::string& name : fields_) {
            const receive::SampleLayout::Entry* entry = layout.find(name);
            for (std::size_t i = 0; entry != nullptr && i < entry->count; ++i) {
                components_.push_back(layout.componentNames()[entry->first + i]);
                columnNames_ += components_.back() + ',';
            }
        }
        columnNames_ += kLostColumn;
        return components_.size() + 1;
    }

    /// Finds the columns in the samples from now on.
    void follow(const std::shared_ptr<const receive::SampleLayout>& layout) {
        layout_ = layout;
        timestamp_ = layout->indexOfComponent("timestamp");
        columns_.clear();
        for (const std::string& component : components_) {
            columns_.push_back(layout->indexOfComponent(component).value_or(kNowhere));
        }
    }

    double timestampOf(const receive::Sample& sample) const {
        return timestamp_ ? sample.at(*timestamp_) : receive::kAbsent;
    }

    std::uint16_t channel(const char* type, const std::string& definition, const char* topic, Facts facts) {
        // The profile requires this entry. An empty value means no specific quality of service.
        facts["offered_qos_profiles"] = "";
        return writer_.addChannel(writer_.addSchema(type, "ros2msg", definition), topic, "cdr", facts);
    }
    std::uint16_t channel(const MessageType& type, const char* topic) {
        for (const auto& [known, number] : channels_) {
            if (known == topic) {
                return number;
            }
        }
        return channels_.emplace_back(topic, channel(type.name, type.definition, topic, {})).second;
    }

    void put(ChunkBuilder& chunk, Message& message, std::uint16_t number) {
        message.channel = number;
        message.data = bytes_;
        chunk.add(message);
    }

    void keepSummary(std::size_t level, const SummaryMessage& message) {
        writeSummary(message, bytes_);
        Message record;
        record.logTime = record.publishTime = static_cast<std::uint64_t>(lastLog_);
        record.sequence = static_cast<std::uint32_t>(level);
        const std::string topic = kSummaryTopic + std::to_string(rowsOfLevel(level));
        if (summaryChannels_[level] == 0) {
            summaryChannels_[level] = channel(summaryType().name, summaryType().definition, topic.c_str(),
                                              {{kSummaryColumns, columnNames_}});
        }
        // Each level has separate chunks, so that an overview of hours reads only the coarse levels.
        put(summaries_[level], record, summaryChannels_[level]);
        if (summaries_[level].size() >= kCloseSummaryAt || summaries_[level].count() >= kMaxSummaries) {
            writer_.add(summaries_[level]);
        }
    }

    void closeRows() {
        writer_.add(rows_);
        writer_.add(companions_);
        closed_.rows += std::exchange(part_.rows, 0);
        closed_.lost += std::exchange(part_.lost, 0);
    }

    const McapFormatOptions options_;
    const std::vector<std::string> fields_;
    std::vector<std::string> components_;  ///< names of the columns
    std::string columnNames_;              ///< names of the columns in one text
    std::shared_ptr<const receive::SampleLayout> layout_;
    std::vector<std::size_t> columns_;  ///< index of each column in the samples
    std::optional<std::size_t> timestamp_;
    Writer writer_;
    SummaryLevels levels_;
    ChunkBuilder rows_;
    ChunkBuilder companions_;
    std::array<ChunkBuilder, kSummaryLevels> summaries_;
    std::optional<RobotStateMessage> state_;
    std::uint16_t stateChannel_ = 0;
    std::vector<std::pair<std::string_view, std::uint16_t>> channels_;
    std::array<std::uint16_t, kSummaryLevels> summaryChannels_{};
    std::uint64_t connection_ = 0;
    std::int64_t lastLog_ = 0;
    ClockMap clock_;
    steady_clock::time_point opened_ = steady_clock::now();
    std::string bytes_;
    RecordedPart part_;    ///< data not yet in a closed chunk
    RecordedPart closed_;  ///< data in chunks closed since the last take()
};

class McapFormat : public RecordingFormat {
public:
    explicit McapFormat(McapFormatOptions options) : options_(std::move(options)) {}

    std::unique_ptr<RecordingEncoder> encoder(const RecordingSetup& setup) const override {
        auto encoder = std::make_unique<McapEncoder>(setup, options_);
        return encoder->hasColumns() ? std::move(encoder) : nullptr;
    }

private:
    McapFormatOptions options_;
};

}  // namespace

std::shared_ptr<const RecordingFormat> mcapFormat(McapFormatOptions options) {
    return std::make_shared<McapFormat>(std::move(options));
}

}  // namespace tiller::recording
