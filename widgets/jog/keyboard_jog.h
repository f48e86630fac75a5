// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Jogging by keyboard, only while it is armed: a frame stands around the window then, and half a minute
// without a key takes it down again. Keys are followed as PhysicalKeys does: what a key moves is settled by
// its press, and a release or a press that does not fit what is known ends the motion. So does a modifier
// that goes down or up meanwhile, because it stands for another speed or direction, and a key that says the
// opposite of another one.

#include <QMap>
#include <QObject>
#include <QPointer>
#include <QTimer>

#include "widgets/common/hold_guard.h"
#include "widgets/common/physical_keys.h"
#include "widgets/jog/axis_jog.h"

class QFrame;
class QKeyEvent;

namespace tiller {

class KeyboardJog : public QObject {
    Q_OBJECT

public:
    /// window  whose keys count, and that the frame stands around
    KeyboardJog(AxisJog& jog, QWidget& window, QObject* parent = nullptr);
    ~KeyboardJog() override;

    void setClock(const Clock& clock) { clock_ = &clock; }
    /// While armed, this key presses and releases that key of the column.
    void addHoldKey(Qt::Key key, HoldGuard& guard);
    /// Refused while it is locked.
    void setArmed(bool armed);
    /// why  it cannot be armed, as a sentence; empty when it can
    void setLock(const QString& why);
    bool isArmed() const { return armed_; }
    /// Looks whether the half minute is over. A timer does this every second.
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
    void holdKeyPressed(HoldGuard& guard, KeyCode code);
    void keyReleased(int meaning);
    void follow();
    void modifierChanged();
    void tell(HoldNews::Kind kind);
    void forget(control::StopCause cause);
    bool isJogKey(int meaning) const;
    bool isMoving() const;
    bool belongsElsewhere() const;
    Deflection deflection() const;
    void followWindow();

    AxisJog& jog_;
    QWidget& window_;
    const Clock* clock_ = &SteadyClock::shared();
    QTimer idle_;
    QMap<int, HoldGuard*> holdKeys_;
    PhysicalKeys keys_;                  ///< those that jog or hold; their meaning is a Qt::Key, or a turn
    Qt::KeyboardModifiers modifiers_{};  ///< with which the motion was begun
    std::int64_t lastKeyNs_ = 0;
    bool armed_ = false;
    QString lock_;
    QPointer<QFrame> frame_;
};

}  // namespace tiller
