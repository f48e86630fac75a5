// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Connects a key on the screen with the motion that runs while the key is held. Each guard belongs to one
// key. It starts the motion on a press, refreshes it as long as no rule of HoldRules applies, and then ends
// it. A stopped motion needs a new press.

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
    /// key     the held widget; must outlive the guard
    /// policy  the one of the window; must outlive the guard
    /// clock   used for all time measurements
    HoldGuard(QWidget& key, HoldPolicy& policy, const Clock& clock = SteadyClock::shared());
    ~HoldGuard() override;

    /// True for a key with a guard: a press that stops another motion must not start one there.
    static bool isHoldKey(const QObject& widget);

    void setMotion(HoldMotion motion);
    void setClock(const Clock& clock);

    bool active() const { return rules_.isActive(); }

    /// Handles a press of the key. Returns false if no motion was started; refused() then reports the reason.
    bool press(const HoldSource& grip = {});
    /// Handles the release of the key.
    void release();
    /// Handles a move of the pointer or finger on the pressed key; coordinates of the key.
    void pointerMoved(const QPoint& position);
    /// Forwards an event of the keyboard that the key itself does not receive.
    void tell(HoldEvent::Kind kind) { rules_.happen(kind); }
    /// Ends the motion if one is active.
    void stop(control::StopCause cause);
    /// One refresh: calls hold(). Called by a timer every 20 ms; tests with virtual time call it directly.
    void pump();

    /// Time left until the maximum hold duration [ns].
    std::int64_t leftNs() const { return rules_.leftNs(); }

    /// Period of the refresh [ms].
    static constexpr int kRefreshMs = HoldRules::kRefreshMs;
    /// Holding for less than this time [ns] counts as a click.
    static constexpr std::int64_t kClickNs = 400 * kNsPerMs;

Q_SIGNALS:
    void began();
    /// cause  None: the motion ended without a rule (it arrived, or the session or the robot stopped it)
    void ended(tiller::control::StopCause cause);
    /// A press started no motion; the error contains the reason.
    void refused(const tiller::Error& error);
    /// A key that has to be held until the arm arrives was released immediately, like a click.
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
    bool hasEnd_ = false;  ///< the motion ends by itself if it is held long enough
};

}  // namespace tiller
