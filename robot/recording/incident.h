// SPDX-License-Identifier: MIT
#pragma once

// Finds the time of the incident in an incident recording.

#include <optional>

#include "robot/recording/recording.h"

namespace tiller::recording {

// Metadata keys of an incident file.
inline constexpr const char* kIncidentFact = "incident";                ///< reason, e.g. "protective-stop"
inline constexpr const char* kIncidentUtcFact = "incident_utc_ns";      ///< time of arrival [ns since 1970]
inline constexpr const char* kIncidentTimeFact = "incident_timestamp";  ///< controller time [s]

/// Time of the stop or alarm that caused an incident file, on the time axis of the recording [s]. Uses the
/// row with the stored controller time or, without such a row, the arrival time. Empty: not an incident file,
/// or no time stored.
/// Errors  those of Recording
Result<std::optional<double>> incidentMoment(const Recording& recording);

}  // namespace tiller::recording
