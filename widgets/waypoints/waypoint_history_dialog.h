// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What a waypoint was before each of its latest changes: who changed it, when, and what is different now. Any earlier
// one can come back.

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

    /// The waypoint as it was before the chosen change, with its history.
    project::Waypoint chosen() const;

    /// What is different, one sentence a line; empty when nothing is.
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
