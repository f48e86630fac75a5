// SPDX-License-Identifier: MIT
#include "robot/receive/field_info.h"

#include <algorithm>
#include <array>
#include <unordered_map>

#include "robot/rtde/fields.h"

namespace tiller::receive {

namespace {

struct Modes {
    std::string_view field;
    FieldModes modes;
};
constexpr std::array kModes = {
    Modes{"robot_mode", FieldModes::Robot},      Modes{"safety_mode", FieldModes::Safety},
    Modes{"joint_mode", FieldModes::Joint},      Modes{"safety_status", FieldModes::SafetyStatus},
    Modes{"runtime_state", FieldModes::Runtime}, Modes{"tool_mode", FieldModes::Tool},
};

struct Bits {
    std::string_view field;
    int count;
};
// Source: RTDE guide
constexpr std::array kBits = {
    Bits{"actual_digital_input_bits", 18},
    Bits{"actual_digital_output_bits", 18},
    Bits{"actual_configurable_digital_input_bits", 8},
    Bits{"actual_configurable_digital_output_bits", 8},
    Bits{"robot_status_bits", 4},
    Bits{"safety_status_bits", 12},
    Bits{"analog_io_types", 4},
    Bits{"tool_analog_input_types", 2},
    Bits{"euromap67_input_bits", 32},
    Bits{"euromap67_output_bits", 32},
    Bits{"output_bit_registers0_to_31", 32},
    Bits{"output_bit_registers32_to_63", 32},
    Bits{"input_bit_registers0_to_31", 32},
    Bits{"input_bit_registers32_to_63", 32},
};

/// Units per component. For example, "m, rad" for six values: three in m and three in rad.
std::vector<std::string> unitsOf(std::string_view units, std::size_t components) {
    const std::size_t comma = units.find(", ");
    if (comma == std::string_view::npos) {
        return std::vector<std::string>(components, std::string(units));
    }
    std::vector<std::string> all(components, std::string(units.substr(comma + 2)));
    std::fill_n(all.begin(), components / 2, std::string(units.substr(0, comma)));
    return all;
}

FieldInfo infoOf(const rtde::Field& field) {
    FieldInfo info;
    info.name = field.name;
    info.meaning = field.meaning;
    info.components = static_cast<int>(field.components());
    info.units = unitsOf(field.unit, field.components());
    for (const Modes& row : kModes) {
        if (row.field == info.name) {
            info.kind = FieldKind::Enumeration;
            info.modes = row.modes;
            return info;
        }
    }
    for (const Bits& row : kBits) {
        if (row.field == info.name) {
            info.kind = FieldKind::Bits;
            info.bits = row.count;
            return info;
        }
    }
    switch (field.type) {
        case rtde::DataType::Double:
        case rtde::DataType::Vector3D:
        case rtde::DataType::Vector6D:
            info.kind = FieldKind::Number;
            break;
        case rtde::DataType::Bool:
            info.kind = FieldKind::Bits;
            info.bits = 1;
            break;
        default:
            info.kind = FieldKind::Count;
    }
    return info;
}

const std::vector<FieldInfo>& all() {
    static const std::vector<FieldInfo> kAll = [] {
        std::vector<FieldInfo> infos;
        for (const rtde::Field& field : rtde::outputFields()) {
            infos.push_back(infoOf(field));
        }
        return infos;
    }();
    return kAll;
}

}  // namespace

std::string FieldInfo::componentName(int component) const {
    const rtde::Field* field = rtde::findOutput(name);
    return field == nullptr ? std::string(name)
                            : rtde::componentName(name, field->type, static_cast<std::size_t>(component));
}

bool FieldInfo::isAvailableOn(const SoftwareVersion& version) const {
    const rtde::Field* field = rtde::findOutput(name);
    return field != nullptr && field->isAvailableOn(version);
}

std::span<const FieldInfo> fieldInfos() {
    return all();
}

const FieldInfo* findField(std::string_view name) {
    static const std::unordered_map<std::string_view, const FieldInfo*> kByName = [] {
        std::unordered_map<std::string_view, const FieldInfo*> index;
        for (const FieldInfo& info : all()) {
            index.emplace(info.name, &info);
        }
        return index;
    }();
    const auto found = kByName.find(name);
    return found == kByName.end() ? nullptr : found->second;
}

bool fitsFieldList(const std::vector<std::string>& fields) {
    constexpr std::string_view kTimestamp = "timestamp";
    std::size_t length = kTimestamp.size();
    for (const std::string& field : fields) {
        length += field == kTimestamp ? 0 : 1 + field.size();
    }
    return length <= rtde::kMaxNameListSize;
}

}  // namespace tiller::receive
