// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Jogging by keyboard, only while it is armed: a frame stands around the window then, and half a minute
// without a key takes it down again.

#include <QMap>
#include <QObject>
#include <QPointer>
#include <QSet>
#include <QTimer>

#include "widgets/common/hold_guard.h"
#include "widgets/jog/axis_jog.h"

class QFrame;

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
    void setArmed(bool armed);
    bool isArmed() const { return armed_; }
    /// Looks whether the half minute is over. A timer does this every second.
    void checkIdle();

    static constexpr int kIdleSeconds = 30;

Q_SIGNALS:
    void armedChanged(bool armed);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    bool keyEvent(QEvent* event);
    void holdEvent(HoldGuard& guard, bool press);
    void letGo(control::StopCause cause);
    bool isJogKey(int key) const;
    Deflection deflection() const;
    void followWindow();

    AxisJog& jog_;
    QWidget& window_;
    const Clock* clock_ = &SteadyClock::shared();
    QTimer idle_;
    QMap<int, HoldGuard*> holdKeys_;
    QSet<int> down_;  ///< keys that are held, by Qt::Key
    std::int64_t lastKeyNs_ = 0;
    bool armed_ = false;
    QPointer<QFrame> frame_;
};

}  // namespace tiller
