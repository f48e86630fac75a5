// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/jog/pose_view.h"

#include <QFocusEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <utility>

#include "robot/core/angles.h"
#include "robot/station/text/format.h"
#include "robot/station/text/notation.h"
#include "widgets/common/theme.h"

namespace tiller {

namespace {

constexpr int kDigitPeriodMs = 100;
constexpr int kCaptionHeight = 17;
/// The arm counts as stopped below these speeds, because the measured speed is noisy at standstill.
constexpr double kStandstillTolerance = 5e-5;  // [m/s]
constexpr double kTurnsNot = toRadians(0.5);   // [rad/s]
constexpr double kAtFlange = 5e-5;             // TCP offsets below this length count as "at the flange" [m]

/// Formats with two decimals at standstill. During motion, uses one decimal and a space, so that the width is
/// constant.
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
    setFocusPolicy(Qt::TabFocus);
    setAttribute(Qt::WA_OpaquePaintEvent);  // paintEvent() fills the whole widget
    describe();
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    pace_.setSingleShot(true);
    pace_.setInterval(kDigitPeriodMs);
    connect(&pace_, &QTimer::timeout, this, [this] {
        if (std::exchange(pending_, false)) {
            updateValueTexts();
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
    changed(look);
}

void PoseView::changed(bool atOnce) {
    if (atOnce) {
        shown_.clear();
    }
    if (atOnce || !pace_.isActive()) {
        updateValueTexts();
    } else {
        pending_ = true;
    }
}

QStringList PoseView::figures() const {
    QStringList texts{speedText()};
    for (int axis = 0; axis < 3; ++axis) {
        texts << positionText(axis) << deltaText(axis) << rotationText(axis);
    }
    return texts;
}

// Repaints only if a displayed text has changed. The noise at standstill is smaller than the displayed
// digits.
void PoseView::updateValueTexts() {
    if (const QStringList now = figures(); now != shown_) {
        shown_ = now;
        update();
    }
    pace_.start();
}

void PoseView::setFrame(const QString& name, const Pose& T_base_frame) {
    if (name == frame_ && T_base_frame == T_base_frame_) {
        return;
    }
    frame_ = name;
    T_base_frame_ = T_base_frame;
    describe();
    changed(true);
}

void PoseView::setTcp(const Pose& offset) {
    if (!(offset == tcp_)) {
        tcp_ = offset;
        describe();
        changed(true);
    }
}

void PoseView::setSpeed(const Twist& tcpSpeed) {
    const QString before = speedText();
    speed_ = tcpSpeed;
    if (speedText() != before) {
        changed(false);
    }
}

void PoseView::setFactor(double factor) {
    if (factor != factor_) {
        factor_ = factor;
        changed(true);
    }
}

Eigen::Vector3d PoseView::inFrame(const Eigen::Vector3d& way) const {
    return rotationMatrix(T_base_frame_.rotation).transpose() * way;
}

QString PoseView::frameText() const {
    const double reach = tcp_.position.norm();
    const QString tcp = reach < kAtFlange ? tr("TCP at the flange")
                                          : tr("TCP %1 from the flange").arg(format::length(reach, 1));
    return tr("in %1 · %2").arg(frame_, tcp);
}

QString PoseView::speedText() const {
    if (!valid_) {
        return dash();
    }
    const double linear = speed_.linear.norm();
    const double turn = speed_.angular.norm();
    const double shown = linear < kStandstillTolerance ? 0 : linear;
    const QString way =
        format::lengthNumber(shown, shown < 0.010 ? 1 : 0, false) + QLatin1Char(' ') + format::speedUnit();
    return turn < kTurnsNot ? way : tr("%1 · %2").arg(way, format::degreesPerSecond(turn));
}

QString PoseView::factorText() const {
    return factor_ == 1 ? QString() : QStringLiteral("× ") + format::number(factor_, factor_ < 1 ? 1 : 0);
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
    const QString name = tr("TCP pose in %1").arg(frame_);
    setAccessibleName(name);
    setToolTip(name + QStringLiteral(", ") +
               (ownZero_ ? tr("orientation as set in Settings. Δ₀: displacement from the zero position. "
                              "Click to show the displacement since the start of the last motion.")
                         : tr("orientation as set in Settings. Δ: displacement since the start of the last "
                              "motion. Click to set the displacement to zero.")) +
               QLatin1Char('\n') + tr("TCP in the flange frame: %1").arg(format::pose(tcp_)));
    setAccessibleDescription(toolTip());
}

QString PoseView::positionText(int axis) const {
    return valid_ ? paced(inFrame(pose_.position - T_base_frame_.position)[axis], moving_) : dash();
}

QString PoseView::deltaText(int axis) const {
    return valid_ ? paced(inFrame(pose_.position - zero_)[axis], moving_) : dash();
}

/// Like deltaText(axis), but with fewer decimals if necessary to fit into `space` [px].
QString PoseView::deltaText(int axis, const QFont& font, int space) const {
    const QFontMetrics metrics(font);
    QString text = deltaText(axis);
    for (int digits = 1; valid_ && digits >= 0 && metrics.horizontalAdvance(text) > space; --digits) {
        text = format::lengthNumber(inFrame(pose_.position - zero_)[axis], digits, true);
    }
    return text;
}

QString PoseView::rotationText(int axis) const {
    if (!valid_) {
        return dash();
    }
    const Eigen::Vector3d turned =
        rotationVector(rotationMatrix(T_base_frame_.rotation).transpose() * rotationMatrix(pose_.rotation));
    return format::rotation(turned)[static_cast<std::size_t>(axis)];
}

void PoseView::paintEvent(QPaintEvent*) {
    const Theme& theme = Theme::current();
    QPainter painter(this);
    painter.fillRect(rect(), theme.panel);
    const double rowHeight = (height() - kCaptionHeight) / 3.0;
    const QColor ink = valid_ && !stale_ ? theme.text : theme.disabledText;
    const QFont value = textFont(19);
    const bool narrow = width() < 352;
    const QFont label = textFont(narrow ? 13 : 15);
    const int number = narrow ? 104 : 110;  // right edge of the position
    const int delta = narrow ? 203 : 226;   // right edge of the distance
    static constexpr const char* kAxes[] = {"X", "Y", "Z"};
    static constexpr const char* kTurns[] = {"RX", "RY", "RZ"};
    const int right = width();
    if (hasFocus() && focusByKey_) {
        painter.setPen(QPen(theme.moving, 2));
        painter.drawRect(rect().adjusted(1, 1, -2, -2));
    }
    // The speed always fits. The frame name may be elided, and the tooltip then shows the full name.
    const QRect caption(4, 0, right - 6, kCaptionHeight);
    painter.setFont(textFont(13, QFont::Bold));
    const QString factor = factorText();
    const int factorWidth = factor.isEmpty() ? 0 : painter.fontMetrics().horizontalAdvance(factor) + 8;
    const QFont small = textFont(13);
    const int speedWidth = QFontMetrics(small).horizontalAdvance(speedText());
    painter.setPen(theme.text);
    painter.drawText(caption.adjusted(0, 0, -speedWidth - 8, 0), Qt::AlignRight | Qt::AlignVCenter, factor);
    painter.setFont(small);
    painter.setPen(ink);
    painter.drawText(caption, Qt::AlignRight | Qt::AlignVCenter, speedText());
    painter.setPen(theme.secondary);
    painter.drawText(caption, Qt::AlignLeft | Qt::AlignVCenter,
                     painter.fontMetrics().elidedText(frameText(), Qt::ElideRight,
                                                      caption.width() - speedWidth - factorWidth - 8));
    for (int axis = 0; axis < 3; ++axis) {
        const int top = kCaptionHeight + static_cast<int>(axis * rowHeight);
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
        const QString sign = ownZero_ ? QStringLiteral("Δ₀") : QStringLiteral("Δ");
        const int signLeft = number + (narrow ? 33 : 43);
        put(label, theme.secondary, signLeft, 20, Qt::AlignLeft, sign);
        const int space = delta - signLeft - QFontMetrics(label).horizontalAdvance(sign) - 2;
        put(label, theme.secondary, delta - space, space, Qt::AlignRight, deltaText(axis, label, space));
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

void PoseView::changeEvent(QEvent* event) {
    if (event->type() == QEvent::StyleChange) {
        describe();  // units may have changed
    }
    QWidget::changeEvent(event);
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

#include "moc_pose_view.cpp"
