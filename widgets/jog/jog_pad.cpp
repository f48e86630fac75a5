// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/jog/jog_pad.h"

#include <QGridLayout>
#include <QPainter>
#include <algorithm>

#include "widgets/common/shapes.h"
#include "widgets/common/theme.h"

namespace tiller {

JogKey::JogKey(const QString& text, const CartesianKey& key, HoldPolicy& policy, QWidget* parent)
    : HoldToRunButton(text, policy, parent), key_(key) {
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void JogKey::paintEvent(QPaintEvent*) {
    const Theme& theme = Theme::current();
    QPainter painter(this);
    paintSurface(painter);
    painter.setFont(textFont(19, QFont::Bold));
    painter.setPen(textColor());
    // A very small button has no space for the distance, so the bar is at the bottom.
    constexpr int kTravel = 23;
    const bool high = height() >= 58;
    const int bar = high ? std::min(49, height() - kTravel) : height() - 10;
    painter.drawText(QRect(0, 0, width(), height() >= 68 ? bar + 13 : bar), Qt::AlignCenter,
                     showsHoldHint() ? detail() : text());
    painter.setPen(Qt::NoPen);
    painter.setBrush(isEnabled() ? theme.axis(key_.axis % 3) : theme.border);
    painter.drawRoundedRect(QRectF(13, bar, width() - 26, 4), 2, 2);
    const QString travel = outdated_ && travel_.isEmpty() ? QString(QChar(0x2026)) : travel_;
    if (high && isEnabled() && !travel.isEmpty()) {
        painter.setFont(textFont(13, near_ && !outdated_ ? QFont::Bold : QFont::Normal));
        painter.setPen(outdated_ ? theme.disabledText : near_ ? theme.warning : theme.secondary);
        painter.drawText(QRect(0, bar + 5, width(), height() - bar - 6), Qt::AlignCenter, travel);
    }
}

void JogKey::setTravelOutdated(bool outdated) {
    if (outdated != outdated_) {
        outdated_ = outdated;
        update();
    }
}

void JogKey::setTravel(const QString& text, bool near) {
    if (text == travel_ && near == near_) {
        return;
    }
    travel_ = text;
    near_ = near;
    setAccessibleDescription(text.isEmpty() ? QString() : tr("%1 left in this direction").arg(text));
    update();
}

/// A card in the centre of the disabled pad that shows the reason.
class JogPad::ReasonCard : public QWidget {
public:
    explicit ReasonCard(QWidget* parent) : QWidget(parent) {
        setAttribute(Qt::WA_TransparentForMouseEvents);
        hide();
    }
    void setText(const QString& text) {
        text_ = text;
        setAccessibleName(text);
        update();
    }
    int heightFor(int width) const { return wordsHeight(kLargest, width) + 2 * kMargin; }

protected:
    void paintEvent(QPaintEvent*) override {
        const Theme& theme = Theme::current();
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(QPen(theme.secondary, 1));
        painter.setBrush(theme.raised);
        painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), kCornerRadius, kCornerRadius);
        drawShape(painter, StateChip::Shape::Hand, QRectF(14, height() / 2.0 - 10, 20, 20), theme.text,
                  theme.raised);
        // A long reason has less margin and smaller letters.
        int size = kLargest;
        while (size > kSmallest && wordsHeight(size, width()) + 4 > height()) {
            --size;
        }
        painter.setFont(textFont(size, QFont::Bold));
        painter.setPen(theme.text);
        painter.drawText(QRect(44, 2, width() - 56, height() - 4), Qt::AlignVCenter | Qt::TextWordWrap,
                         text_);
    }

private:
    static constexpr int kLargest = 15;  ///< [px]
    static constexpr int kSmallest = 9;
    static constexpr int kMargin = 14;

    int wordsHeight(int size, int width) const {
        const QFontMetrics metrics(textFont(size, QFont::Bold));
        return metrics.boundingRect(QRect(0, 0, width - 56, 1000), Qt::TextWordWrap, text_).height();
    }

    QString text_;
};

JogPad::JogPad(HoldPolicy& policy, QWidget* parent) : QWidget(parent), card_(new ReasonCard(this)) {
    setObjectName(QStringLiteral("jogPad"));
    setAccessibleName(tr("Jog buttons"));
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setSpacing(8);
    struct Place {
        const char* name;
        CartesianKey key;
    };
    // Same arrangement as on the screen. The axis letters are not translated.
    static constexpr Place kPlaces[3][4] = {
        {{"Y+", {1, 1}}, {"Z+", {2, 1}}, {"Ry+", {4, 1}}, {"Rz+", {5, 1}}},
        {{"X-", {0, -1}}, {"X+", {0, 1}}, {"Rx-", {3, -1}}, {"Rx+", {3, 1}}},
        {{"Y-", {1, -1}}, {"Z-", {2, -1}}, {"Ry-", {4, -1}}, {"Rz-", {5, -1}}},
    };
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 4; ++column) {
            const Place& place = kPlaces[row][column];
            QString text = QString::fromLatin1(place.name);
            auto* key = new JogKey(text.replace(QLatin1Char('-'), QChar(0x2212)), place.key, policy, this);
            key->setObjectName(QStringLiteral("jog.") + QString::fromLatin1(place.name));
            key->setAccessibleName(tr("Jog %1").arg(key->text()));
            keys_.append(key);
            grid->addWidget(key, row, column);
        }
    }
    for (int column = 0; column < 4; ++column) {
        grid->setColumnStretch(column, 1);
    }
    card_->raise();
    card_->setObjectName(QStringLiteral("jogReason"));
}

void JogPad::setReason(const QString& reason) {
    if (reason == reason_) {
        return;
    }
    reason_ = reason;
    for (JogKey* key : keys_) {
        key->setUnavailable(reason);
    }
    card_->setText(reason);
    card_->setVisible(!reason.isEmpty());
    resizeEvent(nullptr);
}

void JogPad::resizeEvent(QResizeEvent*) {
    const int w = width();
    const int h = std::min(card_->heightFor(w), height());
    card_->setGeometry(0, (height() - h) / 2, w, h);
}

}  // namespace tiller

#include "moc_jog_pad.cpp"
