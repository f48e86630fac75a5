// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Pictures of the widgets under test, for people to look at.

#include <QDir>
#include <QString>
#include <QTest>
#include <QWidget>

namespace tiller::test {

/// Keeps a picture as TILLER_SCREENSHOTS/<name>.png; without that variable it does nothing.
inline void keepPicture(QWidget& widget, const QString& name) {
    const QString folder = qEnvironmentVariable("TILLER_SCREENSHOTS");
    if (!folder.isEmpty()) {
        QDir().mkpath(folder);
        QVERIFY(widget.grab().save(QStringLiteral("%1/%2.png").arg(folder, name)));
    }
}

}  // namespace tiller::test
