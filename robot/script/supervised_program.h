// SPDX-License-Identifier: MIT
#pragma once

// Adds a watchdog thread to a user program. The thread ends the program, and with it every motion, if the
// client stops sending a heartbeat. Without this thread, a program continues after its client has crashed.

#include <QString>
#include <chrono>
#include <cstdint>
#include <optional>
#include <vector>

#include "robot/core/version.h"
#include "robot/script/step_gate.h"

namespace tiller::script {

/// Input registers for the heartbeat of a client.
struct Heartbeat {
    int number = 0;  ///< integer register whose value differs in every packet
    /// An integer register and a reference value.
    struct Expected {
        int number = 0;
        std::int32_t value = 0;
    };
    /// The heartbeat is valid only while this register has this value, which identifies the client.
    std::optional<Expected> session = {};
    /// A larger value in this register ends the program immediately.
    std::optional<Expected> lastEpoch = {};
    /// The program sets this output register to 0 at the start, and to this value if the heartbeat is
    /// missing, so that a running client can read why the program ended.
    std::optional<Expected> expired = {};
    std::chrono::milliseconds timeout{0};  ///< maximum time without a heartbeat
    /// If set, the program can call the functions of stepGateScript().
    std::optional<GateInputs> gate = {};
};

struct SupervisedProgram {
    QString text;
    QString name;  ///< name of the first program in `text`, for the controller's messages; may be empty
    /// For each line of `text`, its line number in the user's text, counted from 1; 0 for an inserted line.
    /// Empty if the texts are identical.
    std::vector<int> lines;
    /// Line number in the user's text, counted from 1, of a line of `text`; 0 for an inserted line.
    int lineOf(int line) const;
};

/// Inserts the watchdog thread into each top-level `def`, after "def name():". Lines outside any `def` are
/// collected in an additional program. A `sec` cannot move the arm and remains unchanged.
///
/// On expiry, the thread calls `halt`. It cannot call `stopj` while another thread moves the arm ("another
/// thread is already controlling the robot"), whereas any thread of a program can call `halt`. The controller
/// determines the deceleration. `rtde_set_watchdog` has the same effect from outside the program, with a
/// 50 % longer timeout, for programs that block their other threads.
/// Source   URScript halt, rtde_set_watchdog
SupervisedProgram supervised(const QString& program, const Heartbeat& heartbeat,
                             const SoftwareVersion& version);
/// Returns only the watchdog thread, for programs that are assembled elsewhere.
QString watchdogScript(const Heartbeat& heartbeat, const SoftwareVersion& version);
/// Returns the program without a watchdog. The program continues to run without its client.
SupervisedProgram unsupervised(const QString& program);

/// Prefix of all names in the inserted lines.
inline constexpr auto kHeartbeatPrefix = "tiller_heartbeat";

/// URScript expression for the control period [s].
QString stepTimeText(const SoftwareVersion& version);

}  // namespace tiller::script
