// SPDX-License-Identifier: MIT
#include "robot/station/practice/first_steps.h"

#include <algorithm>

#include "robot/kinematics/arm_kinematics.h"
#include "robot/station/document/project_document.h"
#include "robot/station/link/robot_session.h"

namespace tiller {
namespace {

constexpr double kThere = 0.001;       // tolerance of the TCP position [m]
constexpr double kTurnedThere = 0.01;  // tolerance of the orientation [rad]
constexpr double kSameJoints = 0.005;  // tolerance for a waypoint at the current position [rad]
constexpr double kRealMove = 0.01;     // minimum joint motion that counts [rad]

const char* nameOf(FirstStep step) {
    switch (step) {
        case FirstStep::PowerOn:
            return "powerOn";
        case FirstStep::ReleaseBrakes:
            return "releaseBrakes";
        case FirstStep::Jog:
            return "jog";
        case FirstStep::Teach:
            return "teach";
        case FirstStep::GoTo:
            return "goTo";
        case FirstStep::Record:
            break;
    }
    return "record";
}

double furthest(const JointPositions& a, const JointPositions& b) {
    return (a.values - b.values).cwiseAbs().maxCoeff();
}

}  // namespace

FirstSteps::FirstSteps(RobotSession& session, ProjectDocument& document, QObject* parent)
    : QObject(parent), document_(document) {
    connect(&session, &RobotSession::stateChanged, this, &FirstSteps::onState);
    connect(&document_, &ProjectDocument::waypointsInserted, this, &FirstSteps::onWaypoint);
}

void FirstSteps::setFollowing(bool following) {
    following_ = following;
    if (!following) {
        movedFrom_.reset();
    }
}

bool FirstSteps::allDone() const {
    return std::all_of(done_.begin(), done_.end(), [](bool done) { return done; });
}

QStringList FirstSteps::done() const {
    QStringList names;
    for (const FirstStep step : kFirstSteps) {
        if (isDone(step)) {
            names << QLatin1String(nameOf(step));
        }
    }
    return names;
}

void FirstSteps::setDone(const QStringList& names) {
    for (const FirstStep step : kFirstSteps) {
        done_[static_cast<std::size_t>(step)] = names.contains(QLatin1String(nameOf(step)));
    }
    Q_EMIT changed();
}

QString FirstSteps::text(FirstStep step) {
    switch (step) {
        case FirstStep::PowerOn:
            return tr("Power on (header)");
        case FirstStep::ReleaseBrakes:
            return tr("Release brakes (header)");
        case FirstStep::Jog:
            return tr("Take control and hold a jog button");
        case FirstStep::Teach:
            return tr("Teach here (T)");
        case FirstStep::GoTo:
            return tr("Jog away and hold “Go to” (G)");
        case FirstStep::Record:
            break;
    }
    return tr("Record (above the plots)");
}

void FirstSteps::tick(FirstStep step) {
    bool& done = done_[static_cast<std::size_t>(step)];
    if (!done) {
        done = true;
        Q_EMIT changed();
    }
}

void FirstSteps::onState(const SessionState& state) {
    const SessionState before = std::exchange(state_, state);
    if (!following_ || state.link != LinkState::Live) {
        movedFrom_.reset();
        return;
    }
    if (state.robotMode == RobotMode::Idle || state.robotMode == RobotMode::Running) {
        tick(FirstStep::PowerOn);
    }
    if (state.robotMode == RobotMode::Running) {
        tick(FirstStep::ReleaseBrakes);
    }
    if (state.jogActive && state.moving) {
        tick(FirstStep::Jog);
    }
    if (state.recording.active && state.recording.rows > 0) {
        tick(FirstStep::Record);
    }
    if (state.motionActive && !state.jogActive && !movedFrom_) {
        movedFrom_ = before.hasData() ? before.q : state.q;
    }
    followMove(state);
}

void FirstSteps::followMove(const SessionState& state) {
    if (!movedFrom_ || state.motionActive || state.moving) {
        movedFrom_ = state.jogActive ? std::nullopt : movedFrom_;
        return;
    }
    const JointPositions from = *std::exchange(movedFrom_, std::nullopt);
    const DhParameters& dh = document_.robot().dh;
    const Pose at = kinematics::forwardTcp(dh, state.q);
    for (int row = 0; row < document_.waypoints().size(); ++row) {
        const project::Reach& reach = document_.reach(row);
        if (!reach.ok() || furthest(from, reach.q) < kRealMove) {
            continue;
        }
        const project::PoseDifference by = project::poseDifference(at, kinematics::forwardTcp(dh, reach.q));
        if (by.distance < kThere && by.angle < kTurnedThere) {
            tick(FirstStep::GoTo);
            return;
        }
    }
}

// A pasted or restored waypoint counts as taught only if the arm is at its position.
void FirstSteps::onWaypoint(int row) {
    if (following_ && state_.link == LinkState::Live &&
        furthest(document_.waypoints().at(row).joints, state_.q) < kSameJoints) {
        tick(FirstStep::Teach);
    }
}

}  // namespace tiller

#include "moc_first_steps.cpp"
