// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The button "Go to (hold)". The arm moves to a waypoint while the button or the key G is held. HoldRules
// determines when the motion ends. G works anywhere in the window except in text fields.

#include <functional>

#include "robot/station/link/motion_port.h"
#include "widgets/hold/hold_to_run_button.h"
#include "widgets/hold/physical_keys.h"

namespace tiller {

class GoToButton : public HoldToRunButton {
    Q_OBJECT

public:
    /// Returns the move for a press. If no move is possible, returns NoSolution with the reason as text for
    /// the operator.
    using Target = std::function<Result<MoveRequest>()>;

    /// policy  the policy of the window; must outlive the button
    GoToButton(MotionPort port, HoldPolicy& policy, Target target, QWidget* parent = nullptr);
    ~GoToButton() override;

    void setState(const SessionState& state);
    void stop(control::StopCause cause) { guard().stop(cause); }

Q_SIGNALS:
    /// A press had no effect for this reason.
    /// passing  true if the reason disappears automatically, e.g. because another button is held
    void refused(const QString& reason, bool passing);

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
    PhysicalKeys key_;  ///< the key G while it is pressed
};

}  // namespace tiller
