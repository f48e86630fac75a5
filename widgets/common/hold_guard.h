// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The one place with the rules by which a held key moves the arm and, above all, stops it. A guard belongs to
// one key. While its motion runs it watches the key, the window and the whole application, and the first
// thing that is not plain holding ends the motion for good: a stopped motion needs a new press.

#include <QObject>
#include <QPoint>
#include <QTimer>
#include <cstdint>
#include <functional>

#include "robot/control/motion_types.h"
#include "robot/core/clock.h"
#include "robot/core/result.h"

class QWidget;

namespace tiller {

/// What a press begins. RobotSession's beginJog/beginMove, hold and endMotion fit straight in.
struct HoldMotion {
    using Id = std::uint64_t;
    /// Begins the motion, or says why not.
    std::function<Result<Id>()> begin;
    /// Keeps it alive. Returns false once it has been stopped or has arrived.
    std::function<bool(Id)> hold;
    std::function<void(Id, control::StopCause)> end;
    /// Asked at the press: true for a short bounded step, which runs to its end after the key is let go.
    /// Every other rule still ends it. May be empty: then letting go ends the motion.
    std::function<bool()> runsToEnd;
};

class HoldGuard : public QObject {
    Q_OBJECT

public:
    /// key    the widget that is held; must outlive the guard
    /// clock  for noticing that the event loop stood still
    explicit HoldGuard(QWidget& key, const Clock& clock = SteadyClock::shared());
    ~HoldGuard() override;

    /// True for a key that has a guard: the press that stops another motion must not begin one there.
    static bool isHoldKey(const QObject& widget);

    void setMotion(HoldMotion motion);
    void setClock(const Clock& clock);

    bool active() const { return active_; }
    HoldMotion::Id motionId() const { return id_; }

    /// The key was pressed. Returns false when no motion began; refused() then says why.
    bool press();
    /// The key was let go.
    void release();
    /// The pointer is at this place of the key while it is pressed.
    void pointerMoved(const QPoint& position);
    /// Ends the motion, if there is one.
    void stop(control::StopCause cause);
    /// One refresh: calls hold(). A timer does this every 20 ms; tests in virtual time do it themselves.
    void pump();

    /// Period of the refresh. [ms]
    static constexpr int kRefreshMs = 20;
    /// How far the pointer may leave the key. [px]
    static constexpr int kPointerSlack = 30;
    /// A pause in the refresh after which the motion is given up. [ms]
    static constexpr int kStallMs = 100;

Q_SIGNALS:
    void began();
    /// cause  None: the motion ended by itself (it arrived, or the session or the robot stopped it)
    void ended(tiller::control::StopCause cause);
    /// A press that moved nothing, and why.
    void refused(const tiller::Error& error);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void watch(bool on);
    bool filterKey(QEvent* event);
    bool filterSecondPress(QObject* watched, QEvent* event);
    void filterOwnKey(QEvent* event);
    void filterWindow(QObject* watched, QEvent* event);

    QWidget& key_;
    const Clock* clock_;
    HoldMotion motion_;
    QTimer timer_;
    HoldMotion::Id id_ = 0;
    std::int64_t lastPumpNs_ = 0;
    bool active_ = false;
    bool pressed_ = false;
    bool runsToEnd_ = false;
};

}  // namespace tiller
