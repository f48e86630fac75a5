// SPDX-License-Identifier: MIT
#pragma once

// What a robot can tell, for those who show it or let somebody choose: every output field with its unit, its meaning
// and what its numbers stand for. Whether a given robot has a field is the robot's to say: Receiver::absentFields().

#include <QString>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "robot/core/version.h"

namespace tiller::receive {

enum class FieldKind : std::uint8_t {
    Number,       ///< measured, or a target
    Count,        ///< a whole number
    Enumeration,  ///< one of some modes, see FieldInfo::modes
    Bits,         ///< a word of bits
};

/// Which modes the numbers of an enumeration are.
enum class FieldModes : std::uint8_t { None, Robot, Safety, SafetyStatus, Runtime, Joint, Tool };

struct FieldInfo {
    std::string_view name;     ///< "actual_q"
    std::string_view meaning;  ///< "joint positions"
    FieldKind kind = FieldKind::Number;
    FieldModes modes = FieldModes::None;
    int components = 1;              ///< 1, 3 or 6
    std::vector<std::string> units;  ///< of each component: "rad"; empty strings where there is none
    int bits = 0;                    ///< how many of a word's bits have a meaning, from the lowest

    /// As recordings name it: "actual_q_0"; a field of one number keeps its name.
    std::string componentName(int component) const;
    /// False: this software is known not to have it.
    bool isAvailableOn(const SoftwareVersion& version) const;
};

/// All of them, registers last. Lives for the whole program.
/// Threads  any
std::span<const FieldInfo> fieldInfos();
/// Null when there is no such output field.
const FieldInfo* findField(std::string_view name);

/// The longest list of fields that any controller takes, their names and the commas between them [bytes].
std::size_t longestFieldList();

}  // namespace tiller::receive
