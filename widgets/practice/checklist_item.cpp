// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/practice/checklist_item.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>

#include "widgets/common/icons.h"
#include "widgets/common/theme.h"

namespace tiller {
namespace {

constexpr int kMark = 16;  // [px]
constexpr int kTickGap = 8;

}  // namespace

ChecklistItem::ChecklistItem(const QString& text, QWidget* parent)
    : QWidget(parent), text_(new QLabel(text, this)) {
    text_->setTextFormat(Qt::PlainText);
    text_->setWordWrap(true);
    text_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(kMark + kTickGap, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(text_);
    describe();
}

void ChecklistItem::setText(const QString& text) {
    if (text != text_->text()) {
        text_->setText(text);
        describe();
    }
}

QString ChecklistItem::text() const {
    return text_->text();
}

void ChecklistItem::setDone(bool done) {
    if (done != done_) {
        done_ = done;
        describe();
        update();
    }
}

void ChecklistItem::reserveLines(int lines) {
    text_->ensurePolished();
    text_->setMinimumHeight(lines * text_->fontMetrics().lineSpacing());
}

void ChecklistItem::describe() {
    setAccessibleName(text_->text());
    setAccessibleDescription(done_ ? tr("done") : tr("not done yet"));
}

void ChecklistItem::paintEvent(QPaintEvent*) {
    const Theme& theme = Theme::current();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    // Align with the first line of the text.
    const QRectF mark(0, (text_->fontMetrics().height() - kMark) / 2.0, kMark, kMark);
    if (done_) {
        themedIcon(QStringLiteral("check"), theme.text).paint(&painter, mark.toRect());
        return;
    }
    painter.setPen(QPen(theme.secondary, 1.4));
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(mark.adjusted(3, 3, -3, -3));
}

}  // namespace tiller

#include "moc_checklist_item.cpp"
