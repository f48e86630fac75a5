// SPDX-License-Identifier: MIT
#include "robot/recording/detail/csv_writer.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "robot/recording/detail/column_knowledge.h"
#include "robot/recording/recorder.h"

namespace tiller::recording {

namespace {

/// The shortest text that converts back to the same number, independent of the locale.
template <class Number>
void appendNumber(std::string& out, Number value) {
    char text[32];
    const auto end = std::to_chars(text, text + sizeof text, value).ptr;
    out.append(text, end);
}

}  // namespace

CsvWriter::CsvWriter(const receive::SampleLayout& layout, const std::vector<std::string>& fields,
                     bool asGiven) {
    std::vector<std::string> ordered;
    if (!asGiven) {
        ordered.emplace_back("timestamp");
    }
    for (const std::string& field : fields) {
        if (std::find(ordered.begin(), ordered.end(), field) == ordered.end()) {
            ordered.push_back(field);
        }
    }
    for (const std::string& field : ordered) {
        const receive::SampleLayout::Entry* entry = layout.find(field);
        for (std::size_t i = 0; entry != nullptr && i < entry->count; ++i) {
            indices_.push_back(entry->first + i);
            header_ += layout.componentNames()[entry->first + i];
            header_ += ',';
            units_.push_back(unitOf(field, i));
        }
    }
    asGiven_ = asGiven && !indices_.empty();
    if (asGiven_) {
        header_.back() = '\n';
    } else {
        header_ += kLostColumn;
        units_.emplace_back();
        header_ += '\n';
    }
}

void CsvWriter::append(std::string& out, const receive::Sample& sample, std::uint64_t lost) const {
    for (const std::size_t index : indices_) {
        const double value = sample.at(index);
        if (!std::isnan(value)) {
            appendNumber(out, value);
        }
        out += ',';
    }
    if (asGiven_) {
        out.back() = '\n';
    } else {
        appendNumber(out, lost);
        out += '\n';
    }
}

}  // namespace tiller::recording
