// SPDX-License-Identifier: MIT
#pragma once

// A program of the user's with a watchdog thread in it: the program ends, and with it every motion, when its
// client no longer sends a heartbeat. Without the thread a program runs on after its client has been killed.

#include <QString>
#include <chrono>
#include <cstdint>
#include <optional>
#include <vector>

#include "robot/core/version.h"

namespace tiller::script {

/// Input registers through which a client shows a running program that it is alive.
struct Heartbeat {
    int number = 0;  ///< integer register: a different number with every packet
    /// Value of another integer register.
    struct Expected {
        int number = 0;
        std::int32_t value = 0;
    };
    /// The heartbeat counts only while this register has this value: another client sends another one.
    std::optional<Expected> session = {};
    /// A larger number in this register ends the program at once.
    std::optional<Expected> lastEpoch = {};
    /// Output register that is 0 from the beginning of the program and gets this value when no heartbeat has come:
    /// how a client that is still there learns why the program ended.
    std::optional<Expected> expired = {};
    std::chrono::milliseconds timeout{0};  ///< without a heartbeat the program ends after this time
};

struct SupervisedProgram {
    QString text;
    QString name;  ///< of the first program in it, in the controller's messages; may be empty
    /// For each line of `text` that of the user's text, counted from 1; 0 for an inserted one. Empty: the same.
    std::vector<int> lines;
    /// Line of the user's text, counted from 1, for a line of `text`; 0 for an inserted line.
    int lineOf(int line) const;
};

/// Inserts the watchdog thread into each `def` at the top level, behind "def name():". Lines outside of a
/// `def` become a program of their own, which runs them one after the other. A `sec` cannot move the arm and
/// stays as it is.
///
/// On expiry the thread calls `halt`. A thread must not call stopj while another one moves the arm ("another
/// thread is already controlling the robot"), and `halt` ends a program from any of its threads. How hard the
/// arm then brakes is up to the controller. `rtde_set_watchdog` does the same half that time later, from outside of
/// the program: for one that lets none of its other threads run.
/// Source   URScript halt, rtde_set_watchdog
SupervisedProgram supervised(const QString& program, const Heartbeat& heartbeat,
                             const SoftwareVersion& version);
/// The watchdog thread on its own, for text that becomes part of a program made elsewhere.
QString watchdogScript(const Heartbeat& heartbeat, const SoftwareVersion& version);
/// The program as it is: it runs on when its client is gone.
SupervisedProgram unsupervised(const QString& program);

/// Names that begin with this belong to the inserted lines.
inline constexpr auto kHeartbeatPrefix = "tiller_heartbeat";

/// URScript for the length of a control period [s].
QString stepTimeText(const SoftwareVersion& version);

}  // namespace tiller::script
