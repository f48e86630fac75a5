// SPDX-License-Identifier: MIT
#pragma once

// The metadata of a recording: the robot, and what the user states about the experiment, such as the operator
// or the sample.

#include <QString>
#include <map>
#include <string>
#include <string_view>

#include "robot/core/result.h"

namespace tiller::recording {

/// Values by name, e.g. "model", "serial_number", "operator".
using Metadata = std::map<std::string, std::string>;

/// True for 1 to 60 letters, digits, spaces and _ - . that begin and end with no space.
bool isMetadataName(std::string_view name);
/// True for the names that the recorder or a file format uses.
bool isReservedMetadataName(std::string_view name);
inline constexpr qsizetype kMaxMetadataValue = 10'000;  ///< maximum length of a value
/// Adds an entry of the user, "name=value" or "name: value". An earlier entry with the same name is replaced.
/// Errors  InvalidArgument: the entry has a different format, or the recorder uses its name
Result<void> addMetadata(Metadata& metadata, const QString& entry);

}  // namespace tiller::recording
