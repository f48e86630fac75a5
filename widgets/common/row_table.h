// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A table with a named object in each row. The user selects rows instead of cells. The name column fills the
// remaining width.

#include <QStyledItemDelegate>
#include <QTableView>

namespace tiller {

class RowTable : public QTableView {
    Q_OBJECT

public:
    /// nameColumn  column of the model with the names, which are edited in place (F2 or double click)
    RowTable(QAbstractItemModel& model, int nameColumn, QWidget* parent = nullptr);

    int nameColumn() const { return nameColumn_; }
    /// Starts editing the name of the current row.
    void renameCurrent();

Q_SIGNALS:
    void currentRowChanged(int row);

protected:
    void currentChanged(const QModelIndex& current, const QModelIndex& previous) override;

private:
    int nameColumn_;
};

/// Draws cells without a focus rectangle, and limits editors to the height of a row.
class RowDelegate : public QStyledItemDelegate {
public:
    /// editorName  object name of all editors
    RowDelegate(QString editorName, QObject* parent);

    QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& option,
                          const QModelIndex& index) const override;
    void updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option,
                              const QModelIndex& index) const override;
    bool eventFilter(QObject* editor, QEvent* event) override;

protected:
    void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override;
    /// Sets the object name of the editor, and its accessible name from the column title.
    QWidget* named(QWidget* editor, const QModelIndex& index) const;

private:
    QString editorName_;
};

}  // namespace tiller
