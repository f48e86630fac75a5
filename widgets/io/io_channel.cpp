// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/io/io_channel.h"

#include <QContextMenuEvent>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMenu>
#include <QPainter>
#include <algorithm>

#include "widgets/common/density.h"
#include "widgets/common/theme.h"

namespace tiller {
namespace {

constexpr int kTerminalWidth = 46;
constexpr int kLamp = 12;
constexpr int kLampGap = 8;
constexpr int kRightMargin = 6;

int rowHeightNow() {
    return currentDensity() == Density::Touch ? keyHeight(Density::Touch) : IoChannel::kHeight;
}

}  // namespace

IoChannel::IoChannel(const QString& terminal, bool output, QWidget* parent)
    : QAbstractButton(parent), terminal_(terminal), output_(output) {
    setText(terminal);
    setFocusPolicy(Qt::StrongFocus);  // P and F2 pulse and rename the row with the focus
    setAttribute(Qt::WA_Hover);
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    describe();
}

void IoChannel::setName(const QString& name) {
    if (name != name_) {
        name_ = name;
        describe();
        update();
    }
}

void IoChannel::setState(State state) {
    if (state != state_) {
        state_ = state;
        describe();
        update();
    }
}

void IoChannel::setStale(bool stale) {
    if (stale != stale_) {
        stale_ = stale;
        setCursor(output_ && !stale ? Qt::PointingHandCursor : Qt::ArrowCursor);
        describe();
        update();
    }
}

void IoChannel::setObstacle(const QString& why, const QString& word) {
    if (why != obstacle_ || word != obstacleWord_) {
        obstacle_ = why;
        obstacleWord_ = word;
        describe();
        update();
    }
}

QString IoChannel::stateWord() const {
    return wordOf(state_);
}

/// The width of the lamp and of the longest word, so that the lamps are in one column.
int IoChannel::stateWidth() const {
    const QFontMetrics metrics(textFont(14, QFont::Bold));
    int width = 0;
    for (const State state : {State::Unknown, State::Off, State::On, State::PendingOn}) {
        width = std::max(width, metrics.horizontalAdvance(wordOf(state)));
    }
    return kLamp + kLampGap + width + kRightMargin;
}

QString IoChannel::wordOf(State state) {
    switch (state) {
        case State::Unknown:
            return tr("no data");
        case State::Off:
            return tr("off");
        case State::On:
            return tr("on");
        case State::PendingOff:
        case State::PendingOn:
            return tr("pending…");
    }
    return {};
}

void IoChannel::describe() {
    setAccessibleName(name_.isEmpty() ? terminal_ : QStringLiteral("%1, %2").arg(terminal_, name_));
    setAccessibleDescription(stale_ && state_ != State::Unknown ? tr("%1, outdated").arg(stateWord())
                                                                : stateWord());
    QString tip = QStringLiteral("%1: %2").arg(accessibleName(), accessibleDescription());
    if (output_) {
        tip += stale_ ? tr("\nThe output cannot be switched while the robot is not sending data.")
               : !obstacle_.isEmpty() ? QLatin1Char('\n') + obstacle_
                                      : tr("\nClick to switch the output %1. Press P to pulse it. "
                                           "Right-click to pulse or rename it.")
                                            .arg(state_ == State::On ? tr("off") : tr("on"));
    } else {
        tip += tr("\nRight-click or press F2 to rename the input.");
    }
    setToolTip(tip);
}

void IoChannel::changeEvent(QEvent* event) {
    QAbstractButton::changeEvent(event);
    if (event->type() == QEvent::StyleChange) {
        updateGeometry();  // the density may have changed
    }
}

bool IoChannel::hitButton(const QPoint& position) const {
    // Ignore clicks instead of disabling the row, because the user can still rename it while data are
    // outdated.
    return output_ && !stale_ && obstacle_.isEmpty() && QAbstractButton::hitButton(position);
}

QRect IoChannel::nameRect() const {
    return {10 + kTerminalWidth, 0, width() - 20 - kTerminalWidth - stateWidth(), height()};
}

QSize IoChannel::sizeHint() const {
    return {250, rowHeightNow()};
}

QSize IoChannel::minimumSizeHint() const {
    return {170, rowHeightNow()};
}

void IoChannel::paintEvent(QPaintEvent*) {
    const Theme& theme = Theme::current();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const bool live = !stale_ && state_ != State::Unknown;

    if (output_) {
        const QRectF key = QRectF(rect()).adjusted(0.5, 1.5, -0.5, -1.5);
        painter.setPen(QPen(hasFocus() ? theme.moving : theme.border, 1));
        painter.setBrush(stale_ || !obstacle_.isEmpty() ? theme.panel
                         : isDown()                     ? theme.movingTint
                         : underMouse()                 ? theme.hover
                                                        : theme.raised);
        painter.drawRoundedRect(key, 5, 5);
    } else {
        painter.setPen(theme.border);
        painter.drawLine(0, height() - 1, width(), height() - 1);
    }

    painter.setFont(numberFont(13));
    painter.setPen(live ? theme.secondary : theme.disabledText);
    painter.drawText(QRect(10, 0, kTerminalWidth, height()), Qt::AlignVCenter | Qt::AlignLeft, terminal_);
    painter.setFont(textFont(14));
    painter.setPen(live ? theme.text : theme.disabledText);
    const QRect nameBox = nameRect();
    const QString shown = obstacle_.isEmpty() ? name_ : tr("%1 (%2)").arg(name_, obstacleWord_).trimmed();
    painter.drawText(nameBox, Qt::AlignVCenter | Qt::AlignLeft,
                     painter.fontMetrics().elidedText(shown, Qt::ElideRight, nameBox.width()));

    // Draw a filled circle, a ring, or a half-filled circle for an unconfirmed output, so that the states are
    // distinguishable without colour.
    const int stateWidth = this->stateWidth();
    const QRectF lamp(width() - stateWidth, (height() - kLamp) / 2.0, kLamp, kLamp);
    const QColor ink = live ? theme.text : theme.disabledText;
    const bool pending = state_ == State::PendingOff || state_ == State::PendingOn;
    painter.setPen(QPen(pending && live ? theme.moving : ink, 1.6));
    painter.setBrush(state_ == State::On ? QBrush(ink) : QBrush(Qt::NoBrush));
    if (state_ != State::Unknown) {
        painter.drawEllipse(lamp);
    }
    if (pending) {
        painter.setBrush(live ? theme.moving : ink);
        painter.setPen(Qt::NoPen);
        painter.drawPie(lamp, 90 * 16, state_ == State::PendingOn ? -180 * 16 : 180 * 16);
    }
    painter.setFont(textFont(14, state_ == State::On && live ? QFont::Bold : QFont::Normal));
    painter.setPen(live ? (state_ == State::Off ? theme.secondary : theme.text) : theme.disabledText);
    painter.drawText(QRectF(lamp.right() + kLampGap, 0, stateWidth - kLamp - kLampGap, height()),
                     Qt::AlignVCenter | Qt::AlignLeft, stateWord());
}

void IoChannel::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_F2) {
        rename();
    } else if (event->key() == Qt::Key_Escape && editor_ != nullptr && editor_->isVisible()) {
        editor_->setText(name_);
        finishRename();
    } else if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) {
        if (!event->isAutoRepeat() && output_ && !stale_ && obstacle_.isEmpty()) {
            click();
        }
    } else if (event->key() == Qt::Key_P && output_ && !stale_ && obstacle_.isEmpty()) {
        if (!event->isAutoRepeat()) {
            Q_EMIT pulseRequested();
        }
    } else {
        event->ignore();  // Space always stops the arm and must not press a button
    }
}

void IoChannel::contextMenuEvent(QContextMenuEvent* event) {
    QMenu menu(this);
    if (output_) {
        QAction* pulse = menu.addAction(tr("Pulse"), this, &IoChannel::pulseRequested);
        pulse->setEnabled(!stale_ && obstacle_.isEmpty());
    }
    menu.addAction(tr("Rename…"), this, &IoChannel::rename);
    menu.exec(event->globalPos());
}

void IoChannel::rename() {
    if (editor_ == nullptr) {
        editor_ = new QLineEdit(this);
        editor_->setObjectName(objectName() + QStringLiteral(".name"));
        editor_->setAccessibleName(tr("Name of %1").arg(terminal_));
        editor_->setMaxLength(40);
        editor_->setStyleSheet(QStringLiteral("min-height: 0; padding: 0 4px;"));
        connect(editor_, &QLineEdit::editingFinished, this, &IoChannel::finishRename);
    }
    editor_->setText(name_);
    editor_->setGeometry(nameRect().adjusted(-6, 3, -6, -3));
    editor_->show();
    editor_->setFocus();
    editor_->selectAll();
}

void IoChannel::finishRename() {
    if (!editor_->isVisible()) {
        return;
    }
    if (editor_->hasFocus()) {
        setFocus(Qt::OtherFocusReason);  // otherwise, the next widget of the window would get the focus
    }
    editor_->hide();
    const QString name = editor_->text().trimmed();
    if (name != name_) {
        setName(name);
        Q_EMIT nameChanged();
    }
}

}  // namespace tiller

#include "moc_io_channel.cpp"
