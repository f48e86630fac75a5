// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/practice/view_card.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QScrollBar>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "widgets/common/icons.h"
#include "widgets/common/no_focus_scroll_area.h"
#include "widgets/common/theme.h"

namespace tiller {
namespace {

constexpr int kGap = 8;          // distance from the edges of the view [px]
constexpr int kMargin = 10;      // margin around the content [px]
constexpr int kHeadMargin = 6;   // margin above and below the title [px]
constexpr int kMinContent = 44;  // [px]; with less height, the card is folded

QToolButton* quietKey(const QString& name, const QString& text, QWidget* parent) {
    auto* key = new QToolButton(parent);
    key->setObjectName(name);
    key->setAccessibleName(text);
    key->setToolTip(text);
    key->setProperty("quiet", true);
    key->setFocusPolicy(Qt::TabFocus);  // a click does not change the focus
    return key;
}

}  // namespace

ViewCard::ViewCard(const QString& name, const QString& title, int height, QWidget& view)
    : QFrame(&view)
    , view_(view)
    , height_(height)
    , title_(new QLabel(title, this))
    , fold_(quietKey(name + QStringLiteral(".fold"), tr("Collapse"), this))
    , close_(quietKey(name + QStringLiteral(".close"), tr("Close"), this))
    , scroll_(new NoFocusScrollArea(this))
    , inside_(new QWidget)
    , foot_(new QWidget(this)) {
    setObjectName(name);
    setAccessibleName(title);
    hide();
    title_->setFont(textFont(15, QFont::Bold));
    title_->setTextFormat(Qt::PlainText);
    // Use symbols, so that the buttons have the same width in all languages.
    close_->setText(QStringLiteral("×"));
    fold_->setCheckable(true);

    contentLayout_ = new QVBoxLayout(inside_);
    contentLayout_->setContentsMargins(0, 0, 0, 0);
    contentLayout_->setSpacing(5);
    scroll_->setObjectName(name + QStringLiteral(".text"));
    scroll_->setAccessibleName(title);
    scroll_->setFrameShape(QFrame::NoFrame);
    scroll_->setFocusPolicy(Qt::TabFocus);
    scroll_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll_->setWidgetResizable(true);
    scroll_->setWidget(inside_);
    scroll_->setMinimumHeight(kMinContent);
    scroll_->viewport()->setAutoFillBackground(false);
    inside_->setAutoFillBackground(false);
    footLayout_ = new QVBoxLayout(foot_);
    footLayout_->setContentsMargins(0, 0, 0, 0);
    footLayout_->setSpacing(6);
    keyLayout_ = new QHBoxLayout;
    keyLayout_->setSpacing(6);
    footLayout_->addLayout(keyLayout_);

    auto* head = new QHBoxLayout;
    head->setSpacing(2);
    head->addWidget(title_, 1);
    head->addWidget(fold_);
    head->addWidget(close_);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(kMargin, kMargin, kMargin, kHeadMargin);
    layout->setSpacing(6);
    // Place the title with its buttons at the bottom, so that the buttons do not move when the card is folded
    // or unfolded.
    layout->addWidget(scroll_, 1);
    layout->addWidget(foot_);
    layout->addLayout(head);

    connect(fold_, &QToolButton::clicked, this, [this] { setFolded(!folded_); });
    connect(close_, &QToolButton::clicked, this, &ViewCard::closeRequested);
    view_.installEventFilter(this);
}

void ViewCard::setTitle(const QString& title) {
    title_->setText(title);
    setAccessibleName(title);
    scroll_->setAccessibleName(title);
}

QString ViewCard::title() const {
    return title_->text();
}

bool ViewCard::isFolded() const {
    return folded_ || noRoom_;
}

void ViewCard::setFolded(bool folded) {
    folded_ = folded;
    place();
}

void ViewCard::open() {
    show();
    place();
    raise();
}

void ViewCard::openQuietly() {
    constexpr double kMuch = 0.4;
    show();
    folded_ = kWidth * wantedHeight() > kMuch * view_.width() * view_.height();
    open();
}

void ViewCard::putAway() {
    // Move the focus to the view. Otherwise, hiding the focused widget would move the focus to the next
    // control, e.g. the speed slider.
    if (isAncestorOf(window()->focusWidget())) {
        view_.setFocus(Qt::OtherFocusReason);
    }
    hide();
}

void ViewCard::addAboveKeys(QWidget* widget) {
    footLayout_->insertWidget(footLayout_->count() - 1, widget);
}

void ViewCard::setUsable(QWidget& control, bool usable) {
    if (!usable && control.hasFocus()) {
        view_.setFocus(Qt::OtherFocusReason);
    }
    control.setEnabled(usable);
}

int ViewCard::footHeight() const {
    constexpr int kInside = kWidth - 2 * kMargin;
    return footLayout_->hasHeightForWidth() ? footLayout_->totalHeightForWidth(kInside)
                                            : footLayout_->totalSizeHint().height();
}

int ViewCard::wantedHeight() const {
    if (height_ > 0) {
        return height_;
    }
    const int width = kWidth - 2 * kMargin;
    const int content = contentLayout_->hasHeightForWidth() ? contentLayout_->totalHeightForWidth(width)
                                                            : contentLayout_->totalSizeHint().height();
    return kMargin + content + layout()->spacing() + footHeight() + layout()->spacing() +
           fold_->sizeHint().height() + kHeadMargin;
}

void ViewCard::place() {
    const int width = std::min(kWidth, view_.width() - 2 * kGap);
    const int room = view_.height() - 2 * kGap;
    const int head = fold_->sizeHint().height() + 2 * kHeadMargin;
    const int least = head + kMargin + kMinContent + 2 * layout()->spacing() + footHeight();
    noRoom_ = room < least || width < kWidth;
    const bool folded = isFolded();
    const QWidget* focus = window()->focusWidget();
    if ((folded && (scroll_->isAncestorOf(focus) || foot_->isAncestorOf(focus) || focus == scroll_)) ||
        (noRoom_ && focus == fold_)) {
        view_.setFocus(Qt::OtherFocusReason);
    }
    layout()->setContentsMargins(kMargin, folded ? kHeadMargin : kMargin, kMargin, kHeadMargin);
    scroll_->setVisible(!folded);
    foot_->setVisible(!folded);
    fold_->setChecked(folded);
    fold_->setEnabled(!noRoom_);
    fold_->setIcon(themedIcon(folded ? QStringLiteral("up") : QStringLiteral("down")));
    const QString what = noRoom_  ? tr("The view is too small to expand this card")
                         : folded ? tr("Expand")
                                  : tr("Collapse");
    fold_->setAccessibleName(what);
    fold_->setToolTip(what);
    const int height = folded ? head : std::min(wantedHeight(), room);
    setGeometry(kGap, view_.height() - kGap - height, width, height);
    Q_EMIT coveredChanged();
}

int ViewCard::covered() const {
    return isHidden() || !isFolded() ? 0 : height() + kGap;
}

void ViewCard::hideEvent(QHideEvent* event) {
    QFrame::hideEvent(event);
    Q_EMIT coveredChanged();
}

bool ViewCard::event(QEvent* event) {
    switch (event->type()) {
        // Accept events on the card, so that they do not reach the view.
        case QEvent::MouseButtonPress:
        case QEvent::MouseButtonRelease:
        case QEvent::MouseButtonDblClick:
        case QEvent::MouseMove:
        case QEvent::Wheel:
            event->accept();
            return true;
        case QEvent::StyleChange:
        case QEvent::LanguageChange:
            if (isVisible()) {
                place();
            }
            break;
        default:
            break;
    }
    return QFrame::event(event);
}

bool ViewCard::eventFilter(QObject* watched, QEvent* event) {
    if (watched == &view_ && event->type() == QEvent::Resize && isVisible()) {
        place();
    }
    return QFrame::eventFilter(watched, event);
}

void ViewCard::paintEvent(QPaintEvent*) {
    const Theme& theme = Theme::current();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(theme.border);
    painter.setBrush(theme.raised);
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), kCornerRadius, kCornerRadius);
}

}  // namespace tiller

#include "moc_view_card.cpp"
