// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/bottom_overlay.h"

#include <QEvent>
#include <QLayout>
#include <QScopedValueRollback>
#include <QWidget>
#include <algorithm>
#include <utility>

namespace tiller {

namespace {

constexpr int kEdgeMargin = 8;  // distance from the border [px]
constexpr int kKept = 64;       // height to keep for an area: its header and one row [px]

}  // namespace

BottomOverlay::BottomOverlay(QWidget& shown, QWidget& page, const QList<QWidget*>& areas)
    : QObject(&shown), shown_(shown), page_(page), areas_(areas) {
    shown.setParent(&page);
    shown.hide();
    shown.installEventFilter(this);
    page.installEventFilter(this);
    for (QWidget* area : areas_) {
        area->installEventFilter(this);
    }
}

/// Sets the bottom margin of the area to the height of its tallest overlay.
void BottomOverlay::reserve(QWidget* area, int height) {
    QWidget* before = std::exchange(reservedIn_, area);
    reserved_ = height;
    const QList<BottomOverlay*> all = page_.findChildren<BottomOverlay*>();
    for (QWidget* changed : {before, area}) {
        if (changed == nullptr) {
            continue;
        }
        int margin = 0;
        for (const BottomOverlay* edge : all) {
            margin = edge->reservedIn_ == changed ? std::max(margin, edge->reserved_) : margin;
        }
        if (changed->contentsMargins().bottom() != margin) {
            changed->setContentsMargins(0, 0, 0, margin);
        }
    }
}

void BottomOverlay::place() {
    if (placing_) {
        return;
    }
    const QScopedValueRollback<bool> once(placing_, true);
    if (!shown_.isVisibleTo(&page_)) {
        reserve(nullptr, 0);
        return;
    }
    const auto area = std::find_if(areas_.cbegin(), areas_.cend(),
                                   [this](const QWidget* a) { return a->isVisibleTo(&page_); });
    const QRect room =
        area == areas_.cend() ? page_.rect() : QRect((*area)->mapTo(&page_, QPoint(0, 0)), (*area)->size());
    const int width = std::max(0, room.width() - 2 * kEdgeMargin);
    if (shown_.layout() != nullptr) {
        shown_.layout()->activate();
    }
    const int tall = shown_.hasHeightForWidth() ? shown_.heightForWidth(width) : shown_.sizeHint().height();
    const int height = std::max(tall, shown_.minimumSizeHint().height());
    // An overlay taller than its area extends over the bottom edge of the area, because the buttons above
    // must stay visible.
    const int top = std::max(room.top(), room.bottom() + 1 - kEdgeMargin - height);
    const int lowest = std::max(0, page_.height() - height);
    shown_.setGeometry(room.left() + kEdgeMargin, std::min(top, lowest), width, height);
    shown_.raise();
    // Keep the header and one row of the area visible. In an even smaller area, the overlay covers the row.
    const int left = room.height() - kKept;
    reserve(area == areas_.cend() ? nullptr : *area,
            std::clamp(height + 2 * kEdgeMargin, 0, std::max(0, left)));
}

bool BottomOverlay::eventFilter(QObject* watched, QEvent* event) {
    switch (event->type()) {
        case QEvent::Resize:
        case QEvent::Move:
        case QEvent::ShowToParent:
        case QEvent::HideToParent:
        case QEvent::LayoutRequest:
        case QEvent::StyleChange:
            place();
            break;
        default:
            break;
    }
    return QObject::eventFilter(watched, event);
}

}  // namespace tiller

#include "moc_bottom_overlay.cpp"
