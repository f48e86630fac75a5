// SPDX-License-Identifier: MIT
#pragma once

// One packet of the robot as a sample: sequence number, time of arrival and all values as doubles. The
// layout is fixed during the lifetime of a receiver and independent of the robot. Values that a robot does
// not send are NaN.

#include <QStringList>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "robot/core/text.h"
#include "robot/rtde/protocol.h"

namespace tiller::receive {

using tiller::operator<<;  // makes the enumerations below printable

inline constexpr double kAbsent = std::numeric_limits<double>::quiet_NaN();

/// Position of each field in the values of a sample. Immutable after construction.
/// Threads  any
class SampleLayout {
public:
    struct Entry {
        std::string name;
        rtde::DataType type = rtde::DataType::Double;
        std::size_t first = 0;
        std::size_t count = 1;
    };

    /// Types are those of the field catalogue. Unknown names (see unknownOutputs) and duplicates are ignored.
    explicit SampleLayout(const std::vector<std::string>& names);

    const std::vector<Entry>& entries() const { return entries_; }  ///< In the order of the recipe.
    /// Number of values in a sample.
    std::size_t size() const { return size_; }
    const Entry* find(
        std::string_view name) const;  ///< Returns null if the layout does not contain the field.
    /// Index of a component by its name in recordings, e.g. "actual_q_0", "robot_mode".
    std::optional<std::size_t> indexOfComponent(std::string_view component) const;
    /// Names in the order of the values, e.g. "actual_q_0".
    const std::vector<std::string>& componentNames() const { return componentNames_; }

private:
    std::vector<Entry> entries_;
    std::vector<std::string> componentNames_;
    std::unordered_map<std::string_view, std::size_t> entryByName_;
    std::unordered_map<std::string_view, std::size_t> componentByName_;
    std::size_t size_ = 0;

public:
    // The class is not copyable, because the maps contain pointers into the vectors.
    SampleLayout(const SampleLayout&) = delete;
    SampleLayout& operator=(const SampleLayout&) = delete;
};

/// One sentence for each name that is not an RTDE output, e.g. "there is no RTDE output \"actual_qq\": did
/// you mean \"actual_q\"?"
QStringList unknownOutputs(const std::vector<std::string>& names);

struct Sample {
    std::uint64_t sequence = 0;    ///< 1 for the first packet of the receiver; 0: no data yet
    std::int64_t hostTimeNs = 0;   ///< time of arrival on the clock of the receiver
    std::uint64_t connection = 0;  ///< 1 for the first connection; a change: the stream was interrupted
    std::uint64_t lostBefore =
        0;  ///< packets skipped by the controller before this one, from its time stamps
    std::vector<double> values;
    std::shared_ptr<const SampleLayout> layout;

    Sample() = default;
    /// Reserves memory for all values of the layout, so that filling the sample does not allocate.
    explicit Sample(std::shared_ptr<const SampleLayout> l)
        : values(l->size(), kAbsent), layout(std::move(l)) {}

    bool isEmpty() const { return sequence == 0; }  ///< True if no data were received yet.
    /// The value of one component; NaN if missing.
    double at(std::size_t index) const { return index < values.size() ? values[index] : kAbsent; }
    /// All components of a field; empty if the layout does not contain it or the robot does not send it.
    std::span<const double> field(std::string_view name) const;
};

}  // namespace tiller::receive
