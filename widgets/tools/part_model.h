// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A list of named things of the project as a table: which of them is in use, the name, and its figures. The name can
// be typed; what it means for the project is told by functions.

#include <QAbstractTableModel>
#include <QStringList>
#include <functional>

namespace tiller {

class PartModel : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column { Mark, Name, FirstFigure };

    struct Content {
        std::function<QStringList()> figureHeadings;
        std::function<int()> count;
        std::function<bool(int row)> isInUse;
        QString inUse;  ///< what the mark means: "In use"
        std::function<QString(int row)> name;
        std::function<QStringList(int row)> figures;  ///< as many as there are headings
        /// Why the row cannot have that name, as a sentence; empty when it can.
        std::function<QString(int row, const QString& name)> nameProblem;
        std::function<void(int row, const QString& name)> rename;
    };
    explicit PartModel(Content content, QObject* parent = nullptr);

    /// The list is another one, or says something else.
    void follow();

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;

Q_SIGNALS:
    /// An edit was refused, and why.
    void editRefused(const QString& reason);

private:
    Content content_;
    int rows_ = 0;  ///< as the views know them
};

}  // namespace tiller
