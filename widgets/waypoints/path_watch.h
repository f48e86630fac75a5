// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Checks for each waypoint whether the arm may move to it from its current position, a few waypoints at a time, so
// that no frame has to wait for all.

#include <QObject>
#include <QTimer>
#include <functional>
#include <memory>

#include "robot/core/result.h"
#include "widgets/session/session_state.h"

namespace tiller {

class ProjectDocument;
class WaypointModel;

class PathWatch : public QObject {
    Q_OBJECT

public:
    /// Whether Go to would be refused in this row.
    using Permits = std::function<Result<void>(int row)>;
    /// All arguments must outlive the object.
    PathWatch(const ProjectDocument& document, WaypointModel& model, Permits permits,
              QObject* parent = nullptr);

    void setState(const SessionState& state);

private:
    void lookAgain();
    void look();

    const ProjectDocument& document_;
    WaypointModel& model_;
    Permits permits_;
    QTimer timer_;
    JointPositions lookedFrom_;
    std::shared_ptr<const collision::CollisionCheck> lookedWith_;
    bool isOutdated_ = false;
    int next_ = 0;  ///< the next row
    int left_ = 0;  ///< number of rows still to check
};

}  // namespace tiller
