// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Connects an on-screen button with the motion that runs while the button is held. Each guard belongs to one
// button. It starts the motion on a press, refreshes it until a rule of HoldRules applies, and then ends it.
// A new press is required to continue.

#include <QObject>
#include <QPoint>
#include <QTimer>
#include <cstdint>

#include "robot/core/clock.h"
#include "robot/core/result.h"
#include "robot/station/link/hold_motion.h"
#include "widgets/hold/hold_rules.h"

class QWidget;

namespace tiller {

class HoldGuard : public QObject {
    Q_OBJECT

public:
    /// key     the hold-to-run button; must outlive the guard
    /// policy  hold policy of the window; must outlive the guard
    /// clock   used for all time measurements
    HoldGuard(QWidget& key, HoldPolicy& policy, const Clock& clock = SteadyClock::shared());
    ~HoldGuard() override;

    /// True for a button with a guard. A press that stops another motion must not also start a motion on such
    /// a button.
    static bool isHoldKey(const QObject& widget);

    void setMotion(HoldMotion motion);
    void setClock(const Clock& clock);

    bool active() const { return rules_.isActive(); }

    /// Starts the motion for a press of the button. Returns false if no motion was started. If there is a
    /// reason, refused() is emitted.
    bool press(const HoldSource& grip = {});
    void release();
    /// Handles a move of the pointer or finger while the button is pressed.
    /// position  in coordinates of the button
    void pointerMoved(const QPoint& position);
    /// Forwards a keyboard event that the button itself does not receive.
    void tell(HoldEvent::Kind kind) { rules_.happen(kind); }
    void stop(control::StopCause cause);
    /// Refreshes the motion once by calling hold(). A timer calls this function every 20 ms. Tests with
    /// virtual time call it directly.
    void pump();

    /// Time until the maximum hold duration is reached [ns].
    std::int64_t leftNs() const { return rules_.leftNs(); }

    /// Period of the refresh [ms].
    static constexpr int kRefreshMs = HoldRules::kRefreshMs;
    /// Holding for less than this time [ns] counts as a click.
    static constexpr std::int64_t kClickNs = 400 * kNsPerMs;

Q_SIGNALS:
    void began();
    /// cause  None if no rule ended the motion, i.e. the arm arrived, or the session or the robot stopped the
    /// motion
    void ended(tiller::control::StopCause cause);
    /// A press did not start a motion. `error` contains the reason.
    void refused(const tiller::Error& error);
    /// A button that must be held until the arm arrives was released within kClickNs.
    void clicked();

private:
    void finish();

    QWidget& key_;
    HoldRules rules_;
    HoldMotion motion_;
    const Clock* clock_;
    QTimer timer_;
    HoldMotion::Id id_ = 0;
    std::int64_t beganNs_ = 0;
    bool pressed_ = false;
    bool runsToEnd_ = false;
    bool pauses_ = false;  ///< true after a call of HoldMotion::pause
    bool hasEnd_ = false;  ///< true if the motion ends automatically while the button is held
};

}  // namespace tiller
