// SPDX-License-Identifier: MIT
#pragma once

// Identity of a simulated controller: software release and serial number, identical on every interface.

#include <QString>
#include <optional>
#include <string>

#include "robot/core/result.h"
#include "robot/core/robot_model.h"
#include "robot/core/version.h"

namespace tiller::simulator {

/// Returns a release by its version number, e.g. "5.22", "3.15.8" or "10.12.0.123". Missing parts are taken
/// from the best matching known release of the series, if there is one.
/// Errors  InvalidArgument, with the reason
Result<SoftwareVersion> parseSoftware(const QString& text);
/// The default release of a model.
SoftwareVersion defaultSoftware(RobotModelId model);
/// Checks whether this arm supports this software.
/// Errors  InvalidArgument, with the reason
Result<void> checkSoftware(RobotModelId model, const SoftwareVersion& software);

/// Four numbers separated by dots.
std::string versionText(const SoftwareVersion& software);
/// Date of the release in the format of `PolyscopeVersion`: "Mar 22 2022".
std::string releaseDate(const SoftwareVersion& software);
/// The same date in the format of the primary interface's version message: "22-03-2022, 00:00:00".
std::string buildDate(const SoftwareVersion& software);
/// Serial number: digits starting with 20, different for each model.
QString serialNumber(RobotModelId model, const SoftwareVersion& software);

}  // namespace tiller::simulator
