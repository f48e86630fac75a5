// SPDX-License-Identifier: MIT
#include "robot/recording/detail/column_knowledge.h"

#include <algorithm>
#include <array>

#include "robot/recording/recorder.h"
#include "robot/rtde/fields.h"

namespace tiller::recording {

namespace {

std::string inLowerCase(std::string_view text) {
    std::string out(text);
    std::transform(out.begin(), out.end(), out.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return out;
}

}  // namespace

std::optional<std::size_t> timeColumnOf(const std::vector<RecordedColumn>& columns) {
    const auto find = [&](const auto& matches) -> std::optional<std::size_t> {
        const auto found = std::find_if(columns.begin(), columns.end(), matches);
        return found == columns.end() ? std::nullopt : std::optional<std::size_t>(found - columns.begin());
    };
    if (const auto stamp = find([](const RecordedColumn& each) { return each.name == "timestamp"; })) {
        return stamp;
    }
    return find([](const RecordedColumn& each) {
        constexpr std::array<std::string_view, 6> kNames = {"time",     "seconds",  "t",
                                                            "time (s)", "time [s]", "time_s"};
        return std::find(kNames.begin(), kNames.end(), inLowerCase(each.name)) != kNames.end();
    });
}

bool isOfRobot(const RecordedColumn& column) {
    const std::string_view name = column.name;
    const std::size_t bar = name.rfind('_');
    return name != "timestamp" && (name == kLostColumn || rtde::findOutput(name) != nullptr ||
                                   (bar != std::string_view::npos && bar + 2 == name.size() &&
                                    rtde::findOutput(name.substr(0, bar)) != nullptr));
}

std::string unitOf(std::string_view name, std::size_t component) {
    const rtde::Field* field = rtde::findOutput(name);
    const std::string_view unit = field == nullptr ? "" : field->unit;
    const std::size_t comma = unit.find(", ");
    if (comma == std::string_view::npos) {
        return std::string(unit);
    }
    // A pose has one unit for its three coordinates and another for its three angles.
    constexpr std::size_t kPlaces = 3;
    return std::string(component < kPlaces ? unit.substr(0, comma) : unit.substr(comma + 2));
}

void addKnowledge(RecordedColumn& column) {
    std::string_view name = column.name;
    std::size_t component = 0;
    const rtde::Field* field = rtde::findOutput(name);
    if (const std::size_t bar = name.rfind('_');
        field == nullptr && bar != std::string_view::npos && bar + 2 == name.size()) {
        field = rtde::findOutput(name.substr(0, bar));
        component = static_cast<std::size_t>(name.back() - '0');
    }
    column.whole = column.whole || column.name == kLostColumn;
    if (field == nullptr) {
        return;
    }
    if (column.unit.empty()) {
        column.unit = unitOf(field->name, component);
    }
    column.whole = field->type != rtde::DataType::Double && field->type != rtde::DataType::Vector3D &&
                   field->type != rtde::DataType::Vector6D;
}

}  // namespace tiller::recording
