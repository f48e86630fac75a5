// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Which of the first things to do with an arm have been done. Each is taken from what the robot, the project or
// the recorder tells, never from a key that was pressed.

#include <QObject>
#include <QStringList>
#include <array>
#include <optional>

#include "robot/station/link/session_state.h"

namespace tiller {

class ProjectDocument;
class RobotSession;

enum class FirstStep { PowerOn, ReleaseBrakes, Jog, Teach, GoTo, Record };
inline constexpr std::array kFirstSteps = {FirstStep::PowerOn, FirstStep::ReleaseBrakes, FirstStep::Jog,
                                           FirstStep::Teach,   FirstStep::GoTo,          FirstStep::Record};

class FirstSteps : public QObject {
    Q_OBJECT

public:
    /// session, document  must outlive it
    FirstSteps(RobotSession& session, ProjectDocument& document, QObject* parent = nullptr);

    /// Only what happens while it is followed counts; at first nothing does.
    void setFollowing(bool following);
    bool isDone(FirstStep step) const { return done_[static_cast<std::size_t>(step)]; }
    bool allDone() const;
    /// Names of those done, for the settings, and the way back.
    QStringList done() const;
    void setDone(const QStringList& names);

    /// What to do, in one line.
    static QString text(FirstStep step);

Q_SIGNALS:
    void changed();

private:
    void onState(const SessionState& state);
    void onWaypoint(int row);
    void followMove(const SessionState& state);
    void tick(FirstStep step);

    ProjectDocument& document_;
    SessionState state_;
    bool following_ = false;
    std::array<bool, kFirstSteps.size()> done_{};
    std::optional<JointPositions> movedFrom_;  ///< since a move of ours began, until the arm stands after it
};

}  // namespace tiller
