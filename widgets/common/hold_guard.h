// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What stands between a key on the screen and the motion it holds. A guard belongs to one key; it begins the
// motion at a press, keeps it alive while the rule book (HoldRules) finds nothing, and ends it for good at
// the first thing that is not plain holding: a stopped motion needs a new press.

#include <QObject>
#include <QPoint>
#include <QTimer>
#include <cstdint>

#include "robot/core/clock.h"
#include "robot/core/result.h"
#include "robot/station/link/hold_motion.h"
#include "widgets/common/hold_rules.h"

class QWidget;

namespace tiller {

class HoldGuard : public QObject {
    Q_OBJECT

public:
    /// key    the widget that is held; must outlive the guard
    /// clock  for everything that takes time
    explicit HoldGuard(QWidget& key, const Clock& clock = SteadyClock::shared());
    ~HoldGuard() override;

    /// True for a key that has a guard: the press that stops another motion must not begin one there.
    static bool isHoldKey(const QObject& widget);

    void setMotion(HoldMotion motion);
    void setClock(const Clock& clock);
    /// terms  must outlive the guard
    void setTerms(HoldTerms& terms);

    bool active() const { return rules_.isActive(); }

    /// The key was pressed. Returns false when no motion began; refused() then says why.
    bool press(const Grip& grip = {});
    /// The key was let go.
    void release();
    /// The pointer or the finger is at this place of the key while it is pressed.
    void pointerMoved(const QPoint& position);
    /// The keyboard that holds the key says something the key itself does not see.
    void tell(HoldNews::Kind kind) { rules_.happen(kind); }
    /// Ends the motion, if there is one.
    void stop(control::StopCause cause);
    /// One refresh: calls hold(). A timer does this every 20 ms; tests in virtual time do it themselves.
    void pump();

    /// What is left of the longest hold [ns].
    std::int64_t leftNs() const { return rules_.leftNs(); }

    /// Period of the refresh. [ms]
    static constexpr int kRefreshMs = HoldRules::kRefreshMs;
    /// What is let go sooner was a click.
    static constexpr std::int64_t kClickNs = 400 * kNsPerMs;

Q_SIGNALS:
    void began();
    /// cause  None: the motion ended by itself (it arrived, or the session or the robot stopped it)
    void ended(tiller::control::StopCause cause);
    /// A press that moved nothing, and why.
    void refused(const tiller::Error& error);
    /// A key that has to be held until the arm is there was let go at once, as if a click were enough.
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
    bool hasEnd_ = false;  ///< the motion ends by itself, if it is held for long enough
};

}  // namespace tiller
