// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dock_stage.h"

#include <QEvent>
#include <QPainter>
#include <QScopedValueRollback>
#include <QStyle>
#include <QTimer>
#include <algorithm>

#include "app/panel_dock.h"
#include "widgets/common/theme.h"

namespace tiller::app {
namespace {

/// Increase this number when saved states of the panels become incompatible.
constexpr int kStateVersion = 1;

}  // namespace

DockStage::DockStage(QWidget* parent) : QMainWindow(parent, Qt::Widget) {
    setObjectName("stage");
    setDockOptions(QMainWindow::AllowTabbedDocks | QMainWindow::AllowNestedDocks);
    setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);
    setContextMenuPolicy(Qt::NoContextMenu);
}

DockStage::~DockStage() {
    // The panels are destroyed later and may still emit visibility changes.
    for (PanelDock* dock : std::as_const(docks_)) {
        disconnect(dock, nullptr, this, nullptr);
    }
}

void DockStage::add(PanelDock& dock) {
    dock.setParent(this);
    dock.setAllowedAreas(Qt::TopDockWidgetArea);  // the only dock area, which contains all panels
    docks_.append(&dock);
    connect(&dock, &PanelDock::rearranged, this, &DockStage::changeByUser);
    connect(&dock, &PanelDock::attentionLost, this, &DockStage::attentionLost);
    // Selecting another tab changes only the visibility. Ignore the changes made by arrange().
    connect(&dock, &QDockWidget::visibilityChanged, this, [this] {
        if (!arranging_) {
            Q_EMIT attentionLost(control::StopCause::SelectionChanged);
        }
    });
}

void DockStage::changeByUser() {
    if (!arranging_) {
        plan_.reset();
        Q_EMIT rearranged();
    }
}

PanelDock* DockStage::find(const QString& name) const {
    const auto found = std::find_if(docks_.begin(), docks_.end(),
                                    [&name](const PanelDock* dock) { return dock->objectName() == name; });
    return found != docks_.end() ? *found : nullptr;
}

// Nests all panels in one dock area. Without a central widget, Qt would omit the separator between two areas
// and cut off the adjacent panel.
void DockStage::arrange(const StagePlan& plan) {
    const QScopedValueRollback<bool> arranging(arranging_, true);
    for (PanelDock* dock : std::as_const(docks_)) {
        dock->setFloating(false);
        removeDockWidget(dock);
    }
    PanelDock* before = find(plan.row.first().dock);
    PanelDock* below = find(plan.below);
    addDockWidget(Qt::TopDockWidgetArea, before);
    splitDockWidget(before, below, Qt::Vertical);
    for (const StagePlan::Place& place : plan.row) {
        PanelDock* dock = find(place.dock);
        if (dock != before) {
            splitDockWidget(before, dock, Qt::Horizontal);
            before = dock;
        }
    }
    below->show();
    // Also add hidden panels, which defines their position when they are shown again.
    for (const StagePlan::Place& place : plan.row) {
        find(place.dock)->setVisible(place.shown);
    }
    plan_ = plan;
    proportion();
}

int DockStage::gap() const {
    return style()->pixelMetric(QStyle::PM_DockWidgetSeparatorExtent, nullptr, this);
}

void DockStage::proportion() {
    if (!plan_) {
        return;
    }
    const int gap = this->gap();
    const QSize whole = window()->size();
    QList<QDockWidget*> row;
    QList<int> widths;
    int left = width() + gap;
    int rest = -1;
    for (const StagePlan::Place& place : plan_->row) {
        if (!place.shown) {
            continue;
        }
        const int share = place.percent > 0 ? whole.width() * place.percent / 100 - gap : 0;
        rest = place.percent > 0 ? rest : static_cast<int>(row.size());
        row.append(find(place.dock));
        widths.append(share);
        left -= share + gap;
    }
    if (row.isEmpty()) {
        return;
    }
    if (rest >= 0) {
        widths[rest] = std::max(1, left);
    }
    resizeDocks(row, widths, Qt::Horizontal);
    const int below = whole.height() * plan_->belowPercent / 100 - gap;
    resizeDocks({row.first(), find(plan_->below)}, {std::max(1, height() - gap - below), below},
                Qt::Vertical);
}

void DockStage::move(PanelDock& dock, StageSide side) {
    {
        const QScopedValueRollback<bool> arranging(arranging_, true);
        QList<PanelDock*> others;
        for (PanelDock* other : std::as_const(docks_)) {
            if (other != &dock && !other->isHidden() && !other->isFloating()) {
                others.append(other);
            }
        }
        // Keep the arrangement of the other panels: side by side or stacked.
        std::sort(others.begin(), others.end(), [](const PanelDock* one, const PanelDock* other) {
            return one->x() + one->y() < other->x() + other->y();
        });
        const bool stacked = others.size() == 2 &&
                             others.first()->geometry().left() <= others.last()->geometry().right() &&
                             others.last()->geometry().left() <= others.first()->geometry().right();
        dock.setFloating(false);
        const bool first = side == StageSide::Left || side == StageSide::Top;
        QList<PanelDock*> moved = others;
        moved.insert(first ? 0 : std::min<qsizetype>(1, others.size()), &dock);
        for (PanelDock* one : std::as_const(moved)) {
            removeDockWidget(one);
        }
        addDockWidget(Qt::TopDockWidgetArea, moved.first());
        if (moved.size() > 1) {
            splitDockWidget(
                moved[0], moved[1],
                side == StageSide::Left || side == StageSide::Right ? Qt::Horizontal : Qt::Vertical);
        }
        for (qsizetype i = 1; i < others.size(); ++i) {
            splitDockWidget(others[i - 1], others[i], stacked ? Qt::Vertical : Qt::Horizontal);
        }
        for (PanelDock* one : std::as_const(moved)) {
            one->show();
        }
    }
    changeByUser();
}

void DockStage::reveal(PanelDock& dock) {
    if (dock.isHidden()) {
        {
            const QScopedValueRollback<bool> arranging(arranging_, true);
            dock.show();
        }
        changeByUser();
    }
    dock.raise();
}

QByteArray DockStage::state() const {
    return saveState(kStateVersion);
}

bool DockStage::restore(const QByteArray& state) {
    const QScopedValueRollback<bool> arranging(arranging_, true);
    if (!restoreState(state, kStateVersion)) {
        return false;
    }
    plan_.reset();
    return true;
}

bool DockStage::event(QEvent* event) {
    const bool taken = QMainWindow::event(event);
    // In this widget, only the separators between panels accept a press.
    if (event->type() == QEvent::MouseButtonPress && taken && event->isAccepted()) {
        changeByUser();
    }
    return taken;
}

void DockStage::paintEvent(QPaintEvent* event) {
    QMainWindow::paintEvent(event);
    const bool empty = std::none_of(docks_.begin(), docks_.end(), [](const PanelDock* dock) {
        return dock->isVisible() && !dock->isFloating();
    });
    if (empty) {
        QPainter painter(this);
        painter.setFont(textFont(15));
        painter.setPen(Theme::current().secondary);
        painter.drawText(rect().adjusted(24, 24, -24, -24), Qt::AlignCenter | Qt::TextWordWrap,
                         tr("No panels are shown. Select a perspective at the lower right, or show a panel "
                            "from the View menu."));
    }
}

void DockStage::resizeEvent(QResizeEvent* event) {
    QMainWindow::resizeEvent(event);
    proportion();
}

void DockStage::showEvent(QShowEvent* event) {
    QMainWindow::showEvent(event);
    // A window that is restored after being minimized has kept its sizes. Resizing its panels would push the
    // last panel out of the window.
    if (!event->spontaneous()) {
        // Resize the panels later, because they do not have their final size yet.
        QTimer::singleShot(0, this, &DockStage::proportion);
    }
}

}  // namespace tiller::app

#include "moc_dock_stage.cpp"
