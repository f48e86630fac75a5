// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/status/stop_button.h"

#include <QMouseEvent>
#include <QPainter>

#include "widgets/common/theme.h"

namespace tiller {

StopButton::StopButton(QWidget* parent) : QAbstractButton(parent) {
    setObjectName(QStringLiteral("stopButton"));
    setText(tr("STOP"));
    setAccessibleName(tr("Stop"));
    setToolTip(tr("Software stop. Not an emergency stop. Power stays on."));
    setFocusPolicy(Qt::NoFocus);
    setAttribute(Qt::WA_AcceptTouchEvents);
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    // A screen reader presses by click().
    connect(this, &QAbstractButton::clicked, this, &StopButton::stopRequested);
}

void StopButton::paintEvent(QPaintEvent*) {
    const Theme& theme = Theme::current();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(isDown() ? theme.stop.darker(130) : theme.stop);
    painter.drawRoundedRect(QRectF(rect()), kCornerRadius, kCornerRadius);

    const bool wide = width() >= 200;
    const QFont big = textFont(22, QFont::Bold);
    QFont word = big;
    word.setLetterSpacing(QFont::AbsoluteSpacing, 1.2);
    const int wordWidth = QFontMetrics(word).horizontalAdvance(text());
    const int left = wide ? 22 : (width() - 26 - wordWidth) / 2;
    painter.setBrush(theme.stopText);
    painter.drawRect(QRectF(left, height() / 2.0 - 8, 16, 16));
    painter.setPen(theme.stopText);
    painter.setFont(word);
    painter.drawText(QRect(left + 28, 0, wordWidth + 8, height()), Qt::AlignLeft | Qt::AlignVCenter, text());
    if (wide) {
        painter.setFont(textFont(11));
        painter.drawText(QRect(left + 28 + wordWidth + 12, 0, width() - left - wordWidth - 42, height()),
                         Qt::AlignLeft | Qt::AlignVCenter, tr("Space / Esc\nnot an e-stop"));
    }
}

void StopButton::mousePressEvent(QMouseEvent* event) {
    event->accept();
    setDown(true);
    Q_EMIT stopRequested();
}

void StopButton::mouseDoubleClickEvent(QMouseEvent* event) {
    mousePressEvent(event);
}

void StopButton::mouseReleaseEvent(QMouseEvent* event) {
    event->accept();
    setDown(false);
}

bool StopButton::event(QEvent* event) {
    switch (event->type()) {
        case QEvent::TouchBegin:
            event->accept();
            setDown(true);
            Q_EMIT stopRequested();
            return true;
        case QEvent::TouchUpdate:
            event->accept();
            return true;
        case QEvent::TouchEnd:
        case QEvent::TouchCancel:
            event->accept();
            setDown(false);
            return true;
        default:
            return QAbstractButton::event(event);
    }
}

}  // namespace tiller

#include "moc_stop_button.cpp"
