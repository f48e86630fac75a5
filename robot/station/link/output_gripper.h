// SPDX-License-Identifier: MIT
#pragma once

// A gripper on one or two digital outputs: reported state, output levels for closing and opening, and
// obstacles. With one output, "on" closes the gripper. With two outputs, one closes and the other opens. A
// command never switches on both outputs at the same time.

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
        QString what;  ///< text for the log
    };

    void choose(const GripperChoice& choice);
    /// Updates the state from the robot. A command that is not confirmed within two seconds is no longer
    /// pending.
    void follow(const SessionState& state, std::int64_t nowNs);
    /// Returns the outputs for closing or opening. The command is pending until the robot reports these
    /// outputs.
    Command command(bool close, std::int64_t nowNs);

    /// Examples: "close requested", "pending…", "unknown".
    QString text() const;
    /// Why the outputs cannot be used to close or open the gripper; empty if they can.
    QString obstacle(const OutputHolders& holders) const;
    /// A sentence if the robot has not confirmed the last command; empty otherwise.
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
