// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Table model for a list of named objects of the project: a mark for the active object, the name, and values.
// The name is editable. The model accesses the project through callback functions.

#include <QAbstractTableModel>
#include <QStringList>
#include <functional>

namespace tiller {

class PartModel : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column { Mark, Name, FirstValue };

    struct Content {
        std::function<QStringList()> valueHeadings;
        std::function<int()> count;
        std::function<bool(int row)> isInUse;
        QString inUse;  ///< text of the mark, e.g. "In use"
        std::function<QString(int row)> name;
        std::function<QStringList(int row)> figures;  ///< one text per column
        /// Returns a sentence explaining why the row cannot have this name; empty if the name is valid.
        std::function<QString(int row, const QString& name)> nameProblem;
        std::function<void(int row, const QString& name)> rename;
    };
    explicit PartModel(Content content, QObject* parent = nullptr);

    /// Updates the model. Call this after the list or its content has changed.
    void follow();

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;

Q_SIGNALS:
    /// An edit was refused for this reason.
    void editRefused(const QString& reason);

private:
    Content content_;
    int rows_ = 0;  ///< number of rows reported to the views
};

}  // namespace tiller
