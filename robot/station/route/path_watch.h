// SPDX-License-Identifier: MIT
#pragma once

// Checks for each waypoint whether the arm may move to it from its current position, a few waypoints at a time, so
// that no frame has to wait for all.

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
    /// Whether Go to would be refused in this row.
    using Permits = std::function<Result<void>(int row)>;
    /// All must outlive it.
    PathWatch(const ProjectDocument& document, Permits permits, QObject* parent = nullptr);

    void setState(const SessionState& state);

Q_SIGNALS:
    /// A waypoint was looked at.
    /// limit  why the arm would be refused to go there, as a sentence; empty when it would not
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
    int next_ = 0;  ///< the next row
    int left_ = 0;  ///< number of rows still to check
};

}  // namespace tiller
