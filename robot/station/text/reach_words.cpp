// SPDX-License-Identifier: MIT
#include "robot/station/text/reach_words.h"

#include <QCoreApplication>

namespace tiller {
namespace {

/// Translation context of this file for lupdate.
struct WaypointModelText {
    Q_DECLARE_TR_FUNCTIONS(tiller::WaypointModel)
};

}  // namespace

QString reachText(const project::Reach& reach) {
    switch (reach.obstacle) {
        case project::Reach::Obstacle::None:
            return QStringLiteral("✓");
        case project::Reach::Obstacle::JointLimit:
            return WaypointModelText::tr("✕ joint");
        case project::Reach::Obstacle::FrameMissing:
            return WaypointModelText::tr("✕ frame");
        case project::Reach::Obstacle::OutOfReach:
            break;
        case project::Reach::Obstacle::OnTheWay:
            return WaypointModelText::tr("✕ line");
        case project::Reach::Obstacle::OtherModel:
            return WaypointModelText::tr("✕ model");
    }
    return WaypointModelText::tr("✕ reach");
}

QString reachAdvice(const project::Reach& reach) {
    switch (reach.obstacle) {
        case project::Reach::Obstacle::None:
            return {};
        case project::Reach::Obstacle::JointLimit:
            return WaypointModelText::tr(
                "A joint would exceed its limit. Touch up the waypoint with a different arm configuration.");
        case project::Reach::Obstacle::FrameMissing:
            return WaypointModelText::tr(
                "The frame of the waypoint is not in this project. Choose a different frame.");
        case project::Reach::Obstacle::OnTheWay:
            return WaypointModelText::tr(
                "The straight line from the current position leaves the reach of the arm. Use MoveJ, or "
                "start from a different position.");
        case project::Reach::Obstacle::OtherModel:
            return WaypointModelText::tr(
                "The project was taught with a different robot model. Use “Adapt project to this robot…” "
                "first.");
        case project::Reach::Obstacle::OutOfReach:
            break;
    }
    return WaypointModelText::tr("Out of reach. Touch up the waypoint closer to the base.");
}

}  // namespace tiller
