// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Jogging by keyboard in armed mode. Armed mode is indicated by a frame around the window and ends after 30 s
// without a key press. PhysicalKeys tracks the keys. The meaning of a key is determined when it is pressed.
// An unexpected press or release ends the motion. Keys with opposite directions also end it. A change of a
// modifier ends it as well, because it selects another speed or direction.

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

/// The buttons of the jog column that make one step for each press.
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
    /// In armed mode, this key presses and releases this button of the jog column.
    void addHoldKey(Qt::Key key, HoldGuard& guard);
    /// While steps are chosen, a motion key presses and releases a button of the jog column.
    void setSteps(KeySteps steps) { steps_ = std::move(steps); }
    /// The keyboard is not armed while it is locked or the arm cannot move; refused() then contains the reason.
    void setArmed(bool armed);
    /// why  the reason why the keyboard cannot be armed, as a sentence; empty if it can be armed
    void setLock(const QString& why);
    bool isArmed() const { return armed_; }
    /// Checks the timeout of 30 s. Called by a timer every second.
    void checkIdle();

    static constexpr int kIdleSeconds = 30;

Q_SIGNALS:
    void armedChanged(bool armed);
    void refused(const QString& why);

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
    PhysicalKeys keys_;  ///< motion and hold keys; the meaning is a Qt::Key, possibly with a rotation flag
    Qt::KeyboardModifiers modifiers_{};  ///< modifiers at the start of the motion
    std::int64_t lastKeyNs_ = 0;
    bool armed_ = false;
    QString lock_;
    QPointer<QFrame> frame_;
};

}  // namespace tiller
