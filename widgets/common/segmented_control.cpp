// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/segmented_control.h"

#include <QAbstractButton>
#include <QButtonGroup>
#include <QFocusEvent>
#include <QHBoxLayout>
#include <QPainter>
#include <QPainterPath>
#include <QWheelEvent>
#include <algorithm>

#include "widgets/common/density.h"
#include "widgets/common/theme.h"

namespace tiller {

namespace {

/// One segment. The segments at the ends of the row have rounded corners.
class Segment : public QAbstractButton {
public:
    Segment(const QString& label, bool first, bool last, QWidget* parent)
        : QAbstractButton(parent), first_(first), last_(last) {
        setText(label);
        setCheckable(true);
        setFocusPolicy(Qt::TabFocus);
        setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
        setAttribute(Qt::WA_Hover);
    }

    QSize sizeHint() const override {
        // Measure with the bold font, so that selecting a segment does not move its neighbours.
        const QFontMetrics metrics(textFont(15, QFont::Bold));
        return {metrics.horizontalAdvance(text()) + 16, std::max(38, touchHeight())};
    }
    QSize minimumSizeHint() const override {
        const QFontMetrics metrics(textFont(15));
        return {metrics.horizontalAdvance(text()) + 6, std::max(30, touchHeight())};
    }

protected:
    void paintEvent(QPaintEvent*) override {
        const Theme& theme = Theme::current();
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        const double r = kCornerRadius - 1;
        // Adjacent borders overlap by one pixel, so that they appear as one line.
        const QRectF box = QRectF(rect()).adjusted(first_ ? 0.5 : -0.5, 0.5, -0.5, -0.5);
        QPainterPath path;
        path.setFillRule(Qt::WindingFill);
        path.addRoundedRect(box, r, r);
        if (!first_) {
            path.addRect(QRectF(box.left(), box.top(), r + 1, box.height()));
        }
        if (!last_) {
            path.addRect(QRectF(box.right() - r - 1, box.top(), r + 1, box.height()));
        }
        const bool chosen = isChecked();
        QColor fill = chosen ? theme.inverse : isDown() || underMouse() ? theme.hover : theme.raised;
        QColor ink = chosen ? theme.inverseText : theme.text;
        if (!isEnabled()) {
            fill = chosen ? theme.border : theme.panel;
            ink = theme.disabledText;
        }
        painter.setPen(theme.border);
        painter.setBrush(fill);
        painter.drawPath(path.simplified());
        if (hasFocus() && byKeyboard_) {
            painter.setPen(QPen(theme.moving, 2));
            painter.setBrush(Qt::NoBrush);
            painter.drawRoundedRect(QRectF(rect()).adjusted(2, 2, -2, -2), r - 1, r - 1);
        }
        painter.setFont(textFont(15, chosen ? QFont::Bold : QFont::Normal));
        painter.setPen(ink);
        painter.drawText(rect(), Qt::AlignCenter, text());
    }
    void focusInEvent(QFocusEvent* event) override {
        // Show the focus ring only for keyboard navigation.
        if (event->reason() != Qt::ActiveWindowFocusReason) {
            byKeyboard_ = event->reason() == Qt::TabFocusReason ||
                          event->reason() == Qt::BacktabFocusReason ||
                          event->reason() == Qt::ShortcutFocusReason;
        }
        QAbstractButton::focusInEvent(event);
    }
    void wheelEvent(QWheelEvent* event) override { event->ignore(); }

private:
    bool first_;
    bool last_;
    bool byKeyboard_ = false;
};

}  // namespace

namespace {

int stretchOf(const QWidget& segment) {
    return std::max({segment.sizeHint().width(), segment.minimumWidth(), 54});
}

}  // namespace

SegmentedControl::SegmentedControl(const QStringList& labels, QWidget* parent)
    : QWidget(parent), layout_(new QHBoxLayout(this)), group_(new QButtonGroup(this)) {
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    layout_->setContentsMargins(0, 0, 0, 0);
    layout_->setSpacing(0);
    group_->setExclusive(true);
    for (int i = 0; i < labels.size(); ++i) {
        auto* segment = new Segment(labels[i], i == 0, i == labels.size() - 1, this);
        segments_.append(segment);
        group_->addButton(segment, i);
        // The text of a segment determines its share of the width.
        layout_->addWidget(segment, stretchOf(*segment));
    }
    if (!segments_.isEmpty()) {
        segments_.first()->setChecked(true);
    }
    connect(group_, &QButtonGroup::idToggled, this, [this](int index, bool checked) {
        if (checked && index != current_) {
            current_ = index;
            Q_EMIT currentChanged(index);
        }
    });
}

void SegmentedControl::setCurrentIndex(int index) {
    if (index >= 0 && index < count()) {
        segments_[index]->setChecked(true);
    }
}

QString SegmentedControl::text(int index) const {
    return segments_.at(index)->text();
}

void SegmentedControl::setText(int index, const QString& text) {
    QAbstractButton* segment = segments_.at(index);
    if (segment->text() == text) {
        return;
    }
    segment->setText(text);
    nameSegment(index);
    layout_->setStretch(index, stretchOf(*segment));
    segment->updateGeometry();
}

void SegmentedControl::reserve(int index, const QString& widest) {
    QAbstractButton* segment = segments_.at(index);
    const QString now = segment->text();
    segment->setText(widest);
    segment->setMinimumWidth(segment->sizeHint().width());
    segment->setText(now);
    layout_->setStretch(index, stretchOf(*segment));
}

void SegmentedControl::setSegmentEnabled(int index, bool enabled, const QString& reason) {
    segments_.at(index)->setEnabled(enabled);
    segments_.at(index)->setToolTip(reason);
}

QAbstractButton* SegmentedControl::segment(int index) const {
    return segments_.at(index);
}

void SegmentedControl::setNames(const QString& objectName, const QString& accessibleName) {
    setObjectName(objectName);
    setAccessibleName(accessibleName);
    for (int i = 0; i < count(); ++i) {
        segments_[i]->setObjectName(QStringLiteral("%1.%2").arg(objectName).arg(i));
        nameSegment(i);
    }
}

void SegmentedControl::nameSegment(int index) {
    if (!accessibleName().isEmpty()) {
        segments_[index]->setAccessibleName(
            QStringLiteral("%1: %2").arg(accessibleName(), segments_[index]->text()));
    }
}

}  // namespace tiller

#include "moc_segmented_control.cpp"
