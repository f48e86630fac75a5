// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Finds waypoints by name, group or note. Rows without a match are hidden while the search field is open.
// Return selects the next match. Esc closes the field and shows all rows. The field is an overlay at the
// bottom of the list.

#include <QFrame>

class QLabel;
class QLineEdit;

namespace tiller {

class ProjectDocument;
class WaypointTable;

class WaypointSearch : public QFrame {
    Q_OBJECT

public:
    /// document, table  must outlive the object
    WaypointSearch(ProjectDocument& document, WaypointTable& table, QWidget* parent = nullptr);

    void open();
    void close();
    bool matches(int row) const;

Q_SIGNALS:
    /// Requests the selection of this row.
    void rowWanted(int row);

protected:
    void keyPressEvent(QKeyEvent* event) override;

private:
    void apply();
    void next(int by);

    ProjectDocument& document_;
    WaypointTable& table_;
    QLineEdit* field_;
    QLabel* count_;
    QString words_;  ///< lower case; empty: no filter
    bool filtered_ = false;
};

}  // namespace tiller
