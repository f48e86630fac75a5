// SPDX-License-Identifier: MIT
#include <algorithm>
#include <utility>

#include "robot/recording/detail/csv_writer.h"
#include "robot/recording/recording_format.h"

namespace tiller::recording {

namespace {

class CsvEncoder : public RecordingEncoder {
public:
    explicit CsvEncoder(CsvWriter writer) : writer_(std::move(writer)) { part_.bytes = writer_.header(); }

    void add(const receive::Sample& sample, std::uint64_t lost, std::int64_t /*utcNs*/) override {
        writer_.append(part_.bytes, sample, lost);
        ++part_.rows;
        part_.lost += lost;
    }
    void add(const RecordedNote& /*note*/) override {}
    RecordedPart take(Close /*how*/) override { return std::exchange(part_, {}); }
    std::size_t keepOf(std::string_view written, std::uint64_t& rows) const override {
        const std::size_t lineEnd = written.rfind('\n');
        const std::size_t kept = lineEnd == std::string_view::npos ? 0 : lineEnd + 1;
        rows = static_cast<std::uint64_t>(
            std::count(written.begin(), written.begin() + static_cast<std::ptrdiff_t>(kept), '\n'));
        return kept;
    }

private:
    CsvWriter writer_;
    RecordedPart part_;
};

class CsvFormat : public RecordingFormat {
public:
    std::unique_ptr<RecordingEncoder> encoder(const RecordingSetup& setup) const override {
        CsvWriter writer(*setup.layout, setup.fields, setup.asGiven);
        return writer.columns() == 0 ? nullptr : std::make_unique<CsvEncoder>(std::move(writer));
    }
    bool keepsNotes() const override { return false; }
};

}  // namespace

std::shared_ptr<const RecordingFormat> csvFormat() {
    return std::make_shared<CsvFormat>();
}

}  // namespace tiller::recording
