// SPDX-License-Identifier: MIT
#include "robot/recording/recording.h"

#include <algorithm>
#include <numeric>

#include "robot/recording/detail/column_knowledge.h"
#include "robot/recording/detail/summarize.h"

namespace tiller::recording {

std::optional<std::size_t> Recording::indexOf(std::string_view column) const {
    const auto found =
        std::find_if(columns().begin(), columns().end(), [&](const auto& c) { return c.name == column; });
    return found == columns().end() ? std::nullopt
                                    : std::optional(static_cast<std::size_t>(found - columns().begin()));
}

std::optional<std::size_t> Recording::timeColumn() const {
    return timeColumnOf(columns());
}

const std::vector<RecordedEvent>& Recording::events() const {
    static const std::vector<RecordedEvent> none;
    return none;
}

std::optional<std::int64_t> Recording::startUtcNs() const {
    return std::nullopt;
}

const std::map<std::string, std::string>& Recording::facts() const {
    static const std::map<std::string, std::string> none;
    return none;
}

const std::vector<RowRange>& Recording::unreadable() const {
    static const std::vector<RowRange> kNone;
    return kNone;
}

QStringList Recording::attachments() const {
    return {};
}

Result<QByteArray> Recording::attachment(const QString& name) const {
    return Error{ErrorCode::FileNotReadable, QStringLiteral("\"%1\" in %2").arg(name, path()),
                 QStringLiteral("the recording contains no such file")};
}

Result<std::vector<ColumnSummary>> Recording::summaries(std::span<const std::size_t> wanted, RowRange range,
                                                        std::uint64_t blocks) const {
    constexpr std::uint64_t kAtOnce = 65536;  // number of rows kept in memory
    const std::uint64_t each = std::max<std::uint64_t>(1, range.count / std::max<std::uint64_t>(blocks, 1));
    std::vector<Summarizer> summarizers;
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        summarizers.emplace_back(range.first, each);
    }
    for (std::uint64_t done = 0; done < range.count; done += kAtOnce) {
        auto part = read(wanted, {range.first + done, std::min(kAtOnce, range.count - done)});
        if (!part) {
            return part.error();
        }
        for (std::size_t i = 0; i < wanted.size(); ++i) {
            summarizers[i].add(part.value()[i]);
        }
    }
    std::vector<ColumnSummary> out;
    for (Summarizer& summarizer : summarizers) {
        out.push_back(summarizer.finish());
    }
    return out;
}

Result<std::vector<TimeMark>> Recording::timeMarks() const {
    constexpr std::uint64_t kEvery = 256;
    std::vector<TimeMark> marks;
    const auto all = times({0, rows()});
    if (!all) {
        return all.error();
    }
    for (std::uint64_t row = 0; row < all->size(); row += kEvery) {
        marks.push_back({row, (*all)[row]});
    }
    if (!all->empty() && marks.back().row + 1 < all->size()) {
        marks.push_back({all->size() - 1, all->back()});
    }
    return marks;
}

Result<std::uint64_t> Recording::rowAt(double seconds) const {
    std::uint64_t low = 0;
    std::uint64_t high = rows();
    while (high - low > 1) {
        const std::uint64_t middle = low + (high - low) / 2;
        auto time = times({middle, 1});
        if (!time) {
            return time.error();
        }
        (time.value().front() <= seconds ? low : high) = middle;
    }
    return low;
}

}  // namespace tiller::recording
