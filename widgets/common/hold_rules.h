// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The one rule book by which a held motion begins and, above all, ends: for keys on the screen, held by the
// mouse, a finger or a key of the keyboard (HoldGuard), and for what jogs without one, the armed keyboard, a
// gamepad, a SpaceMouse (AxisJog). Each rule is one row of a table in hold_rules.cpp; the first row that
// applies ends the motion and names the cause. What only the owner can know (another selection, a lost
// device, sleep) it tells by ending the motion itself.
//
// What proves a hold:
// - a mouse button or a key: the events of the window, and the display server as second witness (HoldWitness)
//   where there is one, within the last 100 ms;
// - a finger on the screen, a gamepad, a SpaceMouse: events of its own. A finger or a stick that is held
//   quite still may say nothing for a while; the motion then goes on for at most 25 mm or 15 deg, at least
//   100 ms and at most 2 s (HoldBounds::silenceNs), then it needs a new press. A stick whose driver reports
//   all the time has 100 ms.

#include <QEvent>
#include <QObject>
#include <QPoint>
#include <QPointer>
#include <QStringList>
#include <cstdint>
#include <functional>

#include "robot/control/motion_types.h"
#include "robot/core/clock.h"
#include "robot/station/link/hold_motion.h"
#include "widgets/common/physical_keys.h"

class QWidget;

namespace tiller {

class HoldRules;
class HoldWitness;

/// By what a motion is held.
struct Grip {
    enum class By {
        Mouse,   ///< the left button
        Touch,   ///< one finger
        Keys,    ///< keys of the keyboard
        Device,  ///< a gamepad or a SpaceMouse
        Nobody,  ///< a short step, which runs to its end by itself
    };
    By by = By::Mouse;
    QList<KeyCode> keys = {};  ///< By::Keys: all of them are down
};

/// What holds for all keys of a window. Owned by the window, outlives its keys.
struct HoldTerms {
    HoldWitness* witness = nullptr;  ///< null: there is none
    /// Of motions without an end of their own [ns].
    std::int64_t longestNs = kUsualLongestNs;
    /// The hold under way: there is one hand at a time.
    HoldRules* holding = nullptr;

    static constexpr std::int64_t kUsualLongestNs = 20 * kNsPerSecond;
};

/// Something happened while a motion is held.
struct HoldNews {
    enum class Kind {
        Event,         ///< any event of the application
        Application,   ///< the application's state changed
        LetGo,         ///< the key, button or finger was let go
        PointerAt,     ///< the pointer or finger is here, in the key's coordinates
        PressedAgain,  ///< the same key once more, with a second finger, or another key by another hand
        OtherKey,      ///< another key of the keyboard went down
        Modifier,      ///< a modifier of the keyboard went down or up
        Unmatched,     ///< a press or a release of the keyboard that fits nothing
        Refresh,       ///< 20 ms are over
        Input,         ///< the device was read
    };
    Kind kind = Kind::Event;
    QObject* watched = nullptr;
    QEvent* event = nullptr;
    QPoint position = {};
    Qt::ApplicationState state = Qt::ApplicationActive;
};

/// Threads  GUI
class HoldRules : public QObject {
    Q_OBJECT

public:
    /// stop  ends the motion; called with the cause when a rule applies
    explicit HoldRules(std::function<void(control::StopCause)> stop,
                       const Clock& clock = SteadyClock::shared(), QObject* parent = nullptr);
    ~HoldRules() override;

    void setClock(const Clock& clock) { clock_ = &clock; }
    /// terms  must outlive this
    void setTerms(HoldTerms& terms) { terms_ = &terms; }

    /// Why no motion may begin now, as a sentence; empty when one may.
    /// key  that is held; null where it is none of the screen
    QString obstacle(const QWidget* key, const Grip& grip) const;

    /// This hand asked for a motion. If another one holds one, it ends: two hands at once are no plain holding.
    void endOther();

    /// A motion was begun: from now on the rules hold.
    void begin(QWidget* key, const Grip& grip, const HoldBounds& bounds);
    /// The motion has ended.
    void end();
    bool isActive() const { return active_; }

    /// Looks the news up in the book and ends the motion if a rule applies.
    /// Returns  true when it did
    bool happen(const HoldNews& news);
    bool happen(HoldNews::Kind kind) { return happen(HoldNews{kind}); }
    /// The finger or the device said something of its own.
    void heard() { heardNs_ = clock_->nowNs(); }
    /// Other keys hold from now on.
    void setKeys(const QList<KeyCode>& keys);
    void setSilence(std::int64_t ns) { bounds_.silenceNs = ns; }
    const Grip& grip() const { return grip_; }

    /// What is left of the longest hold [ns].
    std::int64_t leftNs() const;

    /// The names of all rules, those for the beginning included.
    static QStringList names();

    /// Period of the refresh. [ms]
    static constexpr int kRefreshMs = 20;
    /// How far the pointer may leave the key. [px]
    static constexpr int kPointerSlack = 30;
    /// A pause in the refresh, or in what the witness says, after which the motion is given up. [ms]
    static constexpr int kStallMs = 100;

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    struct Book;
    struct HeldKey {
        KeyCode code = 0;
        std::int64_t sinceNs = 0;
    };

    std::int64_t now() const { return clock_->nowNs(); }
    bool isWitnessed(const Grip& grip) const;
    template <class Test>
    bool anyWitnessed(const Test& test) const;
    control::StopCause whyGone() const;

    std::function<void(control::StopCause)> stop_;
    const Clock* clock_;
    HoldTerms own_;
    HoldTerms* terms_ = &own_;
    bool active_ = false;
    QPointer<QWidget> key_;
    QPointer<QWidget> window_;
    Grip grip_;
    HoldBounds bounds_;
    QList<HeldKey> keys_;
    std::int64_t beganNs_ = 0;
    std::int64_t refreshedNs_ = 0;
    std::int64_t heardNs_ = 0;
};

}  // namespace tiller
