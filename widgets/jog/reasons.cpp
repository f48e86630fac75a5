// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/jog/reasons.h"

#include <QCoreApplication>

#include "widgets/session/texts.h"

namespace tiller {

using control::StopCause;

QString cannotMoveReason(const SessionState& state) {
    const auto text = [](const char* source) { return QCoreApplication::translate("Reasons", source); };
    if (state.canMove()) {
        return {};
    }
    if (!state.controlReason.isEmpty()) {
        return state.controlReason;
    }
    switch (state.link) {
        case LinkState::Disconnected:
            return text("No robot connected. Choose one at the top left.");
        case LinkState::Connecting:
            return text("Connecting…");
        case LinkState::Lost:
            return state.linkReason.isEmpty() ? text("No data from the robot. Reconnecting by itself.")
                                              : state.linkReason;
        case LinkState::Stale:
            return text("Robot data is late. Waiting for it to come back.");
        case LinkState::Live:
            break;
    }
    if (const QString safety = texts::safetyModeObstacle(state.safety()); !safety.isEmpty()) {
        return safety;
    }
    if (const QString mode = texts::robotModeObstacle(state.robotMode); !mode.isEmpty()) {
        return mode;
    }
    return state.control == ControlState::Taking
               ? text("Taking control…")
               : text("Not in control. Press “Take control” in the header.");
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
    if (state.robotMode != RobotMode::Running || !allowsMotion(state.safety())) {
        return StopCause::UnsafeMode;
    }
    return StopCause::ControlLost;
}

}  // namespace tiller
