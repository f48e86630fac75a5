// SPDX-License-Identifier: MIT
#pragma once

// Checks all prerequisites for monitoring and moving a robot from this PC: network, ports, protocol,
// software, modes, registers, data rate. The checks do not change any setting of the robot. The connection
// check in the window and `tiller-cli doctor` show the same report.

#include <QString>
#include <functional>

#include "robot/core/deadline.h"
#include "robot/core/text.h"
#include "robot/doctor/finding.h"

namespace tiller::doctor {

struct Ports {
    int rtde = 30004;
    int primary = 30001;
    int secondary = 30002;
    int realtime = 30003;
    int dashboard = 29999;
    int robotApi = 80;
};

struct Patient {
    Text host;  ///< address or name
    Ports ports;
    /// SCHED_FIFO priority of the receiver thread
    int priority = 90;
};

/// host        address or name
/// portOffset  added to every port of the controller
Patient patientAt(const Text& host, int portOffset = 0);

/// Checks all conditions in order. Conditions that depend on a failed one are Skipped.
/// each      called in the calling thread with every finding; may be empty
/// Returns   one finding per condition, even after cancellation (conditions not yet checked are Skipped)
/// Threads   any; use a worker, because no events are processed. Blocks: for the resolution of a host name, which
///           the deadline does not limit, and then about 2 s for a healthy robot, at most 17 s and no longer
///           than the deadline
Report examine(const Patient& patient, const Deadline& deadline,
               const std::function<void(const Finding&)>& each = {});

}  // namespace tiller::doctor
