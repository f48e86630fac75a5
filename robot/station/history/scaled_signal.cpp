// SPDX-License-Identifier: MIT
#include "robot/station/history/scaled_signal.h"

#include <QLocale>
#include <QRegularExpression>
#include <cmath>

#include "robot/station/history/signal_store.h"

namespace tiller {

namespace {

const QString kNumberForm = QStringLiteral("(\\d[\\d.]*(?:[eE][-+]?\\d+)?)");

/// True for one signal, or for an expression in parentheses.
bool isOperand(const QString& text) {
    static const QRegularExpression kSignal(QStringLiteral("^(?:[A-Za-z_][\\w.]*|\\{[^{}]*\\})$"));
    if (kSignal.match(text).hasMatch()) {
        return true;
    }
    int open = 0;
    for (qsizetype i = 0; i < text.size(); ++i) {
        open += text[i] == QLatin1Char('(') ? 1 : text[i] == QLatin1Char(')') ? -1 : 0;
        if (open <= 0) {
            return i > 0 && i + 1 == text.size();  // the first parenthesis is closed at the end
        }
    }
    return false;
}

QString exactText(double value) {
    return QString::number(value, 'g', QLocale::FloatingPointShortest);
}

/// The signal that is the whole expression; -1 for other expressions.
int signalOf(const SignalStore& store, const QString& base) {
    const bool isBraced = base.startsWith(QLatin1Char('{')) && base.endsWith(QLatin1Char('}'));
    return base.startsWith(QLatin1Char('(')) ? -1 : store.find(isBraced ? base.mid(1).chopped(1) : base);
}

/// Removes the characters that have a meaning in the text of a derived signal, and shortens the name to
/// `most` characters.
QString plainName(QString name, qsizetype most) {
    name.removeIf([](QChar letter) { return QStringLiteral("=[]").contains(letter); });
    return name.simplified().left(most).trimmed();
}

constexpr qsizetype kMaxName = 40;
constexpr qsizetype kMaxUnit = 12;

}  // namespace

ScaledSignal ScaledSignal::of(const SignalStore& store, int signal) {
    static const QRegularExpression kScaled(
        QStringLiteral("^(.+?)\\s*\\*\\s*(-?)%1\\s*([-+])\\s*%1$").arg(kNumberForm),
        QRegularExpression::DotMatchesEverythingOption);
    const SignalInfo& info = store.info(signal);
    ScaledSignal scaled{DerivedSignal::written(info.key), plainName(info.longLabel, kMaxName),
                        plainName(info.unit, kMaxUnit)};
    if (!store.isDerived(signal)) {
        return scaled;
    }
    const QString expression = info.key.mid(info.key.indexOf(QLatin1Char('=')) + 1).trimmed();
    const auto match = kScaled.match(expression);
    if (match.hasMatch() && isOperand(match.captured(1))) {
        scaled.base = match.captured(1);
        scaled.scale = match.captured(3).toDouble() * (match.captured(2).isEmpty() ? 1 : -1);
        scaled.offset = match.captured(5).toDouble() * (match.captured(4) == QLatin1String("-") ? -1 : 1);
    } else {
        scaled.base = isOperand(expression) ? expression : QStringLiteral("(%1)").arg(expression);
    }
    return scaled;
}

QString ScaledSignal::key(const SignalStore& store) const {
    const bool isScaled = scale != 1 || offset != 0;
    if (const int signal = signalOf(store, base); signal >= 0 && !isScaled && *this == of(store, signal)) {
        return store.info(signal).key;
    }
    const QString whole = base.startsWith(QLatin1Char('(')) ? base.mid(1).chopped(1) : base;
    const QString expression =
        isScaled ? QStringLiteral("%1 * %2 %3 %4")
                       .arg(base, exactText(scale), offset < 0 ? QStringLiteral("-") : QStringLiteral("+"),
                            exactText(std::abs(offset)))
                 : whole;
    return unit.isEmpty() ? QStringLiteral("%1 = %2").arg(name, expression)
                          : QStringLiteral("%1 [%2] = %3").arg(name, unit, expression);
}

}  // namespace tiller
