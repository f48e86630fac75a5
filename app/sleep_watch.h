// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Detects that this PC is about to sleep or that its session is being locked, because the arm is then
// unattended.

#include <QObject>

namespace tiller::app {

class SleepWatch : public QObject {
    Q_OBJECT

public:
    /// Monitors the login manager and the screen saver, if available. On other systems, window deactivation
    /// and the timeout of the robot stop the arm.
    explicit SleepWatch(QObject* parent = nullptr);

public Q_SLOTS:
    /// Handles the D-Bus signal org.freedesktop.login1.Manager.PrepareForSleep.
    void onPrepareForSleep(bool begins);
    /// Handles the D-Bus signal org.freedesktop.login1.Session.Lock.
    void onLock();
    /// Handles the D-Bus signal org.freedesktop.ScreenSaver.ActiveChanged.
    void onScreenSaver(bool active);

Q_SIGNALS:
    void operatorLeaves();
};

}  // namespace tiller::app
