// SPDX-License-Identifier: MIT
#include "robot/project/entity_list.h"

#include <QRegularExpression>

namespace tiller::project {

QString freeName(const QString& wanted, const std::function<bool(const QString&)>& isTaken) {
    if (!isTaken(wanted)) {
        return wanted;
    }
    static const QRegularExpression trailingNumber(QStringLiteral(R"(^(.*\S)\s+(\d{1,6})$)"));
    const QRegularExpressionMatch match = trailingNumber.match(wanted);
    const QString stem = match.hasMatch() ? match.captured(1) : wanted;
    for (int number = match.hasMatch() ? match.captured(2).toInt() + 1 : 2;; ++number) {
        const QString name = QStringLiteral("%1 %2").arg(stem).arg(number);
        if (!isTaken(name)) {
            return name;
        }
    }
}

}  // namespace tiller::project
