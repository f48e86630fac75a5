// SPDX-License-Identifier: MIT
#pragma once

// Checks for each waypoint whether the arm may move to it from its current position. Checks only a few
// waypoints per frame, so that frames are not delayed.

#include <QObject>
#include <QTimer>
#include <QUuid>
#include <functional>
#include <memory>

#include "robot/core/result.h"
#include "robot/station/link/session_state.h"

namespace tiller {

class ProjectDocument;

class PathWatch : public QObject {
    Q_OBJECT

public:
    /// Returns an error if "Go to" would be refused for this row.
    using Permits = std::function<Result<void>(int row)>;
    /// Both arguments must outlive the object.
    PathWatch(const ProjectDocument& document, Permits permits, QObject* parent = nullptr);

    void setState(const SessionState& state);

Q_SIGNALS:
    /// A waypoint was checked.
    /// limit  why the move would be refused, as a sentence; empty if it is permitted or cannot be checked
    void looked(const QUuid& waypoint, const QString& limit);

private:
    void lookAgain();
    void look();

    const ProjectDocument& document_;
    Permits permits_;
    QTimer timer_;
    JointPositions lookedFrom_;
    std::shared_ptr<const collision::CollisionCheck> lookedWith_;
    bool isOutdated_ = false;
    int next_ = 0;  ///< row to check next
    int left_ = 0;  ///< number of rows still to check
};

}  // namespace tiller
