// SPDX-License-Identifier: MIT
#include "robot/station/link/obstacles.h"

#include <QCoreApplication>

#include "robot/station/text/texts.h"

namespace tiller {
namespace {

/// Translation context of this file for lupdate.
struct ReasonsText {
    Q_DECLARE_TR_FUNCTIONS(Reasons)
};

}  // namespace

using control::StopCause;

QString cannotMoveReason(const SessionState& state) {
    if (state.canMove()) {
        return {};
    }
    if (!state.controlReason.isEmpty()) {
        return state.controlReason;
    }
    switch (state.link) {
        case LinkState::Disconnected:
            return ReasonsText::tr("No robot connected. Choose a robot at the top left.");
        case LinkState::Connecting:
            return ReasonsText::tr("Connecting…");
        case LinkState::Lost:
            return state.linkReason.isEmpty()
                       ? ReasonsText::tr("No data from the robot. Reconnecting automatically.")
                       : state.linkReason;
        case LinkState::Stale:
            return ReasonsText::tr("Robot data are late. Waiting for new data.");
        case LinkState::Live:
            break;
    }
    if (const QString safety = texts::safetyModeObstacle(state.safetyMode); !safety.isEmpty()) {
        return safety;
    }
    if (const QString mode = texts::robotModeObstacle(state.robotMode); !mode.isEmpty()) {
        return mode;
    }
    return state.control == ControlState::Taking
               ? ReasonsText::tr("Taking control…")
               : ReasonsText::tr("Not in control. Press “Take control” in the header.");
}

QString dataObstacle(const SessionState& state) {
    if (state.link == LinkState::Live) {
        return {};
    }
    return state.hasData() ? ReasonsText::tr("Robot data are out of date. Wait for new data.")
                           : ReasonsText::tr("No robot is connected. Connect a robot, or try the simulator.");
}

QString storeObstacle(const SessionState& state) {
    const QString obstacle = dataObstacle(state);
    return obstacle.isEmpty() && state.moving
               ? ReasonsText::tr("The arm is moving. Stop the arm first, then store the position.")
               : obstacle;
}

StopCause stopCauseFor(const SessionState& state) {
    switch (state.link) {
        case LinkState::Stale:
            return StopCause::DataStale;
        case LinkState::Lost:
        case LinkState::Disconnected:
        case LinkState::Connecting:
            return StopCause::LinkLost;
        case LinkState::Live:
            break;
    }
    if (state.robotMode != RobotMode::Running || !allowsMotion(state.safetyMode)) {
        return StopCause::UnsafeMode;
    }
    return StopCause::ControlLost;
}

QString serviceObstacle(const SessionState& state) {
    if (state.monitorOnly) {
        return texts::monitorOnlyObstacle();
    }
    const bool withoutApi = state.version.isPolyScopeX() && state.version < SoftwareVersion{10, 11, 0, 0} &&
                            state.service == dashboard::ServiceKind::Unknown;
    return withoutApi ? QCoreApplication::translate("Texts",
                                                    "PolyScope X before 10.11 does not accept these commands "
                                                    "over the network. Use the teach pendant.")
                      : QString();
}

QString serviceObstacle(const SessionState& state, dashboard::RobotCommand command) {
    return state.monitorOnly || dashboard::offers(state.service, command)
               ? serviceObstacle(state)
               : QCoreApplication::translate(
                     "Texts", "PolyScope X cannot close popups over the network. Use the teach pendant.");
}

}  // namespace tiller
