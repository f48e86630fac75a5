// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A list of which each row is one thing with a name: rows are chosen, not cells, and the name takes the width
// that the other columns leave.

#include <QStyledItemDelegate>
#include <QTableView>

namespace tiller {

class RowTable : public QTableView {
    Q_OBJECT

public:
    /// nameColumn  of the model: edited in place (F2 or double click)
    RowTable(QAbstractItemModel& model, int nameColumn, QWidget* parent = nullptr);

    /// Begins to edit the name of the current row.
    void renameCurrent();

Q_SIGNALS:
    void currentRowChanged(int row);

protected:
    void currentChanged(const QModelIndex& current, const QModelIndex& previous) override;

private:
    int nameColumn_;
};

/// Draws cells without a focus of their own, and lets them be edited within a row's height.
class RowDelegate : public QStyledItemDelegate {
public:
    /// editorName  object name of every editor
    RowDelegate(QString editorName, QObject* parent);

    QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& option,
                          const QModelIndex& index) const override;
    void updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option,
                              const QModelIndex& index) const override;

protected:
    void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override;
    /// Gives an editor its names: its own and, for who cannot see it, the column's.
    QWidget* named(QWidget* editor, const QModelIndex& index) const;

private:
    QString editorName_;
};

}  // namespace tiller
