// SPDX-License-Identifier: MIT
#pragma once

// The documented commands of the dashboard server that DashboardClient does not have itself: program and
// installation, pendant, identity, operational mode, reports. Threads, blocking and errors are the client's.

#include "robot/core/text.h"
#include "robot/dashboard/dashboard_client.h"

namespace tiller::dashboard {

using tiller::operator<<;  // for the enumerations below

enum class UserRole { Programmer, Operator, None, Locked, Restricted };
enum class OperationalMode { None, Manual, Automatic };

struct SavedState {
    bool saved = false;
    QString program;  ///< empty when none is loaded
};

// Programs
Result<bool> isRunning(DashboardClient& client, const Deadline& deadline);
/// Full path; empty when none is loaded.
Result<QString> loadedProgram(DashboardClient& client, const Deadline& deadline);
Result<SavedState> isProgramSaved(DashboardClient& client, const Deadline& deadline);
/// Leaves the robot in POWER_OFF.
Result<void> loadInstallation(DashboardClient& client, const Text& path, const Deadline& deadline);

// Safety. Source: safetystatus tells causes apart that safetymode does not; since 3.11 / 5.4
Result<SafetyMode> safetyStatus(DashboardClient& client, const Deadline& deadline);

// Pendant and log
Result<void> saveLog(DashboardClient& client, const Deadline& deadline);  ///< since 3.13 / 5.8
/// CB3 only, as userRole().
Result<void> setUserRole(DashboardClient& client, UserRole role, const Deadline& deadline);
Result<UserRole> userRole(DashboardClient& client, const Deadline& deadline);

// Identity and modes
Result<QString> version(DashboardClient& client, const Deadline& deadline);  ///< the bare number; e-Series
/// e-Series. While it is set from here the pendant cannot change it, until it is cleared.
Result<void> setOperationalMode(DashboardClient& client, OperationalMode mode, const Deadline& deadline);
Result<OperationalMode> operationalMode(DashboardClient& client, const Deadline& deadline);  ///< since 5.6
Result<void> clearOperationalMode(DashboardClient& client, const Deadline& deadline);

// Reports; since 3.13 / 5.8. They take minutes.
enum class FlightReport { Controller, Software, System };
/// Returns  the report's id
Result<QString> generateFlightReport(DashboardClient& client, FlightReport kind, const Deadline& deadline);
/// directory  below the programs folder, "." for itself
/// Returns    the file's name
Result<QString> generateSupportFile(DashboardClient& client, const Text& directory, const Deadline& deadline);

// The end
Result<void> quit(DashboardClient& client, const Deadline& deadline);  ///< closes the connection
/// Switches controller and arm off.
Result<void> shutdown(DashboardClient& client, const Deadline& deadline);

}  // namespace tiller::dashboard
