// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The rules for starting and ending hold-to-run motions. They apply to on-screen buttons that are held by the
// mouse, a finger or a key of the keyboard (HoldGuard), and to jogging by keyboard, gamepad or SpaceMouse
// without an on-screen button (AxisJog). Each rule is a row of a table in hold_rules.cpp. The first row that
// applies ends the motion and sets the cause. Conditions that only the owner can detect (another selection, a
// lost device, system sleep) end the motion directly.
//
// Evidence that the input is still held:
// - mouse button or keyboard key: the events of the window and, where available, a query of the display
// server (KeyStateProbe) within the last 100 ms;
// - finger on the screen, gamepad, SpaceMouse: their events. A finger or stick that is held still may send no
// events. The motion then continues for at most 25 mm or 15 deg, and for 100 ms to 2 s
// (HoldBounds::holdTimeoutNs). After that, the operator must press again. The limit is 100 ms for a stick
// whose driver reports continuously.

#include <QAbstractNativeEventFilter>
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
#include "widgets/hold/physical_keys.h"

class QWidget;

namespace tiller {

class HoldRules;
class KeyStateProbe;

/// The input that holds a motion.
struct HoldSource {
    enum class By {
        Mouse,   ///< left mouse button
        Touch,   ///< one finger
        Keys,    ///< keys of the keyboard
        Device,  ///< a gamepad or a SpaceMouse
        Nobody,  ///< a short step that runs to its end without being held
    };
    By by = By::Mouse;
    QList<KeyCode> keys = {};  ///< By::Keys: every key that holds the motion
};

/// Settings and state shared by all hold-to-run buttons of a window. The window owns the policy, which
/// outlives the buttons.
struct HoldPolicy {
    KeyStateProbe* witness = nullptr;  ///< key-state check; null if not available
    /// Maximum duration of a motion without a defined end [ns].
    std::int64_t longestNs = kUsualLongestNs;
    /// The active hold. Only one hold is permitted at a time.
    HoldRules* holding = nullptr;

    /// Ends the active hold, if any.
    void stop(control::StopCause cause);

    static constexpr std::int64_t kUsualLongestNs = 20 * kNsPerSecond;
};

/// An event that the rules check while a motion is held.
struct HoldEvent {
    enum class Kind {
        Event,         ///< any event of the application
        NativeFocus,   ///< the display server gave the input focus to another window
        NativeHide,    ///< the display server hid the window
        Application,   ///< the state of the application changed
        LetGo,         ///< the key, button or finger was released
        PointerAt,     ///< position of the pointer or finger in coordinates of the button
        PressedAgain,  ///< a second finger or another button was pressed
        OtherKey,      ///< another key of the keyboard was pressed
        Modifier,      ///< a modifier of the keyboard was pressed or released
        Unmatched,     ///< a key was pressed or released contrary to its recorded state
        Refresh,       ///< 20 ms have elapsed
        Input,         ///< the input device was read
    };
    Kind kind = Kind::Event;
    QObject* watched = nullptr;
    QEvent* event = nullptr;
    QPoint position = {};
    Qt::ApplicationState state = Qt::ApplicationActive;
};

/// Threads  GUI
class HoldRules : public QObject, public QAbstractNativeEventFilter {
    Q_OBJECT

public:
    /// policy  must outlive the object
    /// stop    ends the motion; called with the cause when a rule applies
    HoldRules(HoldPolicy& policy, std::function<void(control::StopCause)> stop,
              const Clock& clock = SteadyClock::shared(), QObject* parent = nullptr);
    ~HoldRules() override;

    void setClock(const Clock& clock) { clock_ = &clock; }

    /// Returns the reason why no motion may start, as a sentence; empty if a motion may start.
    /// key  the pressed button; null if the input is not an on-screen button
    QString obstacle(const QWidget* key, const HoldSource& grip) const;

    /// Ends a motion that another input holds, because simultaneous inputs are not permitted. Call this when
    /// this input requests a motion.
    void endOther();

    /// Activates the rules until end(). Call this when a motion has started.
    void begin(QWidget* key, const HoldSource& grip, const HoldBounds& bounds);
    /// Deactivates the rules. Call this when the motion has ended.
    void end();
    /// Ends an active motion with this cause.
    void stop(control::StopCause cause);
    bool isActive() const { return active_; }

    /// Checks the event against all rules and ends the motion if a rule applies.
    /// Returns  true if the motion was ended
    bool happen(const HoldEvent& news);
    bool happen(HoldEvent::Kind kind) { return happen(HoldEvent{kind}); }
    /// Restarts the timeout of the input. Call this for every event from the finger or the device.
    void heard() { heardNs_ = clock_->nowNs(); }
    /// Replaces the set of keys that hold the motion.
    void setKeys(const QList<KeyCode>& keys);
    void setHoldTimeout(std::int64_t ns) { bounds_.holdTimeoutNs = ns; }
    const HoldSource& grip() const { return grip_; }

    /// Time until the maximum hold duration is reached [ns].
    std::int64_t leftNs() const;
    /// True in the last quarter of the maximum hold duration.
    bool isNearLimit() const;
    /// Extends the maximum hold duration if less than this time is left [ns].
    void extend(std::int64_t leftNs);

    /// The names of all rules, including the conditions for starting a motion.
    static QStringList names();

    /// Period of the refresh [ms].
    static constexpr int kRefreshMs = 20;
    /// Maximum distance of the pointer from the button [px].
    static constexpr int kPointerSlack = 30;

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    bool nativeEventFilter(const QByteArray& type, void* message, qintptr* result) override;

private:
    struct HoldRuleTable;
    struct HeldKey {
        KeyCode code = 0;
        std::int64_t sinceNs = 0;
    };

    std::int64_t now() const { return clock_->nowNs(); }
    std::int64_t longestNs() const { return bounds_.longestNs != 0 ? bounds_.longestNs : policy_.longestNs; }
    bool hasKeyStateProbe(const HoldSource& grip) const;
    template <class Test>
    bool anyKeyState(const Test& test) const;
    control::StopCause hiddenCause() const;

    HoldPolicy& policy_;
    std::function<void(control::StopCause)> stop_;
    const Clock* clock_;
    bool active_ = false;
    QPointer<QWidget> key_;
    QPointer<QWidget> window_;
    HoldSource grip_;
    HoldBounds bounds_;
    QList<HeldKey> keys_;
    std::int64_t beganNs_ = 0;
    std::int64_t refreshedNs_ = 0;
    std::int64_t heardNs_ = 0;
};

}  // namespace tiller
