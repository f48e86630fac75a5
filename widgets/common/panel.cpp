// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/panel.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPainterPath>
#include <QVBoxLayout>

#include "widgets/common/elided_label.h"
#include "widgets/common/theme.h"

namespace tiller {

Panel::Panel(const QString& title, QWidget* parent)
    : QFrame(parent)
    , header_(new QWidget(this))
    , headerLayout_(new QHBoxLayout(header_))
    , layout_(new QVBoxLayout(this))
    , title_(new QLabel(title, header_))
    , subtitle_(new QLabel(header_))
    , hint_(new ElidedLabel({}, header_)) {
    setAccessibleName(title);
    layout_->setContentsMargins(1, 1, 1, 1);
    layout_->setSpacing(0);
    // The header may be taller than this value, depending on its content and the density.
    header_->setMinimumHeight(kHeaderHeight);
    header_->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    headerLayout_->setContentsMargins(12, 0, 12, 0);
    headerLayout_->setSpacing(10);

    title_->setFont(textFont(15, QFont::Bold));
    title_->setTextFormat(Qt::PlainText);
    subtitle_->setFont(textFont(14));
    subtitle_->setTextFormat(Qt::PlainText);
    subtitle_->setProperty("role", QStringLiteral("secondary"));
    subtitle_->hide();
    hint_->setFont(textFont(13));
    hint_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    hint_->setProperty("role", QStringLiteral("secondary"));
    headerLayout_->addWidget(title_);
    headerLayout_->addWidget(subtitle_);
    headerLayout_->addWidget(hint_, 1);
    layout_->addWidget(header_);
    layout_->addSpacing(1);
    setContent(new QWidget(this));
}

QString Panel::title() const {
    return title_->text();
}

void Panel::setTitle(const QString& title) {
    title_->setText(title);
    setAccessibleName(title);
}

void Panel::setSubtitle(const QString& text) {
    subtitle_->setText(text);
    subtitle_->setVisible(!text.isEmpty());
}

void Panel::setHint(const QString& text) {
    hint_->setFullText(text);
}

void Panel::addHeaderWidget(QWidget* widget) {
    headerLayout_->addWidget(widget, 0, Qt::AlignVCenter);
}

void Panel::addFoldingHeaderWidget(QWidget* widget) {
    if (folding_.isEmpty()) {
        // Exclude folding widgets from the minimum width. foldHeader() sets the minimum width instead.
        header_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
        header_->installEventFilter(this);
    }
    folding_.append(widget);
    addHeaderWidget(widget);
}

bool Panel::eventFilter(QObject* watched, QEvent* event) {
    if (watched == header_ && (event->type() == QEvent::Resize || event->type() == QEvent::LayoutRequest)) {
        foldHeader();
    }
    return QFrame::eventFilter(watched, event);
}

void Panel::foldHeader() {
    const auto widthOf = [this](const QWidget* widget) {
        return widget->sizeHint().expandedTo(widget->minimumSize()).width() + headerLayout_->spacing();
    };
    int least = headerLayout_->minimumSize().width();
    for (const QWidget* widget : folding_) {
        least -= widget->isHidden() ? 0 : widthOf(widget);
    }
    header_->setMinimumWidth(least);
    // Show as many folding widgets as fit, starting with the last.
    int room = header_->width() - least;
    for (auto widget = folding_.crbegin(); widget != folding_.crend(); ++widget) {
        room -= widthOf(*widget);
        (*widget)->setVisible(room >= 0);
    }
}

void Panel::setHeaderWidget(QWidget* widget) {
    title_->hide();
    subtitle_->hide();
    hint_->hide();
    headerLayout_->setContentsMargins(0, 0, 6, 0);  // keep the rightmost widget away from the border
    headerLayout_->insertWidget(0, widget, 1);
}

void Panel::setContent(QWidget* content) {
    if (content_ != nullptr) {
        layout_->removeWidget(content_);
        content_->deleteLater();
    }
    content_ = content;
    layout_->addWidget(content, 1);
}

void Panel::paintEvent(QPaintEvent* event) {
    const Theme& theme = Theme::current();
    QPainter painter(this);
    // If only content inside this rectangle is repainted, the corners and the separator do not have to be
    // drawn.
    const QRect inside(kCornerRadius, header_->geometry().bottom() + 2, width() - 2 * kCornerRadius,
                       height() - header_->geometry().bottom() - 2 - kCornerRadius);
    if (inside.contains(event->rect())) {
        painter.fillRect(event->rect(), theme.panel);
        return;
    }
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(theme.border);
    painter.setBrush(theme.panel);
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), kCornerRadius, kCornerRadius);
    painter.setRenderHint(QPainter::Antialiasing, false);
    const int y = header_->geometry().bottom() + 1;
    painter.drawLine(1, y, width() - 2, y);
}

}  // namespace tiller

#include "moc_panel.cpp"
