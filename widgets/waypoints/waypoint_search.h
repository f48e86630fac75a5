// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Finds waypoints by name, group or note: rows that do not match are hidden while the field is open. Return goes to the
// next one, Esc closes it and shows all again. It lies over the lower edge of the list and moves no row by itself.

#include <QFrame>

class QLabel;
class QLineEdit;

namespace tiller {

class ProjectDocument;
class WaypointTable;

class WaypointSearch : public QFrame {
    Q_OBJECT

public:
    /// document, table  must outlive it
    WaypointSearch(ProjectDocument& document, WaypointTable& table, QWidget* parent = nullptr);

    void open();
    void close();
    bool matches(int row) const;

Q_SIGNALS:
    /// A row to be selected.
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
    QString words_;  ///< lower case; empty: everything matches
    bool filtered_ = false;
};

}  // namespace tiller
