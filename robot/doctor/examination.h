// SPDX-License-Identifier: MIT
#pragma once

// Looks at everything that has to be right before a robot can be watched and moved from this PC: network,
// ports, protocol, software, modes, registers, data rate. It asks only; it changes nothing on the robot. The
// window's pre-flight page and `tiller-cli doctor` show the same report.

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
    /// SCHED_FIFO priority the receive thread will ask for.
    int priority = 90;
};

/// host        address or name
/// portOffset  added to every port of the controller
Patient patientAt(const Text& host, int portOffset = 0);

/// Runs all conditions in order; one that cannot be looked at because of an earlier one is Skipped.
/// each      called for every finding as it is made, from the calling thread; may be empty
/// Returns   one finding for every condition, also after a cancel (the rest Skipped)
/// Threads   any without events of the user's: call it from a worker. Blocks: some two seconds with a healthy
///           robot, twelve at most; until the deadline at most
Report examine(const Patient& patient, const Deadline& deadline,
               const std::function<void(const Finding&)>& each = {});

}  // namespace tiller::doctor
