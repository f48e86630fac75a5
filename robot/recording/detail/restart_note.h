// SPDX-License-Identifier: MIT
#pragma once

// The event of a recording when its time jumped back, e.g. because the controller was restarted.

#include <QString>

namespace tiller::recording {

inline constexpr int kRestartLevel = 30;  ///< warning
inline constexpr const char* kRestartSource = "recorder";

/// before, after  time stamps of the controller around the restart [s]
inline QString restartText(double before, double after) {
    return QStringLiteral("The controller was restarted: its time jumped from %1 s to %2 s")
        .arg(before, 0, 'f', 3)
        .arg(after, 0, 'f', 3);
}

/// before, after  time stamps around the step [s]
inline QString stepBackText(double before, double after) {
    return QStringLiteral("The time runs backwards from %1 s to %2 s: a new segment begins")
        .arg(before, 0, 'f', 3)
        .arg(after, 0, 'f', 3);
}

}  // namespace tiller::recording
