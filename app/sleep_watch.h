// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Tells when this PC is about to sleep, or its session is being locked: nobody watches the arm then.

#include <QObject>

namespace tiller::app {

class SleepWatch : public QObject {
    Q_OBJECT

public:
    /// Listens to the system's login manager and to the screen saver, where there are any; elsewhere the
    /// window's loss of activity and the robot's own time-out have to do.
    explicit SleepWatch(QObject* parent = nullptr);

public Q_SLOTS:
    /// org.freedesktop.login1.Manager.PrepareForSleep
    void onPrepareForSleep(bool begins);
    /// org.freedesktop.login1.Session.Lock
    void onLock();
    /// org.freedesktop.ScreenSaver.ActiveChanged
    void onScreenSaver(bool active);

Q_SIGNALS:
    void operatorLeaves();
};

}  // namespace tiller::app
