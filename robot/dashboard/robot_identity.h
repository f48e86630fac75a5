// SPDX-License-Identifier: MIT
#pragma once

// Identification of the arm for recordings and reports.

#include <QString>

#include "robot/core/deadline.h"
#include "robot/core/text.h"

namespace tiller::dashboard {

struct RobotIdentity {
    QString model;         ///< e.g. "UR5e"; empty: unknown
    QString serialNumber;  ///< empty: unknown
};

/// Queries the primary interface, then the dashboard server. Values not received in time remain empty.
/// portOffset  added to every port number
/// isCb3       from the version of the controller
/// Threads  any. Blocks: until both have replied, at most until the deadline
RobotIdentity askIdentity(const Text& host, int portOffset, bool isCb3, const Deadline& deadline);

}  // namespace tiller::dashboard
