// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/jog/arm_key.h"

#include <QFocusEvent>
#include <QPainter>
#include <algorithm>

#include "widgets/common/density.h"
#include "widgets/common/enter_key.h"
#include "widgets/common/shapes.h"
#include "widgets/common/theme.h"

namespace tiller {

namespace {

constexpr int kHeight = 26;  // height in a title bar [px]
constexpr int kShape = 12;   // size of the hand symbol next to the text [px]

}  // namespace

ArmKey::ArmKey(QWidget* parent) : QAbstractButton(parent) {
    setObjectName(QStringLiteral("jog.armKeyboard"));
    setCheckable(true);
    setFocusPolicy(Qt::TabFocus);  // a click does not change the focus
    setAttribute(Qt::WA_Hover);
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    setArmed(false);
}

void ArmKey::setLock(const QString& why) {
    if (why != lock_) {
        lock_ = why;
        setArmed(isArmed());
        update();
    }
}

void ArmKey::setArmed(bool armed) {
    setChecked(armed);
    setText(armed ? tr("Keyboard armed") : tr("Arm keyboard"));
    setAccessibleName(text());
    setToolTip(!lock_.isEmpty() ? lock_
               : armed ? tr("Arrow keys move along X and Y, PgUp and PgDn along Z; with Alt, they rotate the "
                            "tool. Hold 1 to 6 and press + or − to move a joint. Space and Esc stop the arm. "
                            "To disarm the keyboard, click this button or wait 30 s.")
                       : tr("While the keyboard is armed, holding an arrow key moves the arm. A border "
                            "around the window shows that the keyboard is armed."));
}

QSize ArmKey::sizeHint() const {
    const QFontMetrics metrics(textFont(13, QFont::Bold));
    const int words = std::max(metrics.horizontalAdvance(tr("Keyboard armed")),
                               metrics.horizontalAdvance(tr("Arm keyboard")));
    return {words + kShape + 20, std::max(kHeight, touchHeight())};
}

void ArmKey::paintEvent(QPaintEvent*) {
    const Theme& theme = Theme::current();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const bool armed = isArmed();
    const QColor fill = armed ? theme.operatorNeeded : isDown() || underMouse() ? theme.hover : theme.raised;
    const QColor ink = armed ? theme.operatorNeededText : lock_.isEmpty() ? theme.text : theme.disabledText;
    painter.setPen(armed ? theme.operatorNeeded : theme.border);
    painter.setBrush(fill);
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), kCornerRadius - 1,
                            kCornerRadius - 1);
    if (hasFocus() && focusByKey_) {
        painter.setPen(QPen(armed ? ink : theme.moving, 2));
        painter.setBrush(Qt::NoBrush);
        painter.drawRoundedRect(QRectF(rect()).adjusted(2, 2, -2, -2), kCornerRadius - 2, kCornerRadius - 2);
    }
    drawShape(painter, StateChip::Shape::Hand, QRectF(7, (height() - kShape) / 2.0, kShape, kShape), ink,
              fill);
    painter.setFont(textFont(13, armed ? QFont::Bold : QFont::Normal));
    painter.setPen(ink);
    painter.drawText(rect().adjusted(kShape + 12, 0, -6, 0), Qt::AlignLeft | Qt::AlignVCenter, text());
}

void ArmKey::changeEvent(QEvent* event) {
    if (event->type() == QEvent::StyleChange) {
        updateGeometry();  // the density may have changed
    }
    QAbstractButton::changeEvent(event);
}

void ArmKey::keyPressEvent(QKeyEvent* event) {
    if (!pressByEnter(*this, *event)) {
        QAbstractButton::keyPressEvent(event);
    }
}

void ArmKey::focusInEvent(QFocusEvent* event) {
    focusByKey_ = event->reason() == Qt::TabFocusReason || event->reason() == Qt::BacktabFocusReason;
    QAbstractButton::focusInEvent(event);
}

}  // namespace tiller

#include "moc_arm_key.cpp"
