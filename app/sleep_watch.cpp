// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/sleep_watch.h"

#ifdef TILLER_HAS_DBUS
#include <QDBusConnection>
#endif

namespace tiller::app {

SleepWatch::SleepWatch(QObject* parent) : QObject(parent) {
    setObjectName("sleepWatch");
#ifdef TILLER_HAS_DBUS
    // An empty path or service matches any sender. Without a bus, connect() has no effect.
    QDBusConnection::systemBus().connect(
        QStringLiteral("org.freedesktop.login1"), {}, QStringLiteral("org.freedesktop.login1.Manager"),
        QStringLiteral("PrepareForSleep"), this, SLOT(onPrepareForSleep(bool)));
    QDBusConnection::systemBus().connect(QStringLiteral("org.freedesktop.login1"), {},
                                         QStringLiteral("org.freedesktop.login1.Session"),
                                         QStringLiteral("Lock"), this, SLOT(onLock()));
    QDBusConnection::sessionBus().connect({}, {}, QStringLiteral("org.freedesktop.ScreenSaver"),
                                          QStringLiteral("ActiveChanged"), this, SLOT(onScreenSaver(bool)));
#endif
}

void SleepWatch::onPrepareForSleep(bool begins) {
    if (begins) {
        Q_EMIT operatorLeaves();
    }
}

void SleepWatch::onLock() {
    Q_EMIT operatorLeaves();
}

void SleepWatch::onScreenSaver(bool active) {
    if (active) {
        Q_EMIT operatorLeaves();
    }
}

}  // namespace tiller::app

#include "moc_sleep_watch.cpp"
