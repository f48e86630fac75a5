// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Shows the latest changes of a waypoint: author, time, and differences from the current state. The user can
// restore an earlier state.

#include <QDialog>

#include "robot/project/waypoint_revision.h"

class QLabel;
class QListWidget;
class QPushButton;

namespace tiller {

class ProjectDocument;

class WaypointHistoryDialog : public QDialog {
    Q_OBJECT

public:
    WaypointHistoryDialog(const ProjectDocument& document, const project::Waypoint& waypoint,
                          QWidget* parent = nullptr);

    /// The state of the waypoint before the selected change, together with the history.
    project::Waypoint chosen() const;

    /// Returns the differences as one sentence per line; empty if there are none.
    static QStringList differences(const project::Waypoint& before, const project::Waypoint& now,
                                   const ProjectDocument& document);

private:
    void refresh();
    const project::WaypointRevision& revision() const;

    const ProjectDocument& document_;
    project::Waypoint waypoint_;
    QListWidget* list_;
    QLabel* compare_;
    QPushButton* revert_;
};

}  // namespace tiller
