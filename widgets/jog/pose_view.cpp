// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/jog/pose_view.h"

#include <QFocusEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>

#include "widgets/common/notation.h"
#include "widgets/common/theme.h"

namespace tiller {

namespace {

constexpr int kDigitPeriodMs = 100;

/// Two digits at rest, one on the move; a blank keeps the place of the second.
QString paced(double metres, bool moving) {
    const QString text = format::lengthNumber(metres, moving ? 1 : 2, true);
    return moving ? text + QChar(0x2007) : text;
}

QString dash() {
    return QStringLiteral("–");
}

}  // namespace

PoseView::PoseView(QWidget* parent) : QWidget(parent) {
    setObjectName(QStringLiteral("poseView"));
    setAccessibleName(tr("TCP pose in Base"));
    setFocusPolicy(Qt::TabFocus);
    describe();
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    pace_.setSingleShot(true);
    pace_.setInterval(kDigitPeriodMs);
    connect(&pace_, &QTimer::timeout, this, [this] {
        if (pending_) {
            pending_ = false;
            update();
            pace_.start();
        }
    });
}

void PoseView::setPose(const Pose& pose, bool moving, bool valid, bool stale) {
    const bool look = moving != moving_ || valid != valid_ || stale != stale_;
    if (valid && !hasZero_) {
        zero_ = pose.position;
        hasZero_ = true;
    }
    if (!look && pose == pose_) {
        return;
    }
    pose_ = pose;
    moving_ = moving;
    valid_ = valid;
    stale_ = stale;
    if (look || !pace_.isActive()) {
        update();
        pace_.start();
    } else {
        pending_ = true;
    }
}

void PoseView::zeroHere() {
    ownZero_ = !ownZero_;
    zero_ = pose_.position;
    describe();
    update();
}

void PoseView::pressedHere() {
    if (!ownZero_) {
        zero_ = pose_.position;
        update();
    }
}

void PoseView::describe() {
    setToolTip(ownZero_ ? tr("TCP pose in Base, orientation as chosen in Settings. Δ₀: way since zero. "
                             "Click: way since the press")
                        : tr("TCP pose in Base, orientation as chosen in Settings. Δ: way since the press. "
                             "Click: zero here"));
    setAccessibleDescription(toolTip());
}

QString PoseView::positionText(int axis) const {
    return valid_ ? paced(pose_.position[axis], moving_) : dash();
}

QString PoseView::deltaText(int axis) const {
    return valid_ ? paced(pose_.position[axis] - zero_[axis], moving_) : dash();
}

QString PoseView::rotationText(int axis) const {
    return valid_ ? format::rotation(pose_.rotation)[static_cast<std::size_t>(axis)] : dash();
}

void PoseView::paintEvent(QPaintEvent*) {
    const Theme& theme = Theme::current();
    QPainter painter(this);
    const double rowHeight = height() / 3.0;
    const QColor ink = valid_ && !stale_ ? theme.text : theme.disabledText;
    const QFont value = textFont(19);
    const bool narrow = width() < 352;
    const QFont label = textFont(narrow ? 13 : 15);
    const int number = narrow ? 104 : 110;  // right edge of the position
    const int delta = narrow ? 203 : 226;   // right edge of the way
    static constexpr const char* kAxes[] = {"X", "Y", "Z"};
    static constexpr const char* kTurns[] = {"RX", "RY", "RZ"};
    const int right = width();
    if (hasFocus() && focusByKey_) {
        painter.setPen(QPen(theme.moving, 2));
        painter.drawRect(rect().adjusted(1, 1, -2, -2));
    }
    for (int axis = 0; axis < 3; ++axis) {
        const int top = static_cast<int>(axis * rowHeight);
        const int h = static_cast<int>(rowHeight);
        const auto put = [&](const QFont& font, const QColor& colour, int x, int w, Qt::Alignment align,
                             const QString& text) {
            painter.setFont(font);
            painter.setPen(colour);
            painter.drawText(QRect(x, top, w, h - 1), static_cast<int>(align | Qt::AlignVCenter), text);
        };
        put(textFont(16, QFont::Bold), theme.axisTexts.at(static_cast<std::size_t>(axis)), 4, 16,
            Qt::AlignLeft, QLatin1String(kAxes[axis]));
        put(value, ink, 12, number - 12, Qt::AlignRight, positionText(axis));
        put(label, theme.secondary, number + 4, 32, Qt::AlignLeft, format::lengthUnit());
        put(label, theme.secondary, number + (narrow ? 33 : 43), 20, Qt::AlignLeft,
            ownZero_ ? QStringLiteral("Δ₀") : QStringLiteral("Δ"));
        put(label, theme.secondary, delta - 66, 66, Qt::AlignRight, deltaText(axis));
        put(label, theme.secondary, right - (narrow ? 121 : 124), 26, Qt::AlignLeft,
            QLatin1String(kTurns[axis]));
        put(value, ink, right - 100, 98, Qt::AlignRight, rotationText(axis));
        painter.setPen(theme.border);
        painter.drawLine(0, top + h - 1, width() - 1, top + h - 1);
    }
}

void PoseView::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton && rect().contains(event->position().toPoint())) {
        zeroHere();
    }
}

void PoseView::keyPressEvent(QKeyEvent* event) {
    if ((event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) && !event->isAutoRepeat()) {
        zeroHere();
    } else {
        event->ignore();
    }
}

void PoseView::focusInEvent(QFocusEvent* event) {
    focusByKey_ = event->reason() == Qt::TabFocusReason || event->reason() == Qt::BacktabFocusReason;
    QWidget::focusInEvent(event);
    update();
}

void PoseView::focusOutEvent(QFocusEvent* event) {
    QWidget::focusOutEvent(event);
    update();
}

}  // namespace tiller
