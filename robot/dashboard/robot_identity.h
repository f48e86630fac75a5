// SPDX-License-Identifier: MIT
#pragma once

// Which arm this is, as far as a controller tells: for recordings and reports.

#include <QString>

#include "robot/core/deadline.h"
#include "robot/core/text.h"

namespace tiller::dashboard {

struct RobotIdentity {
    QString model;         ///< "UR5e"; empty: not told
    QString serialNumber;  ///< empty: not told
};

/// Asks primary interface and dashboard one after the other; what either does not tell in time stays empty.
/// portOffset  added to every port number
/// isCb3       the series, which the controller's version tells
/// Threads  any. Blocks: until both have answered, the deadline at most
RobotIdentity askIdentity(const Text& host, int portOffset, bool isCb3, const Deadline& deadline);

}  // namespace tiller::dashboard
