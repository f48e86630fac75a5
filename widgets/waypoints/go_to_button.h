// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The key "Go to (hold)": while it or the key G is held the arm moves to a waypoint. The rules are those of
// HoldRules. It listens to G wherever the focus is in its window, except in fields that take text.

#include <functional>

#include "robot/station/link/motion_port.h"
#include "widgets/common/hold_button.h"
#include "widgets/common/physical_keys.h"

namespace tiller {

class GoToButton : public HoldButton {
    Q_OBJECT

public:
    /// The move that a press begins, or why there is none, in words an operator can use (NoSolution).
    using Target = std::function<Result<MoveRequest>()>;

    GoToButton(MotionPort port, Target target, QWidget* parent = nullptr);
    ~GoToButton() override;

    void setState(const SessionState& state);
    /// Ends the motion under way, if any.
    void stop(control::StopCause cause) { guard().stop(cause); }

Q_SIGNALS:
    /// A press moved nothing: why.
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
    PhysicalKeys key_;  ///< the key that holds, while it is down
};

}  // namespace tiller
