// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/waypoints/waypoint_table.h"

#include <QComboBox>
#include <QDropEvent>
#include <QHeaderView>
#include <algorithm>

#include "widgets/waypoints/waypoint_model.h"

namespace tiller {
namespace {

/// Move type and frame are selected from a list. Other cells use a line edit.
class WaypointDelegate : public RowDelegate {
public:
    explicit WaypointDelegate(WaypointModel& model, QObject* parent)
        : RowDelegate(QStringLiteral("waypoint.editor"), parent), model_(model) {}

    QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& option,
                          const QModelIndex& index) const override {
        if (index.column() == WaypointModel::Move || index.column() == WaypointModel::Frame) {
            auto* box = new QComboBox(parent);
            box->addItems(index.column() == WaypointModel::Move
                              ? QStringList{QStringLiteral("J"), QStringLiteral("L")}
                              : model_.frameChoices());
            auto* self = const_cast<WaypointDelegate*>(this);
            connect(box, &QComboBox::activated, self, [self, box] {
                Q_EMIT self->commitData(box);
                Q_EMIT self->closeEditor(box);
            });
            return named(box, index);
        }
        return RowDelegate::createEditor(parent, option, index);
    }

    void setEditorData(QWidget* editor, const QModelIndex& index) const override {
        if (auto* box = qobject_cast<QComboBox*>(editor)) {
            box->setCurrentText(index.data(Qt::EditRole).toString());
        } else {
            RowDelegate::setEditorData(editor, index);
        }
    }

    void setModelData(QWidget* editor, QAbstractItemModel* model, const QModelIndex& index) const override {
        if (auto* box = qobject_cast<QComboBox*>(editor)) {
            model->setData(index, box->currentText(), Qt::EditRole);
        } else {
            RowDelegate::setModelData(editor, model, index);
        }
    }

protected:
    void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override {
        RowDelegate::initStyleOption(option, index);
        if (index.column() == WaypointModel::Number) {
            option->text = QString::number(index.row() + 1);
            option->features |= QStyleOptionViewItem::HasDisplay;
        }
    }

private:
    WaypointModel& model_;
};

}  // namespace

WaypointTable::WaypointTable(WaypointModel& model, QWidget* parent)
    : RowTable(model, WaypointModel::Name, parent), model_(model) {
    setObjectName(QStringLiteral("waypoint.table"));
    setAccessibleName(tr("Waypoints"));
    setItemDelegate(new WaypointDelegate(model, this));
    setSelectionMode(ExtendedSelection);
    setDragEnabled(true);
    setAcceptDrops(true);
    setDragDropMode(InternalMove);
    setDragDropOverwriteMode(false);
    setDropIndicatorShown(true);
    connect(&model, &QAbstractItemModel::rowsInserted, this, &WaypointTable::fitColumns);
    connect(&model, &QAbstractItemModel::modelReset, this, &WaypointTable::fitColumns);
}

QList<int> WaypointTable::selectedRows() const {
    QList<int> rows;
    for (const QModelIndex& index : selectionModel()->selectedRows()) {
        rows.append(index.row());
    }
    std::sort(rows.begin(), rows.end());
    return rows;
}

void WaypointTable::resizeEvent(QResizeEvent* event) {
    fitColumns();
    RowTable::resizeEvent(event);
}

void WaypointTable::fitColumns() {
    // Column widths [px] that fit typical texts. The name column fills the remaining width.
    struct Width {
        int column;
        int wide;
        int narrow;
    };
    static constexpr Width kWidths[] = {
        {WaypointModel::Number, 34, 34}, {WaypointModel::Move, 52, 52},
        {WaypointModel::Frame, 70, 66},  {WaypointModel::Speed, 90, 88},
        {WaypointModel::Blend, 80, 80},  {WaypointModel::ReachColumn, 92, 90}};
    // Titles that are longer in some languages reduce the remaining width.
    constexpr int kMargins = 12;
    const QFontMetrics metrics = horizontalHeader()->fontMetrics();
    const auto titleWidth = [&](int column) {
        return metrics.horizontalAdvance(
                   model_.headerData(column, Qt::Horizontal, Qt::DisplayRole).toString()) +
               kMargins;
    };
    int room = viewport()->width();
    for (const Width& width : kWidths) {
        room -= std::max(0, titleWidth(width.column) - width.wide);
    }
    for (const Width& width : kWidths) {
        setColumnWidth(width.column,
                       std::max(room >= 520 ? width.wide : width.narrow, titleWidth(width.column)));
    }
    // The number column must fit the largest row number.
    constexpr int kCellMargins = 28;
    const int digits = fontMetrics().horizontalAdvance(QString::number(model_.rowCount()));
    setColumnWidth(WaypointModel::Number,
                   std::max(columnWidth(WaypointModel::Number), digits + kCellMargins));
    // Hide columns in a narrow table to keep a minimum width for the name.
    setColumnHidden(WaypointModel::Blend, room < 500);
    setColumnHidden(WaypointModel::Number, room < 440);
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
    // The model has already moved the rows. With MoveAction, the view would also delete them.
    event->setDropAction(Qt::CopyAction);
    event->accept();
}

}  // namespace tiller

#include "moc_waypoint_table.cpp"
