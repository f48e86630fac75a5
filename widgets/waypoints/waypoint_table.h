// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The list of waypoints. Rows are edited in place (F2 or double click) and reordered by dragging.

#include "widgets/common/row_table.h"

namespace tiller {

class WaypointModel;

class WaypointTable : public RowTable {
    Q_OBJECT

public:
    explicit WaypointTable(WaypointModel& model, QWidget* parent = nullptr);

    /// Selected rows in ascending order.
    QList<int> selectedRows() const;

protected:
    void resizeEvent(QResizeEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    void fitColumns();
    WaypointModel& model_;
};

}  // namespace tiller
