// SPDX-License-Identifier: MIT
#pragma once

// A gripper on one or two digital outputs: its reported state, the outputs for closing and opening, and reasons
// that prevent them. With one output, on closes; with two, one closes and the other opens, never both.

#include <QCoreApplication>
#include <QString>
#include <cstdint>
#include <optional>

#include "robot/station/link/gripper_choice.h"
#include "robot/station/link/io_commands.h"
#include "robot/station/link/session_state.h"

namespace tiller {

class OutputGripper {
    Q_DECLARE_TR_FUNCTIONS(OutputGripper)

public:
    struct Command {
        std::uint32_t mask = 0;
        std::uint32_t values = 0;
        QString what;  ///< for the log
    };

    void choose(const GripperChoice& choice);
    /// Takes the reported state. Commands without confirmation after two seconds are no longer pending.
    void follow(const SessionState& state, std::int64_t nowNs);
    /// Outputs for closing or opening; pending until the robot reports them.
    Command command(bool close, std::int64_t nowNs);

    /// "close requested", "pending…", "unknown"
    QString text() const;
    /// Why it cannot be closed or opened, of the outputs themselves; empty when it can.
    QString obstacle(const OutputHolders& holders) const;
    /// The newest command, when the robot did not confirm it, as a sentence; else empty.
    const QString& complaint() const { return complaint_; }

private:
    enum class Hand { Unknown, Open, Closed, Neither, Both };
    struct Pending {
        Hand wanted = Hand::Unknown;
        std::int64_t sinceNs = 0;
    };

    bool hasTwo() const { return choice_.kind == GripperChoice::Kind::TwoOutputs; }
    Hand handIn(const SessionState& state) const;

    GripperChoice choice_;
    Hand hand_ = Hand::Unknown;
    std::optional<Pending> pending_;
    QString complaint_;
};

}  // namespace tiller
