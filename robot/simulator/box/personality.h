// SPDX-License-Identifier: MIT
#pragma once

// Identity of a simulated controller: software release and serial number, the same on every interface.

#include <QString>
#include <optional>
#include <string>

#include "robot/core/result.h"
#include "robot/core/robot_model.h"
#include "robot/core/version.h"

namespace tiller::simulator {

/// Returns a release by its number: "5.22", "3.15.8", "10.12.0.123". Missing parts are taken from the best known
/// release of that series, if any.
/// Errors  InvalidArgument, with the reason
Result<SoftwareVersion> parseSoftware(const QString& text);
/// The default release of a model.
SoftwareVersion defaultSoftware(RobotModelId model);
/// Whether this arm runs that software.
/// Errors  InvalidArgument, with the reason
Result<void> checkSoftware(RobotModelId model, const SoftwareVersion& software);

/// Four numbers with dots.
std::string versionText(const SoftwareVersion& software);
/// Of the release, as `PolyscopeVersion` gives it: "Mar 22 2022".
std::string releaseDate(const SoftwareVersion& software);
/// Of the same day, as the primary interface's version message gives it: "22-03-2022, 00:00:00".
std::string buildDate(const SoftwareVersion& software);
/// Digits beginning with 20, different for each model.
QString serialNumber(RobotModelId model, const SoftwareVersion& software);

}  // namespace tiller::simulator
