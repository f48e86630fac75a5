// SPDX-License-Identifier: MIT
#pragma once

// Messages of the primary interface as bytes: messages shown on the teach pendant, and messages for which
// clients wait.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "robot/core/modes.h"
#include "robot/core/version.h"

namespace tiller::simulator::primary {

using Bytes = std::vector<std::uint8_t>;

enum class ReportLevel : std::int32_t { Debug = 0, Info = 1, Warning = 2, Violation = 3, Fault = 4 };

struct ErrorCode {
    std::int32_t code = 0;
    std::int32_t argument = 0;
    ReportLevel level = ReportLevel::Warning;
    std::string text;
};

inline constexpr const char* kProgramStarted = "PROGRAM_XXX_STARTED";
inline constexpr const char* kProgramStopped = "PROGRAM_XXX_STOPPED";

// In the following functions, `timestampNs` is the controller time.
Bytes version(const SoftwareVersion& software);
Bytes text(std::uint64_t timestampNs, std::string_view text);
Bytes label(std::uint64_t timestampNs, std::int32_t id, std::string_view text);
Bytes key(std::uint64_t timestampNs, std::string_view title, std::string_view text);
Bytes errorCode(std::uint64_t timestampNs, const ErrorCode& error);
Bytes runtimeException(std::uint64_t timestampNs, std::int32_t line, std::int32_t column,
                       std::string_view text);
Bytes safetyMode(std::uint64_t timestampNs, tiller::SafetyMode mode);
/// True for messages created by safetyMode().
bool isSafetyMode(const Bytes& message);

struct PopupMessage {
    std::uint32_t id = 0;
    bool warning = false, error = false, blocking = false;
    std::string title, text;
};
/// kind  requestedType: 0 boolean, 1 integer, 2 float, 3 string
Bytes requestValue(std::uint64_t timestampNs, std::uint32_t id, std::uint32_t kind, std::string_view text);
/// software  before 3.12 and 5.6, the message has neither request ID nor type, as older clients expect
Bytes popup(std::uint64_t timestampNs, const PopupMessage& popup, const SoftwareVersion& software);

}  // namespace tiller::simulator::primary
