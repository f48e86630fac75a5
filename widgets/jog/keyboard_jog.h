// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Jogging by keyboard in armed mode. A frame around the window indicates armed mode, which ends after 30 s
// without a key press, and when an input field receives the focus. PhysicalKeys tracks the keys. The meaning
// of a key is determined when it is pressed. An unexpected press or release ends the motion, and so do keys
// with opposite directions. A changed modifier also ends the motion, because it selects a different speed or
// direction.

#include <QMap>
#include <QObject>
#include <QPointer>
#include <QTimer>
#include <functional>
#include <utility>

#include "widgets/hold/hold_guard.h"
#include "widgets/hold/physical_keys.h"
#include "widgets/jog/axis_jog.h"

class QFrame;
class QKeyEvent;

namespace tiller {

/// Access to the jog column buttons that move one step per press.
struct KeySteps {
    std::function<bool()> chosen;  ///< true if a press makes one step
    /// The button for this direction, or nullptr unless exactly one axis or joint is deflected.
    std::function<HoldGuard*(const Deflection&)> button;
};

class KeyboardJog : public QObject {
    Q_OBJECT

public:
    /// window  receives the keys and displays the frame
    KeyboardJog(AxisJog& jog, QWidget& window, QObject* parent = nullptr);
    ~KeyboardJog() override;

    void setClock(const Clock& clock) { clock_ = &clock; }
    /// In armed mode, pressing and releasing `key` presses and releases the button of `guard`.
    void addHoldKey(Qt::Key key, HoldGuard& guard);
    /// While step mode is selected, motion keys act as presses and releases of buttons in the jog column.
    void setSteps(KeySteps steps) { steps_ = std::move(steps); }
    /// Arms or disarms the keyboard. If the keyboard is locked or the arm cannot move, emits refused()
    /// instead of arming it. Arming takes the focus from an input field.
    void setArmed(bool armed);
    /// why  the reason why the keyboard cannot be armed, as a sentence; empty if it can be armed
    void setLock(const QString& why);
    bool isArmed() const { return armed_; }
    /// Disarms the keyboard after a loss of control, so that a key cannot move the arm right after control is
    /// taken again. A motion that is still active ends first, with its own cause.
    void followControl(bool isInControl);
    /// Checks the timeout of 30 s. Called by a timer every second.
    void checkIdle();

    static constexpr int kIdleSeconds = 30;

Q_SIGNALS:
    void armedChanged(bool armed);
    void refused(const QString& why);
    /// The keyboard was disarmed because an input field received the focus. The jog keys would edit its
    /// value.
    void fieldFocused();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    bool keyEvent(const QKeyEvent& event);
    void jogKeyPressed(const QKeyEvent& event);
    void stepKeyPressed();
    void holdKeyPressed(HoldGuard& guard, KeyCode code);
    void keyReleased(int meaning);
    void follow();
    void modifierChanged();
    void tell(HoldEvent::Kind kind);
    void forget(control::StopCause cause);
    bool isJogKey(int meaning) const;
    bool isMoving() const;
    bool makesSteps() const { return steps_.chosen && steps_.chosen(); }
    bool belongsElsewhere() const;
    Deflection deflection() const;
    void followWindow();

    AxisJog& jog_;
    QWidget& window_;
    const Clock* clock_ = &SteadyClock::shared();
    QTimer idle_;
    QMap<int, HoldGuard*> holdKeys_;
    KeySteps steps_;
    QPointer<HoldGuard> step_;  ///< the button of the newest step
    PhysicalKeys keys_;         ///< jog keys; the meaning is a Qt::Key, possibly with the rotation flag
    Qt::KeyboardModifiers modifiers_{};  ///< modifiers at the start of the motion
    std::int64_t lastKeyNs_ = 0;
    bool armed_ = false;
    QString lock_;
    QPointer<QFrame> frame_;
};

}  // namespace tiller
