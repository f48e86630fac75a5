// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/status/speed_chip.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QScopedValueRollback>
#include <QWheelEvent>
#include <cmath>

#include "widgets/common/theme.h"

namespace tiller {

namespace {
constexpr int kPadding = 13;
constexpr int kSettleMs = 800;
constexpr int kMinPercent = 2;  // a slider value of 0 has caused protective stops
}  // namespace

SpeedChip::SpeedChip(QWidget* parent) : QAbstractSlider(parent) {
    setObjectName(QStringLiteral("speedSlider"));
    setAccessibleName(tr("Speed slider"));
    setToolTip(tr("Robot speed slider, 2 to 100 %"));
    setOrientation(Qt::Horizontal);
    setRange(kMinPercent, 100);
    setSingleStep(1);
    setPageStep(10);
    // A click does not set the focus, so that later key presses do not change the speed.
    setFocusPolicy(Qt::TabFocus);
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    settle_.setSingleShot(true);
    settle_.setInterval(kSettleMs);
    connect(this, &QAbstractSlider::valueChanged, this, [this](int percent) {
        update();
        if (!showing_ && !(sendsOnRelease_ && isSliderDown())) {
            settle_.start();
            Q_EMIT fractionChosen(percent / 100.0);
        }
    });
}

void SpeedChip::setLocked(const QString& reason) {
    if (reason != lock_) {
        lock_ = reason;
        setToolTip(reason.isEmpty() ? tr("Robot speed slider, 2 to 100 %") : reason);
        setEnabled(valid_ && lock_.isEmpty());
    }
}

void SpeedChip::setReported(double fraction, bool valid) {
    if (valid != valid_) {
        valid_ = valid;
        setEnabled(valid && lock_.isEmpty());
        update();
    }
    const int percent = static_cast<int>(std::lround(fraction * 100));
    if (percent == value()) {
        settle_.stop();
        return;
    }
    if (!valid || isSliderDown() || settle_.isActive()) {
        return;
    }
    const QScopedValueRollback<bool> quietly(showing_, true);
    setValue(percent);
}

QRectF SpeedChip::groove() const {
    return {static_cast<double>(kPadding), 29, width() - 2.0 * kPadding, 8};
}

void SpeedChip::paintEvent(QPaintEvent*) {
    const Theme& theme = Theme::current();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(hasFocus() ? QPen(theme.moving, 1.5) : QPen(theme.border, 1));
    painter.setBrush(theme.panel);
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), kCornerRadius, kCornerRadius);

    QFont caption = textFont(11);
    caption.setLetterSpacing(QFont::AbsoluteSpacing, 0.4);
    const QRect words(kPadding, 6, width() - 2 * kPadding, 18);
    painter.setFont(caption);
    painter.setPen(theme.secondary);
    painter.drawText(words, Qt::AlignLeft | Qt::AlignVCenter, tr("SPEED"));
    painter.setFont(numberFont(13));
    painter.setPen(valid_ ? theme.text : theme.secondary);
    painter.drawText(words, Qt::AlignRight | Qt::AlignVCenter,
                     valid_ ? QStringLiteral("%1 %").arg(value()) : QStringLiteral("–"));

    const QRectF bar = groove();
    painter.setPen(Qt::NoPen);
    painter.setBrush(theme.border);
    painter.drawRoundedRect(bar, 4, 4);
    if (!valid_) {
        return;
    }
    const double x = bar.left() + bar.width() * value() / 100.0;
    painter.setBrush(isEnabled() ? theme.secondary : theme.disabledText);
    painter.drawRoundedRect(QRectF(bar.left(), bar.top(), x - bar.left(), bar.height()), 4, 4);
    painter.setBrush(isEnabled() ? theme.text : theme.disabledText);
    painter.drawRoundedRect(QRectF(x - 2, bar.top() - 3, 4, bar.height() + 6), 2, 2);
}

void SpeedChip::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) {
        event->ignore();
        return;
    }
    setSliderDown(true);
    pressedAt_ = event->position().toPoint().x();
    pressedValue_ = value();
}

void SpeedChip::mouseMoveEvent(QMouseEvent* event) {
    if (isSliderDown()) {
        const double along = (event->position().x() - pressedAt_) / groove().width();
        setValue(pressedValue_ + static_cast<int>(std::lround(100 * along)));
    }
}

void SpeedChip::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton) {
        setSliderDown(false);
        if (sendsOnRelease_ && value() != pressedValue_) {
            settle_.start();
            Q_EMIT fractionChosen(value() / 100.0);
        }
    }
}

void SpeedChip::keyPressEvent(QKeyEvent* event) {
    switch (event->key()) {
        case Qt::Key_Home:
        case Qt::Key_End:
        case Qt::Key_PageUp:
        case Qt::Key_PageDown:
            event->ignore();  // one press of such a key could multiply the speed of the arm
            break;
        default:
            QAbstractSlider::keyPressEvent(event);
    }
}

void SpeedChip::wheelEvent(QWheelEvent* event) {
    event->ignore();
}

}  // namespace tiller

#include "moc_speed_chip.cpp"
