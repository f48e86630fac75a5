// SPDX-License-Identifier: MIT
#pragma once

// Positions in a text file for messages to users.

#include <QByteArray>
#include <QString>

namespace tiller {

/// Line and column of a byte, e.g. "line 12, column 3". Both count from 1.
inline QString placeInText(const QByteArray& text, qsizetype offset) {
    const QByteArray before = text.left(offset);
    const qsizetype line = before.count('\n') + 1;
    const qsizetype column = before.size() - before.lastIndexOf('\n');
    return QStringLiteral("line %1, column %2").arg(line).arg(column);
}

}  // namespace tiller
