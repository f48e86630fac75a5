// SPDX-License-Identifier: MIT
#include "robot/station/text/format.h"

#include <QLocale>
#include <algorithm>
#include <cmath>

#include "robot/core/angles.h"

namespace tiller::format {

namespace {

constexpr QChar kMinus(0x2212);

/// Uses the decimal separator of the window language, see LanguageTexts. For display only, not for files.
QString withDecimalSign(QString figure) {
    const QString sign = QLocale().decimalPoint();
    return sign == QLatin1String(".") ? figure : figure.replace(QLatin1Char('.'), sign);
}

/// Values from here on are displayed with an exponent.
constexpr double kLongest = 1e15;
constexpr int kDigitsOfLongest = 7;

/// value  not negative
QString exponentialOf(double value, int significant) {
    QString mantissa = QString::number(value, 'e', significant - 1);
    const qsizetype at = mantissa.indexOf(QLatin1Char('e'));
    const int exponent = mantissa.mid(at + 1).toInt();
    mantissa.truncate(at);
    while (mantissa.contains(QLatin1Char('.')) &&
           (mantissa.back() == QLatin1Char('0') || mantissa.back() == QLatin1Char('.'))) {
        mantissa.chop(1);
    }
    if (value == 0 || exponent == 0) {
        return mantissa;
    }
    return QStringLiteral("%1e%2%3")
        .arg(mantissa, exponent < 0 ? QString(kMinus) : QString())
        .arg(std::abs(exponent));
}

QString withSign(double value, int digits, bool plus) {
    if (!std::isfinite(value)) {
        return QStringLiteral("–");
    }
    const QString plain = std::abs(value) < kLongest ? QString::number(std::abs(value), 'f', digits)
                                                     : exponentialOf(std::abs(value), kDigitsOfLongest);
    const bool zero = std::all_of(plain.begin(), plain.end(),
                                  [](QChar c) { return c == QLatin1Char('0') || c == QLatin1Char('.'); });
    const QString magnitude = withDecimalSign(plain);
    if (zero) {
        return magnitude;
    }
    if (value < 0) {
        return kMinus + magnitude;
    }
    return plus ? QLatin1Char('+') + magnitude : magnitude;
}

}  // namespace

QString number(double value, int digits) {
    return withSign(value, digits, false);
}

QString exponential(double value, int significant) {
    if (!std::isfinite(value)) {
        return QStringLiteral("–");
    }
    const QString magnitude = withDecimalSign(exponentialOf(std::abs(value), significant));
    return value < 0 ? kMinus + magnitude : magnitude;
}

QString signedNumber(double value, int digits) {
    return withSign(value, digits, true);
}

QString degrees(double radians, int digits) {
    return number(toDegrees(radians), digits) + QStringLiteral("°");
}

QString newtons(double value) {
    return number(value, 1) + QStringLiteral(" N");
}

QString newtonMetres(double value) {
    return number(value, 2) + QStringLiteral(" Nm");
}

QString amperes(double value) {
    return number(value, 3) + QStringLiteral(" A");
}

QString percent(double fraction) {
    return number(fraction * 100.0, 0) + QStringLiteral(" %");
}

QString degreesPerSecond(double radiansPerSecond) {
    return number(toDegrees(radiansPerSecond), 0) + QStringLiteral(" °/s");
}

QString grouped(std::uint64_t value) {
    QString digits = QString::number(value);
    for (qsizetype i = digits.size() - 3; i > 0; i -= 3) {
        digits.insert(i, QChar(0x202F));
    }
    return digits;
}

QString duration(double seconds) {
    const auto total = static_cast<std::int64_t>(std::isfinite(seconds) ? std::max(0.0, seconds) : 0.0);
    return QStringLiteral("%1:%2:%3")
        .arg(total / 3600, 2, 10, QLatin1Char('0'))
        .arg(total / 60 % 60, 2, 10, QLatin1Char('0'))
        .arg(total % 60, 2, 10, QLatin1Char('0'));
}

QString bytes(std::int64_t value) {
    constexpr const char* kUnits[] = {"B", "kB", "MB", "GB", "TB"};
    double amount = static_cast<double>(std::max<std::int64_t>(value, 0));
    int unit = 0;
    while (amount >= 1000.0 && unit < 4) {
        amount /= 1000.0;
        ++unit;
    }
    const int digits = unit == 0 || amount >= 10.0 ? 0 : 1;
    return QStringLiteral("%1 %2").arg(number(amount, digits), QLatin1String(kUnits[unit]));
}

}  // namespace tiller::format
