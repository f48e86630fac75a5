// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/jog/joint_rows.h"

#include <QGridLayout>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "robot/core/angles.h"
#include "robot/core/robot_model.h"
#include "robot/station/text/format.h"
#include "robot/station/text/joint_name.h"
#include "widgets/common/density.h"
#include "widgets/common/theme.h"

namespace tiller {

namespace {

constexpr double kWarnAngle = toRadians(15);
constexpr int kNameSize = 15;   // [px]
constexpr int kRowMargin = 12;  // same as the margin of the panel's content
constexpr int kNumberPeriodMs = 100;
constexpr int kSpeedWidth = 56;    // width of "0.36 °/s" before the bar of a compact row [px]
constexpr int kBarWithSpeed = 34;  // minimum remaining width of the bar [px]

}  // namespace

JointBar::JointBar(QWidget* parent) : QWidget(parent) {
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAttribute(
        Qt::WA_OpaquePaintEvent);  // the row is repainted often, so do not paint the background each time
}

bool JointBar::isNearLimit() const {
    return valid_ && kJointPositionLimit - std::abs(angle_) < kWarnAngle;
}

void JointBar::setAngle(double angle, bool valid) {
    // Repaint only if the marker moves by a quarter of a pixel, which is visible because of subpixel drawing.
    const auto looks = [this] { return std::tuple(valid_, isNearLimit(), std::lround(4 * place())); };
    const auto before = looks();
    angle_ = angle;
    valid_ = valid;
    if (looks() != before) {
        update();
    }
}

double JointBar::place() const {
    const double share = std::clamp((angle_ / kJointPositionLimit + 1) / 2, 0.0, 1.0);
    return (2 + share * (width() - 4)) * devicePixelRatioF();
}

void JointBar::paintEvent(QPaintEvent*) {
    const Theme& theme = Theme::current();
    QPainter painter(this);
    painter.fillRect(rect(), theme.panel);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    const double track = std::min(8.0, height() - 4.0);
    const QRectF groove(0, (height() - track) / 2, width(), track);
    painter.setBrush(theme.border);
    painter.drawRoundedRect(groove, track / 2, track / 2);
    if (!valid_) {
        return;
    }
    const double x = place() / devicePixelRatioF();
    if (isNearLimit()) {
        const QRectF end = angle_ < 0 ? QRectF(groove.left(), groove.top(), std::max(x, 14.0), track)
                                      : QRectF(std::min(x, width() - 14.0), groove.top(),
                                               std::max(width() - x, 14.0), track);
        painter.setBrush(theme.warning);
        painter.drawRoundedRect(end, track / 2, track / 2);
    }
    painter.setBrush(isEnabled() ? theme.text : theme.disabledText);
    painter.drawRoundedRect(QRectF(x - 2, (height() - track) / 2 - 3, 4, track + 6), 2, 2);
}

JointRow::JointRow(int joint, HoldPolicy& policy, QWidget* parent)
    : QWidget(parent)
    , joint_(joint)
    , name_(jointName(joint))
    , value_(QStringLiteral("–"))
    , minus_(new HoldToRunButton(QString(QChar(0x2212)), policy, this))
    , plus_(new HoldToRunButton(QStringLiteral("+"), policy, this))
    , bar_(new JointBar(this)) {
    setObjectName(QStringLiteral("joint.%1").arg(joint));
    setAccessibleName(name_);
    minus_->setObjectName(QStringLiteral("joint.%1.minus").arg(joint));
    plus_->setObjectName(QStringLiteral("joint.%1.plus").arg(joint));
    bar_->setObjectName(QStringLiteral("joint.%1.bar").arg(joint));
    minus_->setAccessibleName(tr("%1 minus").arg(name_));
    plus_->setAccessibleName(tr("%1 plus").arg(name_));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

QSize JointRow::sizeHint() const {
    return {compact_ ? 170 : 330, heightWhen(compact_, low_)};
}

int JointRow::heightWhen(bool compact, bool low) {
    const int finger = touchHeight() > 0 ? touchHeight() + 2 : 0;
    return std::max(compact ? 29 : low ? 28 : 40, finger);
}

QString JointRow::shortName() const {
    // Common abbreviations: B, S, E, W1, W2, W3.
    const qsizetype space = name_.indexOf(QLatin1Char(' '));
    return space < 0 ? name_.left(1) : name_.left(1) + name_.mid(space + 1);
}

void JointRow::setCompact(bool compact) {
    compact_ = compact;
    describe();
    updateGeometry();
    resizeEvent(nullptr);
}

void JointRow::setLow(bool low) {
    low_ = low;
    updateGeometry();
    resizeEvent(nullptr);
}

void JointRow::setAngle(double angle, bool moving, bool valid, bool stale) {
    QString text = QStringLiteral("–");
    if (valid) {
        text = format::number(toDegrees(angle), moving || compact_ ? 1 : 2) + QStringLiteral("°") +
               (moving && !compact_ ? QString(QChar(0x2007)) : QString());
    }
    bar_->setAngle(angle, valid);
    value_ = text;
    grey_ = !valid || stale;
}

void JointRow::setSpeed(const QString& speed) {
    if (speed == speed_) {
        return;
    }
    speed_ = speed;
    describe();
    update(speedWidth_ > 0 ? speedRect() : textRect());
}

/// Returns the width of the longest joint name, for aligning all rows [px].
int JointRow::nameRoom() const {
    constexpr int kMinValue = 86;
    constexpr int kApart = 8;
    const QFontMetrics metrics(textFont(kNameSize));
    int room = kMinValue;
    for (int joint = 0; joint < kJointCount; ++joint) {
        room = std::max(room, metrics.horizontalAdvance(jointName(joint)) + kApart);
    }
    return room;
}

QFont JointRow::nameFont() const {
    constexpr int kSmallest = 11;
    int size = compact_ ? 13 : kNameSize;
    if (!compact_) {
        const int room = textRect().width() - QFontMetrics(textFont(19)).horizontalAdvance(value_);
        while (size > kSmallest && QFontMetrics(textFont(size)).horizontalAdvance(name_) > room) {
            --size;
        }
    }
    return textFont(size);
}

bool JointRow::isNameApart() const {
    return compact_ || QFontMetrics(nameFont()).horizontalAdvance(name_) +
                               QFontMetrics(textFont(19)).horizontalAdvance(value_) <=
                           textRect().width();
}

QRect JointRow::speedRect() const {
    const int left = minus_->geometry().right() + 1;
    return {left, 0, bar_->x() - left, height() - 1};
}

/// Adds the speed to the tooltip if the row has no space for it.
void JointRow::describe() {
    const QString speed = speed_.isEmpty() ? name_ : tr("%1: %2").arg(name_, speed_);
    setToolTip(compact_ || (low_ && speedWidth_ == 0) ? speed : QString());
    setAccessibleDescription(speed_);
}

void JointRow::showNumber() {
    if (value_ != shown_) {
        shown_ = value_;
        update(textRect());
    }
}

QRect JointRow::textRect() const {
    const int left = compact_ ? 0 : kRowMargin;
    const int lower = compact_ ? 9 : 1;
    return {left, 0, minus_->x() - left - 10, height() - lower};
}

void JointRow::resizeEvent(QResizeEvent*) {
    const int middle = height() / 2;
    const int finger = touchHeight();
    const int high = std::max(26, finger);
    speedWidth_ = 0;
    if (compact_) {
        // The width of the angle text limits the button width.
        const int wide = finger > 0 ? 36 : 26;
        plus_->setGeometry(width() - wide, middle - high / 2, wide, high);
        minus_->setGeometry(width() - 2 * wide - 3, middle - high / 2, wide, high);
        bar_->setGeometry(0, height() - 9, width() - 2 * wide - 12, 8);
        return;
    }
    const int wide = finger > 0 ? 44 : 35;
    plus_->setGeometry(width() - kRowMargin - wide, middle - high / 2, wide, high);
    int bar = std::max(40, std::min(94, width() - 2 * kRowMargin - nameRoom() - 92 - wide * 2 - 24));
    // A low row shows the speed before the bar if there is enough space.
    speedWidth_ = low_ && bar >= kBarWithSpeed + kSpeedWidth ? kSpeedWidth : 0;
    bar -= speedWidth_;
    bar_->setGeometry(plus_->x() - 9 - bar, middle - 8, bar, 16);
    minus_->setGeometry(bar_->x() - 9 - speedWidth_ - wide, middle - high / 2, wide, high);
    describe();
}

void JointRow::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::StyleChange) {
        updateGeometry();  // the density may have changed
        resizeEvent(nullptr);
        update();
    }
}

void JointRow::paintEvent(QPaintEvent*) {
    const Theme& theme = Theme::current();
    QPainter painter(this);
    const QRect text = textRect();
    // Next to wide buttons, there is no space for both texts on one line, but tall rows have space for two
    // lines.
    const bool two = compact_ && touchHeight() > 0;
    painter.setPen(theme.text);
    painter.setFont(nameFont());
    // A row of full height shows the speed below the name.
    const bool named = !compact_ && !low_ && !speed_.isEmpty();
    painter.drawText(text, Qt::AlignLeft | (two || named ? Qt::AlignTop : Qt::AlignVCenter),
                     compact_ ? shortName() : name_);
    if (named) {
        painter.setFont(textFont(13));
        painter.setPen(theme.secondary);
        painter.drawText(text, Qt::AlignLeft | Qt::AlignBottom, speed_);
    }
    painter.setFont(textFont(compact_ ? 15 : 19));
    painter.setPen(grey_ ? theme.disabledText : theme.text);
    painter.drawText(text, Qt::AlignRight | (two ? Qt::AlignBottom : Qt::AlignVCenter), value_);
    if (speedWidth_ > 0) {
        painter.setFont(textFont(13));
        painter.setPen(theme.secondary);
        painter.drawText(speedRect(), Qt::AlignCenter, speed_);
    }
    if (!compact_) {
        painter.setPen(theme.border);
        painter.drawLine(0, height() - 1, width(), height() - 1);
    }
}

JointRows::JointRows(HoldPolicy& policy, QWidget* parent) : QWidget(parent), grid_(new QGridLayout(this)) {
    setObjectName(QStringLiteral("jointRows"));
    setAccessibleName(tr("Joints"));
    grid_->setSpacing(0);
    pace_.setSingleShot(true);
    pace_.setInterval(kNumberPeriodMs);
    connect(&pace_, &QTimer::timeout, this, [this] {
        if (std::exchange(pending_, false)) {
            showNumbers();
        }
    });
    for (int joint = 0; joint < kJointCount; ++joint) {
        rows_.append(new JointRow(joint, policy, this));
    }
    arrange();
}

void JointRows::arrange() {
    for (JointRow* row : rows_) {
        grid_->removeWidget(row);
    }
    grid_->setContentsMargins(compact_ ? kRowMargin : 0, 0, compact_ ? kRowMargin : 0, 0);
    grid_->setHorizontalSpacing(compact_ ? 16 : 0);
    for (int joint = 0; joint < kJointCount; ++joint) {
        rows_[joint]->setCompact(compact_);
        if (compact_) {
            grid_->addWidget(rows_[joint], joint % 3, joint / 3);
        } else {
            grid_->addWidget(rows_[joint], joint, 0);
        }
    }
    grid_->setColumnStretch(0, 1);
    grid_->setColumnStretch(1, compact_ ? 1 : 0);
}

void JointRows::setCompact(bool compact) {
    if (compact != compact_) {
        compact_ = compact;
        arrange();
    }
}

int JointRows::heightWhen(bool pairs, bool low) {
    return (pairs ? kJointCount / 2 : kJointCount) * JointRow::heightWhen(pairs, low);
}

void JointRows::setLow(bool low) {
    for (JointRow* row : rows_) {
        row->setLow(low);
    }
}

void JointRows::setJoints(const JointPositions& q, bool moving, bool valid, bool stale) {
    const bool other = moving != moving_ || valid != valid_ || stale != stale_;
    moving_ = moving;
    valid_ = valid;
    stale_ = stale;
    for (JointRow* row : rows_) {
        row->setAngle(q[row->joint()], moving, valid, stale);
        if (other) {
            row->update();
        }
    }
    if (other || !pace_.isActive()) {
        showNumbers();
    } else {
        pending_ = true;
    }
}

void JointRows::showNumbers() {
    for (JointRow* row : rows_) {
        row->showNumber();
    }
    pace_.start();
}

}  // namespace tiller

#include "moc_joint_rows.cpp"
