// SPDX-License-Identifier: MIT
#include "robot/recording/mcap/robot_state_message.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstring>

#include "robot/recording/detail/column_knowledge.h"
#include "robot/recording/mcap/detail/cdr_stream.h"
#include "robot/recording/recorder.h"

namespace tiller::recording::mcap {

namespace {

constexpr std::size_t kEncapsulation = 4;
constexpr std::size_t kMaxNumbers = 100'000;

struct NumberType {
    std::string_view name;
    rtde::DataType type;
};
constexpr std::array<NumberType, 6> kNumbers = {{{"float64", rtde::DataType::Double},
                                                 {"bool", rtde::DataType::Bool},
                                                 {"uint8", rtde::DataType::UInt8},
                                                 {"uint32", rtde::DataType::UInt32},
                                                 {"uint64", rtde::DataType::UInt64},
                                                 {"int32", rtde::DataType::Int32}}};

/// Type of vector components.
rtde::DataType numberType(rtde::DataType type) {
    switch (type) {
        case rtde::DataType::Vector3D:
        case rtde::DataType::Vector6D:
            return rtde::DataType::Double;
        case rtde::DataType::Vector6Int32:
            return rtde::DataType::Int32;
        case rtde::DataType::Vector6UInt32:
            return rtde::DataType::UInt32;
        default:
            return type;
    }
}

std::string_view rosName(rtde::DataType number) {
    const auto found =
        std::find_if(kNumbers.begin(), kNumbers.end(), [&](const auto& n) { return n.type == number; });
    return found->name;
}

std::string lower(std::string_view name) {
    std::string out(name);
    std::transform(out.begin(), out.end(), out.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return out;
}

/// Converts a double to an integer; NaN becomes 0.
template <class T>
T wholeOf(double value) {
    return std::isnan(value) ? T(0) : static_cast<T>(value);
}

std::string_view nextPart(std::string_view& rest, char separator) {
    const std::size_t end = rest.find(separator);
    const std::string_view part = rest.substr(0, end);
    rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
    return part;
}

template <class T>
double numberAt(const char* bytes) {
    T value;
    std::memcpy(&value, bytes, sizeof value);
    return static_cast<double>(value);
}

}  // namespace

RobotStateMessage::RobotStateMessage(const std::vector<std::string>& fields, const receive::Sample& sample) {
    for (const std::string& name : fields) {
        const receive::SampleLayout::Entry* entry = sample.layout->find(name);
        if (entry == nullptr || sample.field(name).empty()) {
            continue;
        }
        parts_.push_back({entry->type, entry->first, entry->count});
        mostBytes_ += entry->count * sizeof(double) + sizeof(double);
        const rtde::Field* known = rtde::findOutput(name);
        definition_ += rosName(numberType(entry->type));
        definition_ += entry->count > 1 ? '[' + std::to_string(entry->count) + ']' : std::string();
        definition_ += ' ' + lower(name);
        if (known != nullptr) {
            definition_ +=
                *known->unit != '\0' ? std::string("  # [") + known->unit + "] " : std::string("  # ");
            definition_ += known->meaning;
        }
        definition_ += '\n';
        names_ += names_.empty() ? name : ',' + name;
    }
    definition_ += std::string("uint64 ") + kLostColumn + "  # packages missing just before this one\n";
    names_ += names_.empty() ? kLostColumn : std::string(",") + kLostColumn;
    mostBytes_ += kEncapsulation + 2 * sizeof(std::uint64_t);
}

void RobotStateMessage::write(const receive::Sample& sample, std::uint64_t lost, std::string& out) const {
    out.resize(mostBytes_);
    eprosima::fastcdr::FastBuffer buffer(out.data(), out.size());
    CdrStream cdr(buffer);
    cdr.serialize_encapsulation();
    for (const Part& part : parts_) {
        const double* values = sample.values.data() + part.first;
        switch (numberType(part.type)) {
            case rtde::DataType::Double:
                cdr.put(values, part.count);
                break;
            case rtde::DataType::Bool:
                cdr << (wholeOf<std::uint8_t>(*values) != 0);
                break;
            case rtde::DataType::UInt8:
                cdr << wholeOf<std::uint8_t>(*values);
                break;
            case rtde::DataType::UInt64:
                cdr << wholeOf<std::uint64_t>(*values);
                break;
            case rtde::DataType::UInt32:
                for (std::size_t i = 0; i < part.count; ++i) {
                    cdr << wholeOf<std::uint32_t>(values[i]);
                }
                break;
            default:
                for (std::size_t i = 0; i < part.count; ++i) {
                    cdr << wholeOf<std::int32_t>(values[i]);
                }
        }
    }
    cdr << lost;
    out.resize(cdr.size());
}

RobotStateLayout::RobotStateLayout(std::string_view definition, std::string_view fieldNames) {
    std::size_t offset = 0;
    while (!definition.empty()) {
        std::string_view line = nextPart(definition, '\n');
        line = line.substr(0, line.find('#'));
        while (!line.empty() && (line.back() == ' ' || line.back() == '\r')) {
            line.remove_suffix(1);
        }
        if (line.empty()) {
            continue;
        }
        std::string_view type = nextPart(line, ' ');
        std::size_t count = 1;
        if (const std::size_t open = type.find('['); open != std::string_view::npos) {
            const std::string_view number = type.substr(open + 1, type.size() - open - 2);
            const auto parsed = std::from_chars(number.data(), number.data() + number.size(), count);
            if (parsed.ec != std::errc() || type.back() != ']') {
                return;
            }
            type = type.substr(0, open);
        }
        const auto known =
            std::find_if(kNumbers.begin(), kNumbers.end(), [&](const auto& n) { return n.name == type; });
        if (known == kNumbers.end() || line.empty() || line.find_first_of(" =") != std::string_view::npos ||
            count > kMaxNumbers || places_.size() + count > kMaxNumbers) {
            return;
        }
        const std::string_view original = nextPart(fieldNames, ',');
        const std::string name(lower(original) == line ? original : line);
        const std::size_t size = rtde::wireSize(known->type);
        offset = (offset + size - 1) / size * size;
        for (std::size_t i = 0; i < count; ++i) {
            Place place;
            place.column.name = count > 1 ? name + '_' + std::to_string(i) : name;
            place.column.whole = known->type != rtde::DataType::Double;
            addKnowledge(place.column);
            place.offset = kEncapsulation + offset;
            place.type = known->type;
            places_.push_back(std::move(place));
            offset += size;
        }
    }
}

double RobotStateLayout::valueAt(const Place& place, std::string_view message) {
    if (place.offset + rtde::wireSize(place.type) > message.size()) {
        return receive::kAbsent;
    }
    const char* const bytes = message.data() + place.offset;
    switch (place.type) {
        case rtde::DataType::Double:
            return numberAt<double>(bytes);
        case rtde::DataType::UInt64:
            return numberAt<std::uint64_t>(bytes);
        case rtde::DataType::UInt32:
            return numberAt<std::uint32_t>(bytes);
        case rtde::DataType::Int32:
            return numberAt<std::int32_t>(bytes);
        default:
            return numberAt<std::uint8_t>(bytes);
    }
}

}  // namespace tiller::recording::mcap
