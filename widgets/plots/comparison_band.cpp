// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/comparison_band.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QPainter>
#include <QToolButton>
#include <array>

#include "widgets/common/elided_label.h"
#include "widgets/common/theme.h"

namespace tiller {

namespace {

constexpr int kFlagRoom = 28;  // space on the left side [px]

}  // namespace

ComparisonBand::ComparisonBand(QWidget* parent)
    : QFrame(parent), words_(new ElidedLabel({}, this)), key_(new QToolButton), compare_(new QToolButton) {
    setObjectName(QStringLiteral("plots.comparison"));
    setAccessibleName(tr("Comparison with the arm model"));
    words_->setObjectName(QStringLiteral("plots.comparison.words"));
    words_->setFont(textFont(14));
    words_->setElideMode(Qt::ElideRight);
    key_->setObjectName(QStringLiteral("plots.comparison.key"));
    compare_->setObjectName(QStringLiteral("plots.comparison.compare"));
    compare_->setText(tr("Compare…"));
    compare_->setAccessibleName(compare_->text());
    compare_->setToolTip(tr("Compare this recording with the arm model using different limits"));
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(kFlagRoom, 4, 8, 4);
    layout->setSpacing(8);
    layout->addWidget(words_, 1);
    layout->addWidget(key_);
    layout->addWidget(compare_);
    connect(key_, &QToolButton::clicked, this, [this] {
        if (what_ == Key::Cancel) {
            Q_EMIT cancelWanted();
        } else {
            Q_EMIT momentWanted();
        }
    });
    connect(compare_, &QToolButton::clicked, this, &ComparisonBand::comparisonWanted);
    // Set the initial texts, because they determine the width of the buttons.
    tell({}, {}, Key::None, false);
    style();
    hide();
}

void ComparisonBand::tell(const QString& words, const QString& details, Key key, bool parted) {
    if (words_->fullText() != words) {
        words_->setFullText(words);
    }
    details_ = details;
    words_->setToolTip(details.isEmpty() ? words : words + QLatin1Char('\n') + details);
    setAccessibleDescription(words_->toolTip());
    what_ = key;
    key_->setVisible(key != Key::None);
    const QString text = key == Key::Cancel ? tr("Cancel") : tr("Go to time");
    key_->setText(text);
    key_->setAccessibleName(text);
    key_->setToolTip(key == Key::Cancel ? tr("Cancel the comparison")
                                        : tr("Place cursor A where the arm and the model diverge"));
    compare_->setEnabled(key != Key::Cancel);
    if (parted != parted_) {
        parted_ = parted;
        update();
    }
}

QString ComparisonBand::words() const {
    return words_->fullText();
}

void ComparisonBand::paintEvent(QPaintEvent* event) {
    QFrame::paintEvent(event);
    if (!parted_) {
        return;
    }
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QColor color = Theme::current().alarm;
    const double x = 12.5;
    const double top = height() / 2.0 - 7;
    painter.setPen(QPen(color, 1));
    painter.drawLine(QPointF(x, top), QPointF(x, top + 14));
    painter.setBrush(color);
    const std::array<QPointF, 3> flag = {QPointF(x, top), QPointF(x + 9, top + 4.5), QPointF(x, top + 9)};
    painter.drawPolygon(flag.data(), static_cast<int>(flag.size()));
}

void ComparisonBand::style() {
    const Theme& theme = Theme::current();
    styling_ = true;
    setStyleSheet(
        QStringLiteral("tiller--ComparisonBand { background: %1; border: none; border-top: 1px solid %2; }")
            .arg(theme.panel.name(), theme.border.name()));
    styling_ = false;
}

void ComparisonBand::changeEvent(QEvent* event) {
    QFrame::changeEvent(event);
    if (event->type() == QEvent::StyleChange && !styling_ && compare_ != nullptr) {
        style();
    }
}

}  // namespace tiller

#include "moc_comparison_band.cpp"
