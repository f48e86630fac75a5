// SPDX-License-Identifier: MIT
#pragma once

// The documented dashboard commands that are not in DashboardClient: program and installation, pendant,
// identification, operational mode, reports. Threads, blocking and errors: as for DashboardClient.

#include "robot/core/text.h"
#include "robot/dashboard/dashboard_client.h"

namespace tiller::dashboard {

using tiller::operator<<;  // makes the enumerations below printable

enum class UserRole { Programmer, Operator, None, Locked, Restricted };
enum class OperationalMode { None, Manual, Automatic };

struct SavedState {
    bool saved = false;
    QString program;  ///< empty if none is loaded
};

// Programs
Result<bool> isRunning(DashboardClient& client, const Deadline& deadline);
/// Full path; empty if none is loaded.
Result<QString> loadedProgram(DashboardClient& client, const Deadline& deadline);
Result<SavedState> isProgramSaved(DashboardClient& client, const Deadline& deadline);
/// Leaves the robot in POWER_OFF.
Result<void> loadInstallation(DashboardClient& client, const Text& path, const Deadline& deadline);

// Safety. safetystatus distinguishes causes that safetymode does not; since 3.11 / 5.4
Result<SafetyMode> safetyStatus(DashboardClient& client, const Deadline& deadline);

// Pendant and log
Result<void> saveLog(DashboardClient& client, const Deadline& deadline);  ///< since 3.13 / 5.8
/// CB3 only; also applies to userRole().
Result<void> setUserRole(DashboardClient& client, UserRole role, const Deadline& deadline);
Result<UserRole> userRole(DashboardClient& client, const Deadline& deadline);

// Identification and modes
Result<QString> version(DashboardClient& client,
                        const Deadline& deadline);  ///< version number only; e-Series
/// e-Series. A mode set with this function cannot be changed on the teach pendant until it is cleared.
Result<void> setOperationalMode(DashboardClient& client, OperationalMode mode, const Deadline& deadline);
Result<OperationalMode> operationalMode(DashboardClient& client, const Deadline& deadline);  ///< since 5.6
Result<void> clearOperationalMode(DashboardClient& client, const Deadline& deadline);

// Reports; since 3.13 / 5.8. Generating a report takes minutes.
enum class FlightReport { Controller, Software, System };
/// Returns  the id of the report
Result<QString> generateFlightReport(DashboardClient& client, FlightReport kind, const Deadline& deadline);
/// directory  relative to the programs folder, "." for the folder itself
/// Returns    the name of the file
Result<QString> generateSupportFile(DashboardClient& client, const Text& directory, const Deadline& deadline);

// Connection and power
Result<void> quit(DashboardClient& client, const Deadline& deadline);  ///< closes the connection
/// Switches off the controller and the arm.
Result<void> shutdown(DashboardClient& client, const Deadline& deadline);

}  // namespace tiller::dashboard
