// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/hold/hold_to_run_button.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPointingDevice>
#include <QToolTip>
#include <QTouchEvent>
#include <QWheelEvent>
#include <algorithm>

#include "widgets/common/density.h"
#include "widgets/common/theme.h"

namespace tiller {

namespace {

constexpr int kDetailSize = 13;  // font size [px]
constexpr int kHoldHintMs = 2000;

}  // namespace

HoldToRunButton::HoldToRunButton(const QString& text, HoldPolicy& policy, QWidget* parent)
    : QAbstractButton(parent), guard_(*this, policy) {
    setText(text);
    setAccessibleName(text);
    // The guard sets the focus on a press. With a focus policy, Qt would set the focus earlier and take it
    // from a button that another finger holds. The lost focus would end the first hold, and the second press
    // would start another motion.
    setFocusPolicy(Qt::NoFocus);
    setMouseTracking(true);  // a move without a pressed button shows that the release was missed
    setAttribute(Qt::WA_AcceptTouchEvents);
    setAttribute(Qt::WA_Hover);
    connect(&guard_, &HoldGuard::began, this, [this] { setDown(true); });
    connect(&guard_, &HoldGuard::ended, this, [this] {
        setDown(false);
        setConfirmed(false);
    });
    connect(&guard_, &HoldGuard::began, &holdHint_, &QTimer::stop);
    connect(&guard_, &HoldGuard::clicked, this, &HoldToRunButton::showHoldHint);
    holdHint_.setSingleShot(true);
    holdHint_.setInterval(kHoldHintMs);
    connect(&holdHint_, &QTimer::timeout, this, qOverload<>(&QWidget::update));
}

HoldToRunButton::~HoldToRunButton() {
    guard_.stop(control::StopCause::WindowClosed);
}

void HoldToRunButton::setConfirmed(bool confirmed) {
    if (confirmed != confirmed_) {
        confirmed_ = confirmed;
        update();
    }
}

void HoldToRunButton::setUnavailable(const QString& reason) {
    const bool available = reason.isEmpty();
    if (isEnabled() && !available) {
        availableToolTip_ = toolTip();
    }
    if (isEnabled() == available && (available || toolTip() == reason)) {
        return;
    }
    setEnabled(available);
    setToolTip(available ? availableToolTip_ : reason);
    setAccessibleDescription(reason);
}

void HoldToRunButton::setDetail(const QString& detail) {
    if (detail != detail_) {
        detail_ = detail;
        update();
    }
}

void HoldToRunButton::setWidestDetail(const QString& detail) {
    if (detail != widestDetail_) {
        widestDetail_ = detail;
        updateGeometry();
    }
}

QString HoldToRunButton::detail() const {
    return showsHoldHint() ? tr("hold") : detail_;
}

void HoldToRunButton::showHoldHint() {
    holdHint_.start();
    QToolTip::showText(mapToGlobal(QPoint(0, height())),
                       tr("Hold this button. The arm moves only while the button is held."), this);
    update();
}

QSize HoldToRunButton::sizeHint() const {
    const int words = std::max(QFontMetrics(textFont(15)).horizontalAdvance(text()),
                               QFontMetrics(textFont(kDetailSize)).horizontalAdvance(widestDetail_));
    // Use the height of the neighbouring push buttons including their border.
    return {words + 24, keyHeight(currentDensity()) + 2};
}

QSize HoldToRunButton::minimumSizeHint() const {
    const int name = QFontMetrics(textFont(15)).horizontalAdvance(text());
    const int detail = QFontMetrics(textFont(kDetailSize)).horizontalAdvance(widestDetail_);
    return {std::max(name + 10, detail + 4), widestDetail_.isEmpty() ? 24 : 32};
}

QColor HoldToRunButton::textColor() const {
    const Theme& theme = Theme::current();
    return isEnabled() ? theme.text : theme.disabledText;
}

void HoldToRunButton::paintSurface(QPainter& painter) const {
    const Theme& theme = Theme::current();
    painter.setRenderHint(QPainter::Antialiasing);
    QColor fill = underMouse() && isEnabled() ? theme.hover : theme.raised;
    QPen border(theme.border, 1);
    if (confirmed_) {
        fill = theme.movingTint;
        border = QPen(theme.moving, 2);
    } else if (isDown()) {
        border = QPen(theme.secondary, 2);
    } else if (!isEnabled()) {
        fill = theme.panel;
    }
    const double inset = border.widthF() / 2;
    painter.setPen(border);
    painter.setBrush(fill);
    painter.drawRoundedRect(QRectF(rect()).adjusted(inset, inset, -inset, -inset), kCornerRadius,
                            kCornerRadius);
}

void HoldToRunButton::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    paintSurface(painter);
    painter.setPen(textColor());
    const QFont name = textFont(15);
    const QFont small = textFont(kDetailSize, showsHoldHint() ? QFont::Bold : QFont::Normal);
    const int nameHeight = QFontMetrics(name).height();
    const int both = nameHeight + QFontMetrics(small).height();
    painter.setFont(name);
    if (detail().isEmpty()) {
        painter.drawText(rect(), Qt::AlignCenter, text());
    } else if (both > height()) {
        // Without space for two lines, the temporary hint replaces the name.
        painter.drawText(rect(), Qt::AlignCenter, showsHoldHint() ? detail() : text());
    } else {
        const int top = (height() - both) / 2;
        painter.drawText(QRect(0, top, width(), nameHeight), Qt::AlignCenter, text());
        painter.setFont(small);
        painter.drawText(QRect(0, top + nameHeight, width(), both - nameHeight), Qt::AlignCenter, detail());
    }
}

void HoldToRunButton::mousePressEvent(QMouseEvent* event) {
    event->accept();
    if (event->button() == Qt::LeftButton && event->buttons() == Qt::LeftButton) {
        // Some window systems synthesize mouse events from touch events. Identify a finger by the device
        // type.
        const bool finger =
            event->device() != nullptr && event->device()->type() == QInputDevice::DeviceType::TouchScreen;
        guard_.press({finger ? HoldSource::By::Touch : HoldSource::By::Mouse});
    } else {
        guard_.tell(HoldEvent::Kind::PressedAgain);
    }
}

void HoldToRunButton::mouseDoubleClickEvent(QMouseEvent* event) {
    mousePressEvent(event);  // treat the second press of a double click as a normal press
}

void HoldToRunButton::mouseMoveEvent(QMouseEvent* event) {
    event->accept();
    if (!event->buttons().testFlag(Qt::LeftButton)) {
        guard_.release();  // the release was delivered to a different widget
        return;
    }
    guard_.pointerMoved(event->position().toPoint());
}

void HoldToRunButton::mouseReleaseEvent(QMouseEvent* event) {
    event->accept();
    if (event->button() == Qt::LeftButton) {
        guard_.release();
    }
}

void HoldToRunButton::keyPressEvent(QKeyEvent* event) {
    event->ignore();
}

void HoldToRunButton::keyReleaseEvent(QKeyEvent* event) {
    event->ignore();
}

void HoldToRunButton::wheelEvent(QWheelEvent* event) {
    event->accept();  // the wheel must not scroll the button away from the pointer
}

bool HoldToRunButton::event(QEvent* event) {
    switch (event->type()) {
        case QEvent::TouchBegin:
        case QEvent::TouchUpdate:
        case QEvent::TouchEnd:
        case QEvent::TouchCancel:
            return touchEvent(event);
        default:
            return QAbstractButton::event(event);
    }
}

bool HoldToRunButton::touchEvent(QEvent* event) {
    event->accept();
    // For a cancelled touch, HoldRules has already ended the motion.
    if (!isEnabled() || event->type() == QEvent::TouchCancel) {
        return true;
    }
    const auto* touch = static_cast<QTouchEvent*>(event);
    if (touch->points().size() != 1) {
        guard_.tell(HoldEvent::Kind::PressedAgain);
    } else if (event->type() == QEvent::TouchBegin) {
        guard_.press({HoldSource::By::Touch});
    } else if (event->type() == QEvent::TouchEnd) {
        guard_.release();
    } else {
        guard_.pointerMoved(touch->points().first().position().toPoint());
    }
    return true;
}

}  // namespace tiller

#include "moc_hold_to_run_button.cpp"
