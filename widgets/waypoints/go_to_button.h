// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The button "Go to (hold)": while it or the key G is held, the arm moves to a waypoint. The rules are those of
// HoldRules. G works anywhere in the window except in text fields.

#include <functional>

#include "robot/station/link/motion_port.h"
#include "widgets/hold/hold_to_run_button.h"
#include "widgets/hold/physical_keys.h"

namespace tiller {

class GoToButton : public HoldToRunButton {
    Q_OBJECT

public:
    /// Returns the move for a press, or the reason why no move is possible, as text for the operator
    /// (NoSolution).
    using Target = std::function<Result<MoveRequest>()>;

    /// policy  the one of the window; must outlive the button
    GoToButton(MotionPort port, HoldPolicy& policy, Target target, QWidget* parent = nullptr);
    ~GoToButton() override;

    void setState(const SessionState& state);
    /// Ends an active motion.
    void stop(control::StopCause cause) { guard().stop(cause); }

Q_SIGNALS:
    /// A press had no effect, with the reason.
    void refused(const QString& reason);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    Result<MotionPort::Id> begin();
    bool takeKey(const QKeyEvent& key);

    MotionPort port_;
    Target target_;
    SessionState state_;
    HoldBounds bounds_;
    PhysicalKeys key_;  ///< the held key, while it is down
};

}  // namespace tiller
