// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The list itself: rows of 36 px, edited in place (F2 or double click), reordered by dragging.

#include <QTableView>

namespace tiller {

class WaypointModel;

class WaypointTable : public QTableView {
    Q_OBJECT

public:
    explicit WaypointTable(WaypointModel& model, QWidget* parent = nullptr);

    /// Selected rows in ascending order.
    QList<int> selectedRows() const;
    void renameCurrent();

Q_SIGNALS:
    void currentRowChanged(int row);

protected:
    void currentChanged(const QModelIndex& current, const QModelIndex& previous) override;
    void resizeEvent(QResizeEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    WaypointModel& model_;
};

}  // namespace tiller
