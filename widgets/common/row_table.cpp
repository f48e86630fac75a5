// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/row_table.h"

#include <QHeaderView>
#include <QKeyEvent>
#include <QLineEdit>
#include <utility>

#include "widgets/common/density.h"
#include "widgets/common/list_typing.h"

namespace tiller {

RowTable::RowTable(QAbstractItemModel& model, int nameColumn, QWidget* parent)
    : QTableView(parent), nameColumn_(nameColumn) {
    setModel(&model);
    setSelectionBehavior(SelectRows);
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
    new ListTyping(*this);
    horizontalHeader()->setHighlightSections(false);
    horizontalHeader()->setSectionsClickable(false);
    horizontalHeader()->setStretchLastSection(false);
    horizontalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    horizontalHeader()->setSectionResizeMode(nameColumn, QHeaderView::Stretch);
    horizontalHeader()->setMinimumSectionSize(24);
    // No padding on the right, so that header texts can use the full width of their column.
    horizontalHeader()->setStyleSheet(QStringLiteral("QHeaderView::section { padding: 6px 0 6px 12px; }"));
}

void RowTable::renameCurrent() {
    if (currentIndex().isValid()) {
        const QModelIndex name = model()->index(currentIndex().row(), nameColumn_);
        selectionModel()->setCurrentIndex(name, QItemSelectionModel::NoUpdate);
        setFocus();
        edit(name);
    }
}

void RowTable::currentChanged(const QModelIndex& current, const QModelIndex& previous) {
    QTableView::currentChanged(current, previous);
    if (current.row() != previous.row()) {
        Q_EMIT currentRowChanged(current.row());
    }
}

RowDelegate::RowDelegate(QString editorName, QObject* parent)
    : QStyledItemDelegate(parent), editorName_(std::move(editorName)) {}

QWidget* RowDelegate::createEditor(QWidget* parent, const QStyleOptionViewItem& option,
                                   const QModelIndex& index) const {
    QWidget* editor = named(QStyledItemDelegate::createEditor(parent, option, index), index);
    // The cells are not tall enough for the margins of the style sheet.
    editor->setStyleSheet(QStringLiteral("min-height: 0; padding: 0 8px;"));
    return editor;
}

void RowDelegate::updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option,
                                       const QModelIndex&) const {
    editor->setGeometry(option.rect.adjusted(0, 1, 0, -2));
}

bool RowDelegate::eventFilter(QObject* editor, QEvent* event) {
    // A line edit ignores these keys. The table would end the editing and select another row, and the next
    // letters would be commands for that row.
    if (event->type() == QEvent::KeyPress && qobject_cast<QLineEdit*>(editor) != nullptr) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        if (key == Qt::Key_Up || key == Qt::Key_Down || key == Qt::Key_PageUp || key == Qt::Key_PageDown) {
            return true;
        }
    }
    return QStyledItemDelegate::eventFilter(editor, event);
}

void RowDelegate::initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const {
    QStyledItemDelegate::initStyleOption(option, index);
    option->state &= ~QStyle::State_HasFocus;  // rows are selected, not cells
    // Elide names in the middle, because they often differ at the end, e.g. in the waypoint number.
    const auto* table = qobject_cast<const RowTable*>(option->widget);
    option->textElideMode =
        table != nullptr && index.column() == table->nameColumn() ? Qt::ElideMiddle : Qt::ElideRight;
}

QWidget* RowDelegate::named(QWidget* editor, const QModelIndex& index) const {
    editor->setObjectName(editorName_);
    editor->setAccessibleName(index.model()->headerData(index.column(), Qt::Horizontal).toString());
    return editor;
}

}  // namespace tiller

#include "moc_row_table.cpp"
