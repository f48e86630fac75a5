// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/frames/frame_table.h"

#include <QHeaderView>
#include <QStyledItemDelegate>
#include <algorithm>

#include "widgets/common/density.h"
#include "widgets/frames/frame_model.h"

namespace tiller {
namespace {

class FrameDelegate : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& option,
                          const QModelIndex& index) const override {
        QWidget* editor = QStyledItemDelegate::createEditor(parent, option, index);
        editor->setObjectName(QStringLiteral("frame.editor"));
        editor->setAccessibleName(index.model()->headerData(index.column(), Qt::Horizontal).toString());
        // The cell's own height is small: no margins inside it.
        editor->setStyleSheet(QStringLiteral("min-height: 0; padding: 0 8px;"));
        return editor;
    }

    void updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option,
                              const QModelIndex&) const override {
        editor->setGeometry(option.rect.adjusted(0, 1, 0, -2));
    }

protected:
    void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override {
        QStyledItemDelegate::initStyleOption(option, index);
        option->state &= ~QStyle::State_HasFocus;  // the row is the unit, not the cell
        option->textElideMode = Qt::ElideRight;
    }
};

}  // namespace

FrameTable::FrameTable(FrameModel& model, QWidget* parent) : QTableView(parent), model_(model) {
    setObjectName(QStringLiteral("frame.table"));
    setAccessibleName(tr("Frames"));
    setModel(&model);
    setItemDelegate(new FrameDelegate(this));
    setSelectionBehavior(SelectRows);
    setSelectionMode(SingleSelection);
    setEditTriggers(DoubleClicked | EditKeyPressed);
    setShowGrid(false);
    setWordWrap(false);
    setTabKeyNavigation(false);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setVerticalScrollMode(ScrollPerPixel);
    setFrameShape(NoFrame);
    verticalHeader()->hide();
    verticalHeader()->setMinimumSectionSize(tiller::rowHeight(Density::Compact));
    followDensity(*this);
    horizontalHeader()->setHighlightSections(false);
    horizontalHeader()->setSectionsClickable(false);
    horizontalHeader()->setStretchLastSection(false);
    horizontalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    horizontalHeader()->setSectionResizeMode(FrameModel::Name, QHeaderView::Stretch);
    horizontalHeader()->setMinimumSectionSize(24);
    // The headings may use the gap to the next column.
    horizontalHeader()->setStyleSheet(QStringLiteral("QHeaderView::section { padding: 6px 0 6px 12px; }"));
}

void FrameTable::renameCurrent() {
    if (currentIndex().isValid()) {
        const QModelIndex name = model_.index(currentIndex().row(), FrameModel::Name);
        selectionModel()->setCurrentIndex(name, QItemSelectionModel::NoUpdate);
        setFocus();
        edit(name);
    }
}

void FrameTable::currentChanged(const QModelIndex& current, const QModelIndex& previous) {
    QTableView::currentChanged(current, previous);
    if (current.row() != previous.row()) {
        Q_EMIT currentRowChanged(current.row());
    }
}

void FrameTable::resizeEvent(QResizeEvent* event) {
    shareWidth();
    QTableView::resizeEvent(event);
}

void FrameTable::shareWidth() {
    const int room = viewport()->width();
    // Four digits before the point, and a sign, each.
    constexpr int kName = 90;
    constexpr int kThreeFigures = 196;
    constexpr int kPoints = 58;
    constexpr int kDistance = 82;
    setColumnWidth(FrameModel::Origin, kThreeFigures);
    setColumnWidth(FrameModel::Rotation, kThreeFigures);
    setColumnWidth(FrameModel::Waypoints, kPoints);
    setColumnWidth(FrameModel::Distance, kDistance);
    // The name needs its room; what goes first stands in the pane below.
    const int least = kName + 2 * kThreeFigures + kPoints;
    setColumnHidden(FrameModel::Distance, room < least + kDistance);
    setColumnHidden(FrameModel::Rotation, room < least);
}

}  // namespace tiller
