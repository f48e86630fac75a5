// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/waypoints/waypoint_table.h"

#include <QComboBox>
#include <QDropEvent>
#include <QHeaderView>
#include <QLineEdit>
#include <QPainter>
#include <QStyledItemDelegate>
#include <algorithm>

#include "widgets/common/density.h"
#include "widgets/common/theme.h"
#include "widgets/waypoints/waypoint_model.h"

namespace tiller {
namespace {

/// Move and frame are chosen from a list, the rest is typed.
class WaypointDelegate : public QStyledItemDelegate {
public:
    explicit WaypointDelegate(WaypointModel& model, QObject* parent)
        : QStyledItemDelegate(parent), model_(model) {}

    QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& option,
                          const QModelIndex& index) const override {
        if (index.column() == WaypointModel::Move || index.column() == WaypointModel::Frame) {
            auto* box = new QComboBox(parent);
            box->addItems(index.column() == WaypointModel::Move
                              ? QStringList{QStringLiteral("J"), QStringLiteral("L")}
                              : model_.frameChoices());
            box->setObjectName(QStringLiteral("waypoint.editor"));
            box->setAccessibleName(
                model_.headerData(index.column(), Qt::Horizontal, Qt::DisplayRole).toString());
            auto* self = const_cast<WaypointDelegate*>(this);
            connect(box, &QComboBox::activated, self, [self, box] {
                Q_EMIT self->commitData(box);
                Q_EMIT self->closeEditor(box);
            });
            return box;
        }
        QWidget* editor = QStyledItemDelegate::createEditor(parent, option, index);
        editor->setObjectName(QStringLiteral("waypoint.editor"));
        editor->setAccessibleName(
            model_.headerData(index.column(), Qt::Horizontal, Qt::DisplayRole).toString());
        // The cell's own height is small: no margins inside it.
        editor->setStyleSheet(QStringLiteral("min-height: 0; padding: 0 8px;"));
        return editor;
    }

    void setEditorData(QWidget* editor, const QModelIndex& index) const override {
        if (auto* box = qobject_cast<QComboBox*>(editor)) {
            box->setCurrentText(index.data(Qt::EditRole).toString());
        } else {
            QStyledItemDelegate::setEditorData(editor, index);
        }
    }

    void setModelData(QWidget* editor, QAbstractItemModel* model, const QModelIndex& index) const override {
        if (auto* box = qobject_cast<QComboBox*>(editor)) {
            model->setData(index, box->currentText(), Qt::EditRole);
        } else {
            QStyledItemDelegate::setModelData(editor, model, index);
        }
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
        if (index.column() == WaypointModel::Number) {
            option->text = QString::number(index.row() + 1);
            option->features |= QStyleOptionViewItem::HasDisplay;
        }
    }

private:
    WaypointModel& model_;
};

}  // namespace

WaypointTable::WaypointTable(WaypointModel& model, QWidget* parent) : QTableView(parent), model_(model) {
    setObjectName(QStringLiteral("waypoint.table"));
    setAccessibleName(tr("Waypoints"));
    setModel(&model);
    setItemDelegate(new WaypointDelegate(model, this));
    setSelectionBehavior(SelectRows);
    setSelectionMode(ExtendedSelection);
    setEditTriggers(DoubleClicked | EditKeyPressed);
    setShowGrid(false);
    setWordWrap(false);
    setTabKeyNavigation(false);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setVerticalScrollMode(ScrollPerPixel);
    setFrameShape(NoFrame);
    setDragEnabled(true);
    setAcceptDrops(true);
    setDragDropMode(InternalMove);
    setDragDropOverwriteMode(false);
    setDropIndicatorShown(true);
    verticalHeader()->hide();
    verticalHeader()->setMinimumSectionSize(tiller::rowHeight(Density::Compact));
    followDensity(*this);
    horizontalHeader()->setHighlightSections(false);
    horizontalHeader()->setSectionsClickable(false);
    horizontalHeader()->setStretchLastSection(false);
    horizontalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    horizontalHeader()->setSectionResizeMode(WaypointModel::Name, QHeaderView::Stretch);
    horizontalHeader()->setMinimumSectionSize(24);
    // The headings may use the gap to the next column.
    horizontalHeader()->setStyleSheet(QStringLiteral("QHeaderView::section { padding: 6px 0 6px 12px; }"));
}

QList<int> WaypointTable::selectedRows() const {
    QList<int> rows;
    for (const QModelIndex& index : selectionModel()->selectedRows()) {
        rows.append(index.row());
    }
    std::sort(rows.begin(), rows.end());
    return rows;
}

void WaypointTable::renameCurrent() {
    if (currentIndex().isValid()) {
        const QModelIndex name = model_.index(currentIndex().row(), WaypointModel::Name);
        selectionModel()->setCurrentIndex(name, QItemSelectionModel::NoUpdate);
        setFocus();
        edit(name);
    }
}

void WaypointTable::currentChanged(const QModelIndex& current, const QModelIndex& previous) {
    QTableView::currentChanged(current, previous);
    if (current.row() != previous.row()) {
        Q_EMIT currentRowChanged(current.row());
    }
}

void WaypointTable::resizeEvent(QResizeEvent* event) {
    // The columns of the design picture, shared out by the width there is.
    struct Width {
        int column;
        int wide;
        int narrow;
    };
    static constexpr Width kWidths[] = {
        {WaypointModel::Number, 34, 34}, {WaypointModel::Move, 52, 52},
        {WaypointModel::Frame, 70, 66},  {WaypointModel::Speed, 90, 88},
        {WaypointModel::Blend, 80, 80},  {WaypointModel::ReachColumn, 78, 76}};
    const int room = viewport()->width();
    for (const Width& width : kWidths) {
        setColumnWidth(width.column, room >= 520 ? width.wide : width.narrow);
    }
    // The name needs its room; what goes first can be seen elsewhere.
    setColumnHidden(WaypointModel::Blend, room < 500);
    setColumnHidden(WaypointModel::Number, room < 440);
    QTableView::resizeEvent(event);
}

void WaypointTable::dropEvent(QDropEvent* event) {
    if (event->source() != this) {
        event->ignore();
        return;
    }
    const QModelIndex over = indexAt(event->position().toPoint());
    int before = model_.rowCount();
    if (over.isValid()) {
        const QRect rect = visualRect(over);
        before = event->position().y() < rect.center().y() ? over.row() : over.row() + 1;
    }
    model_.dropMimeData(event->mimeData(), Qt::MoveAction, before, 0, {});
    // The model has moved the rows; a MoveAction would make the view delete them as well.
    event->setDropAction(Qt::CopyAction);
    event->accept();
}

}  // namespace tiller
