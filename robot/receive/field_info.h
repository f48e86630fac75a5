// SPDX-License-Identifier: MIT
#pragma once

// Descriptions of all output fields for the user interface: unit, meaning and interpretation of the values.
// Only the reply of a robot shows whether it has a field, see Receiver::absentFields().

#include <QString>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "robot/core/version.h"

namespace tiller::receive {

enum class FieldKind : std::uint8_t {
    Number,       ///< measured value or target
    Count,        ///< integer
    Enumeration,  ///< one of several modes, see FieldInfo::modes
    Bits,         ///< bit field
};

/// The mode type of an enumeration field.
enum class FieldModes : std::uint8_t { None, Robot, Safety, SafetyStatus, Runtime, Joint, Tool };

struct FieldInfo {
    std::string_view name;     ///< e.g. "actual_q"
    std::string_view meaning;  ///< e.g. "joint positions"
    FieldKind kind = FieldKind::Number;
    FieldModes modes = FieldModes::None;
    int components = 1;              ///< 1, 3 or 6
    std::vector<std::string> units;  ///< per component, e.g. "rad"; empty strings without a unit
    int bits = 0;                    ///< number of defined bits, starting with the lowest

    /// Name in recordings, e.g. "actual_q_0". A field with one component keeps its name.
    std::string componentName(int component) const;
    /// False if this software version is known not to have the field.
    bool isAvailableOn(const SoftwareVersion& version) const;
};

/// All fields, registers last. The span is valid until the program ends.
/// Threads  any
std::span<const FieldInfo> fieldInfos();
/// Returns null if there is no such output field.
const FieldInfo* findField(std::string_view name);

/// True if every controller accepts a request for these fields and `timestamp`, which a receiver adds.
bool fitsFieldList(const std::vector<std::string>& fields);

}  // namespace tiller::receive
