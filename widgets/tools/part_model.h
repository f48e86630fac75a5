// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Table model for a list of named objects of the project: mark of the active one, name, and values. The name is
// editable; functions provide the connection to the project.

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
        QString inUse;  ///< text of the mark: "In use"
        std::function<QString(int row)> name;
        std::function<QStringList(int row)> figures;  ///< one text per column
        /// The reason why the row cannot have this name, as a sentence; empty if it can.
        std::function<QString(int row, const QString& name)> nameProblem;
        std::function<void(int row, const QString& name)> rename;
    };
    explicit PartModel(Content content, QObject* parent = nullptr);

    /// The list or its content has changed.
    void follow();

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;

Q_SIGNALS:
    /// An edit was refused, with the reason.
    void editRefused(const QString& reason);

private:
    Content content_;
    int rows_ = 0;  ///< number of rows known to the views
};

}  // namespace tiller
