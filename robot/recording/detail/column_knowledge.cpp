// SPDX-License-Identifier: MIT
#include "robot/recording/detail/column_knowledge.h"

#include "robot/recording/recorder.h"
#include "robot/rtde/fields.h"

namespace tiller::recording {

std::string unitOf(std::string_view name, std::size_t component) {
    const rtde::Field* field = rtde::findOutput(name);
    const std::string_view unit = field == nullptr ? "" : field->unit;
    const std::size_t comma = unit.find(", ");
    if (comma == std::string_view::npos) {
        return std::string(unit);
    }
    // A pose has two units: for its three positions and three angles.
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
