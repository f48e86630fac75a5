// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Screenshots of the tested widgets, for review.

#include <QDir>
#include <QString>
#include <QTest>
#include <QWidget>

namespace tiller::test {

/// Saves a screenshot as TILLER_SCREENSHOTS/<name>.png. Has no effect without this environment variable.
inline void keepPicture(QWidget& widget, const QString& name) {
    const QString folder = qEnvironmentVariable("TILLER_SCREENSHOTS");
    if (!folder.isEmpty()) {
        QDir().mkpath(folder);
        QVERIFY(widget.grab().save(QStringLiteral("%1/%2.png").arg(folder, name)));
    }
}

}  // namespace tiller::test
