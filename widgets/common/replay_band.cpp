// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/replay_band.h"

#include <QApplication>
#include <QEvent>
#include <QHBoxLayout>
#include <QTimer>
#include <QToolButton>

#include "widgets/common/elided_label.h"
#include "widgets/common/reserve_height.h"
#include "widgets/common/theme.h"

namespace tiller {

ReplayBand::ReplayBand(const QString& name, QWidget* above, QWidget* parent)
    : QFrame(parent), above_(above), words_(new ElidedLabel({}, this)), live_(new QToolButton) {
    setObjectName(name);
    setAccessibleName(tr("Replay"));
    words_->setObjectName(name + QStringLiteral(".words"));
    words_->setFont(textFont(14, QFont::Bold));
    words_->setElideMode(Qt::ElideRight);
    live_->setObjectName(name + QStringLiteral(".live"));
    live_->setText(tr("Back to live"));
    live_->setAccessibleName(live_->text());
    live_->setToolTip(tr("Show the current state of the robot. The recording stays open in the plots."));
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(12, 4, 8, 4);
    layout->addWidget(words_, 1);
    layout->addWidget(live_);
    connect(live_, &QToolButton::clicked, this, &ReplayBand::liveWanted);
    style();
    hide();
}

void ReplayBand::tell(const QString& words) {
    if (words_->fullText() != words) {
        words_->setFullText(words);
        setAccessibleDescription(words);
        words_->setToolTip(words);
    }
    live_->setEnabled(!words.isEmpty());
    style();
    // Keep the band visible while the pointer is on it. Hiding it would move another button under the
    // pointer, and a double click would press that button.
    if (words.isEmpty() && !isHidden() && underMouse()) {
        return;
    }
    setShown(!words.isEmpty());
}

void ReplayBand::setShown(bool shown) {
    if (shown == isHidden()) {
        if (above_ != nullptr) {
            reserveHeight(*above_, shown ? sizeHint().height() : 0);
        }
        setVisible(shown);
    }
}

void ReplayBand::leaveEvent(QEvent* event) {
    QFrame::leaveEvent(event);
    // A finger that has left the screen is not on the band. Keep the band for the double-click interval, so
    // that the second tap of a double tap does not press another button.
    QTimer::singleShot(QApplication::doubleClickInterval(), this, [this] {
        if (words().isEmpty() && !underMouse()) {
            setShown(false);
        }
    });
}

QString ReplayBand::words() const {
    return words_->fullText();
}

void ReplayBand::style() {
    const Theme& theme = Theme::current();
    // Use the inverted selection colours, which no widget with live data has.
    const QString sheet =
        words().isEmpty()
            ? QString()
            : QStringLiteral("tiller--ReplayBand { background: %1; } tiller--ElidedLabel { color: %2; }")
                  .arg(theme.inverse.name(), theme.inverseText.name());
    if (sheet != styleSheet()) {
        styling_ = true;
        setStyleSheet(sheet);
        styling_ = false;
    }
}

void ReplayBand::changeEvent(QEvent* event) {
    QFrame::changeEvent(event);
    if (event->type() == QEvent::StyleChange && !styling_ && live_ != nullptr) {
        style();
    }
}

}  // namespace tiller

#include "moc_replay_band.cpp"
