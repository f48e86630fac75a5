// SPDX-License-Identifier: MIT
#include "robot/core/typed_number.h"

#include <QLocale>

namespace tiller {

QString plainNumber(QString typed) {
    return typed.replace(QChar(0x2212), QLatin1Char('-'))
        .replace(QLocale().decimalPoint(), QStringLiteral("."))
        .replace(QLatin1Char(','), QLatin1Char('.'));
}

std::optional<double> typedNumber(const QString& typed) {
    QLocale plain = QLocale::c();
    plain.setNumberOptions(QLocale::RejectGroupSeparator);
    bool isNumber = false;
    const double number = plain.toDouble(plainNumber(typed.trimmed()), &isNumber);
    return isNumber ? std::optional(number) : std::nullopt;
}

}  // namespace tiller
