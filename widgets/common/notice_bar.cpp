// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/notice_bar.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QVBoxLayout>

#include "widgets/common/theme.h"

namespace tiller {

NoticeBar::NoticeBar(QWidget* parent)
    : QFrame(parent)
    , title_(new QLabel)
    , text_(new QLabel)
    , accept_(new QPushButton)
    , dismiss_(new QPushButton) {
    setObjectName(QStringLiteral("notice"));
    setAccessibleName(tr("Notice"));
    title_->setObjectName(QStringLiteral("notice.title"));
    title_->setWordWrap(true);
    title_->setProperty("role", "strong");
    text_->setObjectName(QStringLiteral("notice.text"));
    text_->setWordWrap(true);
    text_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    accept_->setObjectName(QStringLiteral("notice.accept"));
    accept_->setAccessibleName(tr("Accept"));
    accept_->setProperty("primary", true);
    dismiss_->setObjectName(QStringLiteral("notice.dismiss"));
    dismiss_->setAccessibleName(tr("Dismiss"));

    // Apart from each other: what a notice is answered with brings the next one at times, and a second click
    // must not close that one unread.
    auto* keys = new QHBoxLayout;
    keys->addWidget(dismiss_);
    keys->addStretch();
    keys->addWidget(accept_);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(12, 10, 12, 10);
    layout->setSpacing(6);
    layout->addWidget(title_);
    layout->addWidget(text_);
    layout->addLayout(keys);

    connect(accept_, &QPushButton::clicked, this, [this] {
        const std::function<void()> accepted = std::move(accepted_);
        dismiss();
        if (accepted) {
            accepted();
        }
    });
    connect(dismiss_, &QPushButton::clicked, this, &NoticeBar::dismiss);
    hide();
}

void NoticeBar::show(Kind kind, const QString& title, const QString& text, const QString& accept,
                     std::function<void()> accepted) {
    kind_ = kind;
    accepted_ = std::move(accepted);
    title_->setText(kind == Kind::Warning ? QStringLiteral("▲ ") + title : title);
    text_->setText(text);
    text_->setVisible(!text.isEmpty());
    accept_->setText(accept);
    accept_->setAccessibleName(accept);
    accept_->setVisible(!accept.isEmpty());
    dismiss_->setText(accept.isEmpty() ? tr("Close") : tr("Cancel"));
    dismiss_->setAccessibleName(dismiss_->text());
    setAccessibleDescription(title + QLatin1Char(' ') + text);
    QPalette colors = palette();
    const Theme& theme = Theme::current();
    colors.setColor(QPalette::WindowText, kind == Kind::Warning ? theme.warning : theme.text);
    title_->setPalette(colors);
    QFrame::show();
    update();
}

void NoticeBar::dismiss() {
    accepted_ = {};
    hide();
}

QString NoticeBar::title() const {
    return title_->text();
}

QString NoticeBar::text() const {
    return text_->text();
}

void NoticeBar::paintEvent(QPaintEvent*) {
    const Theme& theme = Theme::current();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(kind_ == Kind::Warning ? theme.warning : theme.moving, 1));
    painter.setBrush(kind_ == Kind::Warning ? theme.warningBackground : theme.raised);
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), kCornerRadius, kCornerRadius);
}

void NoticeBar::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape) {
        dismiss();
    } else {
        QFrame::keyPressEvent(event);
    }
}

}  // namespace tiller

#include "moc_notice_bar.cpp"
