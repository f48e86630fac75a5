// SPDX-License-Identifier: MIT
#pragma once

// Progress of the first steps. Steps are detected from the state of the robot, the project and the recorder
// instead of user input.

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
    /// session, document  must outlive the object
    FirstSteps(RobotSession& session, ProjectDocument& document, QObject* parent = nullptr);

    /// Sets whether events complete steps. Initially false.
    void setFollowing(bool following);
    bool isDone(FirstStep step) const { return done_[static_cast<std::size_t>(step)]; }
    bool allDone() const;
    /// Names of the completed steps. The settings store these names.
    QStringList done() const;
    void setDone(const QStringList& names);

    /// Returns the instruction as one line of text.
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
    /// Start position of the current motion of this application; empty without a motion.
    std::optional<JointPositions> movedFrom_;
};

}  // namespace tiller
