// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/decimal_spin_box.h"

#include <QAccessible>
#include <QApplication>
#include <QClipboard>
#include <QCoreApplication>
#include <QKeyEvent>
#include <QLineEdit>
#include <QToolTip>
#include <QWheelEvent>

namespace tiller {

namespace {

constexpr QChar kMinusSign(0x2212);
constexpr QLatin1Char kHyphen('-');
constexpr QLatin1Char kPoint('.');
constexpr QLatin1Char kComma(',');

/// Converts the text to the minus sign and the decimal separator of the user interface.
QString asShown(QString text) {
    const QString sign = QLocale().decimalPoint();
    text.replace(kHyphen, kMinusSign).replace(kComma, kPoint);
    return sign == kPoint ? text : text.replace(kPoint, sign);
}

/// Converts the text to the characters expected by the base class.
QString asRead(QString text) {
    return text.replace(kMinusSign, kHyphen)
        .replace(QLocale().decimalPoint(), QString(kPoint))
        .replace(kComma, kPoint);
}

}  // namespace

DecimalSpinBox::DecimalSpinBox(QWidget* parent) : QDoubleSpinBox(parent) {
    setFocusPolicy(Qt::StrongFocus);
    setButtonSymbols(NoButtons);
    setKeyboardTracking(false);
    QLocale plain = QLocale::c();
    plain.setNumberOptions(QLocale::OmitGroupSeparator | QLocale::RejectGroupSeparator);
    setLocale(plain);
}

bool DecimalSpinBox::isRefused() const {
    QString text = lineEdit()->text();
    int position = 0;
    return validate(text, position) != QValidator::Acceptable;
}

void DecimalSpinBox::explainRefusal() {
    const auto with = [this](double figure) { return textFromValue(figure) + suffix(); };
    const QString text = tr("“%1” is out of range (%2 to %3). Nothing was changed.")
                             .arg(asShown(bare(lineEdit()->text())), with(minimum()), with(maximum()));
    QToolTip::showText(mapToGlobal(QPoint(0, height())), text, this);
    setAccessibleDescription(text);
    QAccessibleEvent event(this, QAccessible::DescriptionChanged);
    QAccessible::updateAccessibility(&event);
}

// Values out of range are accepted while typing, because rejecting a digit would change the entered number.
// Additional decimals are rounded.
QValidator::State DecimalSpinBox::validate(QString& text, int& position) const {
    text = asShown(text);
    bool isNumber = false;
    const double figure = locale().toDouble(bare(text), &isNumber);
    if (!isNumber) {
        QString read = asRead(text);
        return QDoubleSpinBox::validate(read, position);
    }
    return figure >= minimum() && figure <= maximum() ? QValidator::Acceptable : QValidator::Intermediate;
}

QString DecimalSpinBox::textFromValue(double value) const {
    return asShown(QDoubleSpinBox::textFromValue(value));
}

double DecimalSpinBox::valueFromText(const QString& text) const {
    bool isNumber = false;
    const double figure = locale().toDouble(bare(text), &isNumber);
    return isNumber ? figure : QDoubleSpinBox::valueFromText(asRead(text));
}

void DecimalSpinBox::keyPressEvent(QKeyEvent* event) {
    if (copies(*event)) {
        return;
    }
    const bool finishes = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    if (finishes && isRefused()) {
        explainRefusal();
        lineEdit()->selectAll();
        return;
    }
    if (event->key() == Qt::Key_Escape &&
        lineEdit()->text() != prefix() + textFromValue(value()) + suffix()) {
        restore();
        return;
    }
    QDoubleSpinBox::keyPressEvent(event);
    if (finishes) {
        setAccessibleDescription({});
    }
}

void DecimalSpinBox::focusOutEvent(QFocusEvent* event) {
    if (!isRefused()) {
        QDoubleSpinBox::focusOutEvent(event);
        return;
    }
    // The base class would replace the invalid input with the previous value, as if the user had entered that
    // value.
    QCoreApplication::sendEvent(lineEdit(), event);
    QWidget::focusOutEvent(event);
    explainRefusal();
}

void DecimalSpinBox::wheelEvent(QWheelEvent* event) {
    event->ignore();
}

QString DecimalSpinBox::bare(QString text) const {
    if (!suffix().isEmpty() && text.endsWith(suffix())) {
        text.chop(suffix().size());
    }
    return asRead(text.trimmed());
}

/// Handles copy and cut. Replaces the typographic minus sign, which spreadsheets and scripts do not accept,
/// with a hyphen.
bool DecimalSpinBox::copies(const QKeyEvent& event) {
    const bool cut = event.matches(QKeySequence::Cut);
    if ((!cut && !event.matches(QKeySequence::Copy)) || !lineEdit()->hasSelectedText()) {
        return false;
    }
    QApplication::clipboard()->setText(lineEdit()->selectedText().replace(kMinusSign, kHyphen));
    if (cut) {
        lineEdit()->del();
    }
    return true;
}

void DecimalSpinBox::restore() {
    lineEdit()->setText(prefix() + textFromValue(value()) + suffix());
    lineEdit()->selectAll();
    setAccessibleDescription({});
    QToolTip::hideText();
}

}  // namespace tiller

#include "moc_decimal_spin_box.cpp"
