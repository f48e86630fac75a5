// SPDX-License-Identifier: MIT
#pragma once

// One data package of the robot with everything a consumer may ask of it: which number it has, when it came,
// and all its values as doubles. The layout is fixed for the life of a receiver, whatever robot answers: what
// a robot does not send is NaN.

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

using tiller::operator<<;  // for the enumerations below

inline constexpr double kAbsent = std::numeric_limits<double>::quiet_NaN();

/// Which field lies where among a sample's values. Never changes after construction.
/// Threads  any
class SampleLayout {
public:
    struct Entry {
        std::string name;
        rtde::DataType type = rtde::DataType::Double;
        std::size_t first = 0;
        std::size_t count = 1;
    };

    /// Types come from the field catalogue. Names it does not have are left out (see unknownOutputs), doubles
    /// too.
    explicit SampleLayout(const std::vector<std::string>& names);

    const std::vector<Entry>& entries() const { return entries_; }  ///< In the order of the recipe.
    /// Numbers in a sample.
    std::size_t size() const { return size_; }
    const Entry* find(std::string_view name) const;  ///< Null when it is not among them.
    /// Index of a component by the name recordings use: "actual_q_0", "robot_mode".
    std::optional<std::size_t> indexOfComponent(std::string_view component) const;
    /// "actual_q_0" ... in the order of the values.
    const std::vector<std::string>& componentNames() const { return componentNames_; }

private:
    std::vector<Entry> entries_;
    std::vector<std::string> componentNames_;
    std::unordered_map<std::string_view, std::size_t> entryByName_;
    std::unordered_map<std::string_view, std::size_t> componentByName_;
    std::size_t size_ = 0;

public:
    // The maps point into the vectors.
    SampleLayout(const SampleLayout&) = delete;
    SampleLayout& operator=(const SampleLayout&) = delete;
};

/// A sentence for each name that is not an RTDE output: "there is no RTDE output \"actual_qq\": did you mean
/// \"actual_q\"?"
QStringList unknownOutputs(const std::vector<std::string>& names);

struct Sample {
    std::uint64_t sequence = 0;    ///< 1 for the first package of the receiver's life; 0 = no data yet
    std::int64_t hostTimeNs = 0;   ///< when it was received, on the receiver's clock
    std::uint64_t connection = 0;  ///< 1 for the first connection; a change means the stream was interrupted
    std::uint64_t lostBefore = 0;  ///< packages the controller skipped just before, by its own time stamps
    std::vector<double> values;
    std::shared_ptr<const SampleLayout> layout;

    Sample() = default;
    /// With room for a layout's values, so that filling it again and again allocates nothing.
    explicit Sample(std::shared_ptr<const SampleLayout> l)
        : values(l->size(), kAbsent), layout(std::move(l)) {}

    bool isEmpty() const { return sequence == 0; }  ///< Nothing has come yet.
    /// The value of one component, NaN when absent.
    double at(std::size_t index) const { return index < values.size() ? values[index] : kAbsent; }
    /// All numbers of a field; empty when the layout does not have it or the robot does not send it.
    std::span<const double> field(std::string_view name) const;
};

}  // namespace tiller::receive
