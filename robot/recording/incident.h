// SPDX-License-Identifier: MIT
#pragma once

// What a recording of an incident tells beside its rows: the moment it was made for.

#include <optional>

#include "robot/recording/recording.h"

namespace tiller::recording {

// The facts of an incident file.
inline constexpr const char* kIncidentFact = "incident";            ///< why: "protective-stop"
inline constexpr const char* kIncidentUtcFact = "incident_utc_ns";  ///< when it arrived [ns since 1970]
inline constexpr const char* kIncidentTimeFact =
    "incident_timestamp";  ///< when, by the controller's clock [s]

/// The stop or alarm that an incident file was made for, on the recording's time axis [s]: the very row by the
/// controller's clock, or, in a file that does not tell it, the arrival. Nothing: it is no incident, or says no time.
/// Errors  those of Recording
Result<std::optional<double>> incidentMoment(const Recording& recording);

}  // namespace tiller::recording
