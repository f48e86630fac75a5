// SPDX-License-Identifier: MIT
#include <algorithm>
#include <optional>
#include <utility>

#include "robot/recording/detail/csv_head.h"
#include "robot/recording/detail/csv_writer.h"
#include "robot/recording/recording_format.h"

namespace tiller::recording {

namespace {

class CsvEncoder : public RecordingEncoder {
public:
    CsvEncoder(CsvWriter writer, const Metadata& head) : writer_(std::move(writer)), head_(head) {
        if (head_.empty()) {
            addHead(std::nullopt);
        }
    }

    void add(const receive::Sample& sample, std::uint64_t lost, std::int64_t utcNs) override {
        if (!isHeaded_) {
            addHead(utcNs);
        }
        writer_.append(part_.bytes, sample, lost);
        ++part_.rows;
        part_.lost += lost;
    }
    void add(const RecordedNote& /*note*/) override {}
    RecordedPart take(Close how) override {
        if (!isHeaded_ && how == Close::Last) {
            addHead(std::nullopt);
        }
        takenHead_ = std::exchange(headSize_, 0);
        return std::exchange(part_, {});
    }
    std::size_t keepOf(std::string_view written, std::uint64_t& rows) const override {
        const std::size_t lineEnd = written.rfind('\n');
        const std::size_t kept = lineEnd == std::string_view::npos ? 0 : lineEnd + 1;
        const std::size_t first = std::min(takenHead_, kept);
        rows =
            static_cast<std::uint64_t>(std::count(written.begin() + static_cast<std::ptrdiff_t>(first),
                                                  written.begin() + static_cast<std::ptrdiff_t>(kept), '\n'));
        return kept;
    }

private:
    void addHead(std::optional<std::int64_t> startUtcNs) {
        isHeaded_ = true;
        part_.bytes =
            (head_.empty() ? std::string() : csvHeadLines(head_, startUtcNs, writer_.units(), ',')) +
            writer_.header();
        headSize_ = part_.bytes.size();
    }

    CsvWriter writer_;
    Metadata head_;
    bool isHeaded_ = false;
    std::size_t headSize_ = 0;   ///< size of the lines above the rows in the next part [bytes]
    std::size_t takenHead_ = 0;  ///< size of the lines above the rows in the last part [bytes]
    RecordedPart part_;
};

class CsvFormat : public RecordingFormat {
public:
    explicit CsvFormat(Metadata head) : head_(std::move(head)) {}
    std::unique_ptr<RecordingEncoder> encoder(const RecordingSetup& setup) const override {
        CsvWriter writer(*setup.layout, setup.fields, setup.asGiven);
        return writer.columns() == 0 ? nullptr : std::make_unique<CsvEncoder>(std::move(writer), head_);
    }
    bool keepsNotes() const override { return false; }

private:
    Metadata head_;
};

}  // namespace

std::shared_ptr<const RecordingFormat> csvFormat(Metadata head) {
    return std::make_shared<CsvFormat>(std::move(head));
}

}  // namespace tiller::recording
