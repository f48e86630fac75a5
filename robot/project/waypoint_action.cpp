// SPDX-License-Identifier: MIT
#include "robot/project/waypoint_action.h"

#include <QtGlobal>
#include <algorithm>

namespace tiller::project {
namespace {

using Kind = WaypointAction::Kind;
using Pin = WaypointActionKind::Pin;
using Time = WaypointActionKind::Time;
using Grip = WaypointActionKind::Grip;

// The default limit of a wait is 10 s, because a sensor that takes longer usually has a fault.
constexpr WaypointActionKind kKinds[] = {
    {Kind::SetOutput, "setOutput", Pin::Output, Time::None, Grip::None, 0,
     QT_TRANSLATE_NOOP("ActionWords", "Set an output"), QT_TRANSLATE_NOOP("ActionWords", "%1 on"),
     QT_TRANSLATE_NOOP("ActionWords", "%1 off")},
    {Kind::PulseOutput, "pulseOutput", Pin::Output, Time::Duration, Grip::None, 0.5,
     QT_TRANSLATE_NOOP("ActionWords", "Pulse an output"), QT_TRANSLATE_NOOP("ActionWords", "%1 on for %2 s"),
     QT_TRANSLATE_NOOP("ActionWords", "%1 off for %2 s")},
    {Kind::WaitForInput, "waitForInput", Pin::Input, Time::Limit, Grip::None, 10,
     QT_TRANSLATE_NOOP("ActionWords", "Wait for an input"),
     QT_TRANSLATE_NOOP("ActionWords", "Wait until %1 is on (max. %2 s)"),
     QT_TRANSLATE_NOOP("ActionWords", "Wait until %1 is off (max. %2 s)"),
     QT_TRANSLATE_NOOP("ActionWords", "Wait until %1 is on"),
     QT_TRANSLATE_NOOP("ActionWords", "Wait until %1 is off")},
    {Kind::WaitTime, "wait", Pin::None, Time::Duration, Grip::None, 1,
     QT_TRANSLATE_NOOP("ActionWords", "Wait"), QT_TRANSLATE_NOOP("ActionWords", "Wait %1 s")},
    {Kind::OpenGripper, "openGripper", Pin::None, Time::None, Grip::Open, 0,
     QT_TRANSLATE_NOOP("ActionWords", "Open the gripper"),
     QT_TRANSLATE_NOOP("ActionWords", "Open the gripper")},
    {Kind::CloseGripper, "closeGripper", Pin::None, Time::None, Grip::Close, 0,
     QT_TRANSLATE_NOOP("ActionWords", "Close the gripper"),
     QT_TRANSLATE_NOOP("ActionWords", "Close the gripper")},
};

constexpr bool isInOrder() {
    int next = 0;
    return std::all_of(std::begin(kKinds), std::end(kKinds), [&next](const WaypointActionKind& row) {
        return row.kind == static_cast<Kind>(next++);
    });
}
static_assert(isInOrder());

}  // namespace

std::span<const WaypointActionKind> waypointActionKinds() {
    return kKinds;
}

const WaypointActionKind& kindOf(const WaypointAction& action) {
    return kKinds[static_cast<std::size_t>(action.kind)];
}

bool WaypointAction::usesPin() const {
    return kindOf(*this).pin != WaypointActionKind::Pin::None;
}

bool WaypointAction::usesTime() const {
    return kindOf(*this).time != WaypointActionKind::Time::None;
}

}  // namespace tiller::project
