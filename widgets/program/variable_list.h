// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The variables of the running program with their types and values. While the program waits, values of
// numbers and flags can be edited.

#include <QAbstractTableModel>
#include <QTreeView>
#include <vector>

#include "robot/script/program_variables.h"

namespace tiller {

namespace program {
class ProgramRunner;
}

class VariableModel : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column { Name, Type, Value };

    /// runner  must outlive the model
    explicit VariableModel(const program::ProgramRunner& runner, QObject* parent = nullptr);

    /// Shows the current variables, and whether their values can be changed.
    void follow();
    /// The reason why the value of this row cannot be changed now, as a sentence; empty if it can be changed.
    QString obstacleAt(const QModelIndex& index) const;
    const script::ProgramVariable& at(const QModelIndex& index) const;  ///< the variable of this row

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;

Q_SIGNALS:
    void edited(const QString& name, const QString& text);
    /// A typed value has no effect for this reason.
    void refused(const QString& reason);

private:
    const program::ProgramRunner& runner_;
    std::vector<script::ProgramVariable> shown_;
};

class VariableList : public QTreeView {
    Q_OBJECT

public:
    /// runner  must outlive the list
    explicit VariableList(const program::ProgramRunner& runner, QWidget* parent = nullptr);

    QSize sizeHint() const override;

Q_SIGNALS:
    void edited(const QString& name, const QString& text);
    /// A value cannot be edited, or a typed value has no effect, for this reason.
    void refused(const QString& reason);

private:
    void follow();

    const program::ProgramRunner& runner_;
    VariableModel* model_;
};

}  // namespace tiller
