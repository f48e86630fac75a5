// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/status/stop_button.h"

#include <QApplication>
#include <QMouseEvent>
#include <QPainter>
#include <QScreen>
#include <algorithm>

#include "widgets/common/stop_mark.h"
#include "widgets/common/theme.h"

namespace tiller {

namespace {
constexpr int kHintHeight = 18;  // height of the line below the STOP text [px]
}

StopButton::StopButton(QWidget* parent) : QAbstractButton(parent) {
    setObjectName(QStringLiteral("stopButton"));
    setProperty(kStopButtonProperty, true);
    setText(tr("STOP"));
    setAccessibleName(tr("Stop"));
    setFocusPolicy(Qt::NoFocus);
    setAttribute(Qt::WA_AcceptTouchEvents);
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    // Screen readers activate the button through click().
    connect(this, &QAbstractButton::clicked, this, &StopButton::stopRequested);
    setKeysStop(false);
    qApp->installEventFilter(this);
}

void StopButton::setKeysStop(bool keys) {
    if (keys == keysStop_) {
        return;
    }
    keysStop_ = keys;
    const QString what = tr("Software stop. Not an emergency stop. Power stays on.");
    setToolTip(what + QLatin1Char('\n') +
               (keys ? tr("Space and Esc also stop the arm.")
                     : tr("Click to stop the arm. Space and Esc stop the arm only while this window is in "
                          "control.")));
    setAccessibleDescription(toolTip());
    update();
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
    const QString how = keysStop_ ? tr("Space / Esc") : tr("click");
    const int left = wide ? 22 : (width() - 26 - wordWidth) / 2;
    const int wordHeight = wide ? height() : height() - kHintHeight;
    painter.setBrush(theme.stopText);
    painter.drawRect(QRectF(left, wordHeight / 2.0 - 8, 16, 16));
    painter.setPen(theme.stopText);
    painter.setFont(word);
    painter.drawText(QRect(left + 28, 0, wordWidth + 8, wordHeight), Qt::AlignLeft | Qt::AlignVCenter,
                     text());
    painter.setFont(textFont(11));
    if (wide) {
        const QRect box(left + 28 + wordWidth + 10, 2, width() - left - wordWidth - 42, height() - 4);
        const QString hint = how + QLatin1Char('\n') + tr("not an e-stop");
        constexpr int kFlags = Qt::AlignLeft | Qt::AlignVCenter | Qt::TextWordWrap;
        for (int size = 11; size >= 8; --size) {
            painter.setFont(textFont(size));
            if (box.contains(painter.boundingRect(box, kFlags, hint))) {
                break;
            }
        }
        painter.drawText(box, kFlags, hint);
    } else {
        painter.drawText(QRect(0, wordHeight - 6, width(), kHintHeight), Qt::AlignCenter, how);
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

void StopButton::keepUncovered(QWidget& popup) const {
    const QRect own(mapToGlobal(QPoint(0, 0)), size());
    QRect at = popup.geometry();
    if (!at.intersects(own)) {
        return;
    }
    const QRect free = screen()->availableGeometry();
    at.moveTop(own.bottom() + 1);
    if (at.bottom() > free.bottom()) {
        at.moveTop(std::max(free.top(), free.bottom() + 1 - at.height()));
        at.moveRight(own.left() - 1);
    }
    popup.move(at.topLeft());
}

bool StopButton::eventFilter(QObject* watched, QEvent* event) {
    if (!watched->isWidgetType() || !isVisible()) {
        return false;
    }
    auto& widget = *static_cast<QWidget*>(watched);
    if (event->type() == QEvent::Show && widget.windowType() == Qt::Popup) {
        keepUncovered(widget);
    }
    // Filter the events of the application, because an open menu receives every press and a press outside the
    // menu would only close it.
    const bool pressed =
        event->type() == QEvent::MouseButtonPress || event->type() == QEvent::MouseButtonDblClick;
    if (pressed && widget.windowType() == Qt::Popup) {
        const QPoint at = static_cast<QMouseEvent*>(event)->globalPosition().toPoint();
        if (rect().contains(mapFromGlobal(at)) && !widget.geometry().contains(at)) {
            Q_EMIT stopRequested();
        }
    }
    return false;
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
