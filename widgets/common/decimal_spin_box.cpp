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
#include <functional>
#include <optional>
#include <utility>

#include "robot/core/typed_number.h"
#include "widgets/common/text_entry.h"

namespace tiller {

namespace {

constexpr QChar kMinusSign(0x2212);
constexpr QLatin1Char kHyphen('-');
constexpr QLatin1Char kPoint('.');
constexpr QLatin1Char kComma(',');

/// Uses the minus sign and the decimal separator of the user interface.
QString asShown(QString text) {
    const QString sign = QLocale().decimalPoint();
    text.replace(kHyphen, kMinusSign).replace(kComma, kPoint);
    return sign == kPoint ? text : text.replace(kPoint, sign);
}

/// Calls a function when the widget is painted, because a spin box reports no change if setting a value
/// changes only its text.
class PaintWatch : public QObject {
public:
    PaintWatch(QWidget& watched, std::function<void()> painted)
        : QObject(&watched), painted_(std::move(painted)) {
        watched.installEventFilter(this);
    }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override {
        if (event->type() == QEvent::Paint) {
            painted_();
        }
        return QObject::eventFilter(watched, event);
    }

private:
    std::function<void()> painted_;
};

}  // namespace

DecimalSpinBox::DecimalSpinBox(QWidget* parent) : QDoubleSpinBox(parent) {
    setFocusPolicy(Qt::StrongFocus);
    setButtonSymbols(NoButtons);
    setKeyboardTracking(false);
    QLocale plain = QLocale::c();
    plain.setNumberOptions(QLocale::OmitGroupSeparator | QLocale::RejectGroupSeparator);
    setLocale(plain);
    connect(lineEdit(), &QLineEdit::textChanged, this, &DecimalSpinBox::followText);
    new PaintWatch(*lineEdit(), [this] {
        if (isMarkedRefused(*this) && !isRefused()) {
            QMetaObject::invokeMethod(this, &DecimalSpinBox::followText, Qt::QueuedConnection);
        }
    });
}

bool DecimalSpinBox::isRefused() const {
    QString text = lineEdit()->text();
    int position = 0;
    return validate(text, position) != QValidator::Acceptable;
}

void DecimalSpinBox::explainRefusal() {
    const auto with = [this](double figure) { return textFromValue(figure) + suffix(); };
    const QString typed = asShown(withoutUnit(lineEdit()->text()).trimmed());
    const QString text = tr("“%1” is out of range (%2 to %3). The value is still %4.")
                             .arg(typed, with(minimum()), with(maximum()), with(value()));
    QToolTip::showText(mapToGlobal(QPoint(0, height())), text, this);
    setAccessibleDescription(text);
    QAccessibleEvent event(this, QAccessible::DescriptionChanged);
    QAccessible::updateAccessibility(&event);
    if (!isMarkedRefused(*this)) {
        ownToolTip_ = toolTip();
    }
    setToolTip(text);
    markRefused(*this, true);
}

void DecimalSpinBox::followText() {
    if (isMarkedRefused(*this) && !isRefused()) {
        setToolTip(ownToolTip_);
        setAccessibleDescription({});
        markRefused(*this, false);
    }
}

// Accept values out of range while typing, because refusing a digit would change the entered number.
// Additional decimals are rounded.
QValidator::State DecimalSpinBox::validate(QString& text, int& position) const {
    text = asShown(text);
    const std::optional<double> figure = typedNumber(withoutUnit(text));
    if (!figure) {
        QString read = plainNumber(text);
        return QDoubleSpinBox::validate(read, position);
    }
    return *figure >= minimum() && *figure <= maximum() ? QValidator::Acceptable : QValidator::Intermediate;
}

QString DecimalSpinBox::textFromValue(double value) const {
    return asShown(QDoubleSpinBox::textFromValue(value));
}

double DecimalSpinBox::valueFromText(const QString& text) const {
    const std::optional<double> figure = typedNumber(withoutUnit(text));
    return figure ? *figure : QDoubleSpinBox::valueFromText(plainNumber(text));
}

bool DecimalSpinBox::event(QEvent* event) {
    return leavesUndoToProject(*event, lineEdit()->isUndoAvailable(), lineEdit()->isRedoAvailable()) ||
           QDoubleSpinBox::event(event);
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
    // Do not call the base class, which would replace the invalid input with the previous value as if the
    // user had entered it.
    QCoreApplication::sendEvent(lineEdit(), event);
    QWidget::focusOutEvent(event);
    explainRefusal();
}

void DecimalSpinBox::wheelEvent(QWheelEvent* event) {
    event->ignore();
}

QString DecimalSpinBox::withoutUnit(QString text) const {
    if (!suffix().isEmpty() && text.endsWith(suffix())) {
        text.chop(suffix().size());
    }
    return text;
}

/// Handles copy and cut. Replaces the typographic minus sign with a hyphen, because spreadsheets and scripts
/// do not accept it.
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
