// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/notice_bar.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QVBoxLayout>

#include "widgets/common/single_click.h"
#include "widgets/common/theme.h"

namespace tiller {

namespace {

constexpr int kMinKeyWidth = 112;  // wide enough for most texts, so that the button keeps its place

}  // namespace

NoticeBar::NoticeBar(QWidget* parent)
    : QFrame(parent)
    , title_(new QLabel)
    , text_(new QLabel)
    , accept_(new QPushButton)
    , other_(new QPushButton)
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
    accept_->setAccessibleName(tr("Notice action"));
    accept_->setProperty("primary", true);
    // The next notice may appear immediately at the same place.
    accept_->setMinimumWidth(kMinKeyWidth);
    new SingleClick(*accept_);
    other_->setObjectName(QStringLiteral("notice.other"));
    other_->setAccessibleName(tr("Second notice action"));
    dismiss_->setObjectName(QStringLiteral("notice.dismiss"));
    dismiss_->setAccessibleName(tr("Dismiss"));

    // Keep the close button apart from the other buttons. The response to a notice may open the next notice,
    // and a second click must not close that notice unread.
    auto* keys = new QHBoxLayout;
    keys->addWidget(dismiss_);
    keys->addStretch();
    keys->addWidget(other_);
    keys->addWidget(accept_);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(12, 10, 12, 10);
    layout->setSpacing(6);
    layout->addWidget(title_);
    layout->addWidget(text_);
    layout->addLayout(keys);

    connect(accept_, &QPushButton::clicked, this, [this] { answer(&Notice::accepted); });
    connect(other_, &QPushButton::clicked, this, [this] { answer(&Notice::otherAccepted); });
    connect(dismiss_, &QPushButton::clicked, this, &NoticeBar::dismiss);
    hide();
}

void NoticeBar::answer(std::function<void()> Notice::*callback) {
    const std::function<void()> run = notice_.*callback;
    dismiss();
    if (run) {
        run();
    }
}

void NoticeBar::show(Kind kind, const QString& title, const QString& text, const QString& accept,
                     std::function<void()> accepted) {
    show(kind, {.title = title, .text = text, .accept = accept, .accepted = std::move(accepted)});
}

void NoticeBar::show(Kind kind, const Notice& notice) {
    if (!notice.cause.isEmpty()) {
        std::erase_if(waiting_,
                      [&notice](const Waiting& other) { return other.notice.cause == notice.cause; });
    }
    if (!isHidden() && !notice_.cause.isEmpty() && notice_.cause != notice.cause) {
        waiting_.push_back({kind_, notice_});
    }
    display(kind, notice);
}

void NoticeBar::display(Kind kind, const Notice& notice) {
    kind_ = kind;
    notice_ = notice;
    title_->setText(kind == Kind::Warning ? QStringLiteral("▲ ") + notice.title : notice.title);
    setText(notice.liveText ? notice.liveText() : notice.text);
    accept_->setText(notice.accept);
    accept_->setAccessibleName(notice.accept.isEmpty() ? tr("Notice action") : notice.accept);
    accept_->setVisible(!notice.accept.isEmpty());
    other_->setText(notice.other);
    other_->setAccessibleName(notice.other.isEmpty() ? tr("Second notice action") : notice.other);
    other_->setVisible(!notice.other.isEmpty());
    dismiss_->setText(!notice.dismiss.isEmpty() ? notice.dismiss
                      : notice.accept.isEmpty() ? tr("Close")
                                                : tr("Cancel"));
    dismiss_->setAccessibleName(dismiss_->text());
    QPalette colors = palette();
    const Theme& theme = Theme::current();
    colors.setColor(QPalette::WindowText, kind == Kind::Warning ? theme.warning : theme.text);
    title_->setPalette(colors);
    QFrame::show();
    update();
}

void NoticeBar::setText(const QString& text) {
    text_->setText(text);
    text_->setVisible(!text.isEmpty());
    setAccessibleDescription(notice_.title + QLatin1Char(' ') + text);
}

void NoticeBar::refresh() {
    if (isHidden() || !notice_.liveText) {
        return;
    }
    if (const QString text = notice_.liveText(); text != text_->text()) {
        setText(text);
    }
}

void NoticeBar::dismiss() {
    notice_ = {};
    hide();
    if (!waiting_.empty()) {
        const Waiting next = waiting_.back();
        waiting_.pop_back();
        display(next.kind, next.notice);
    }
}

void NoticeBar::dismissWithoutCause() {
    if (notice_.cause.isEmpty()) {
        dismiss();
    }
}

void NoticeBar::resolve(const QString& cause) {
    std::erase_if(waiting_, [&cause](const Waiting& other) { return other.notice.cause == cause; });
    if (!isHidden() && notice_.cause == cause) {
        dismiss();
    }
}

void NoticeBar::dismissQuestion() {
    if (!isHidden() && notice_.cause.isEmpty() && notice_.accepted) {
        dismiss();
    }
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
