// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/session/controller_codes.h"

#include <QCoreApplication>
#include <array>

namespace tiller {
namespace {

QString tr(const char* text) {
    return QCoreApplication::translate("ControllerCodes", text);
}

struct Row {
    int code;
    const char* title;
    const char* meaning;
    const char* action;
};

// Only numbers whose meaning is documented publicly. Source: modes.md sections 3.1 and 3.2; the
// manufacturer's error code directory.
constexpr auto kCodes = std::to_array<Row>({
    {150, QT_TRANSLATE_NOOP("ControllerCodes", "Near a joint limit"),
     QT_TRANSLATE_NOOP("ControllerCodes", "A joint came close to the end of its range."),
     QT_TRANSLATE_NOOP("ControllerCodes", "Jog the joint back, and plan the move away from the limit.")},
    {151, QT_TRANSLATE_NOOP("ControllerCodes", "Near a tool orientation limit"),
     QT_TRANSLATE_NOOP("ControllerCodes",
                       "The tool turned close to the limit set in the safety configuration."),
     QT_TRANSLATE_NOOP("ControllerCodes", "Turn the tool back, or change the waypoint.")},
    {152, QT_TRANSLATE_NOOP("ControllerCodes", "Near a safety plane"),
     QT_TRANSLATE_NOOP("ControllerCodes", "The arm came close to a safety plane."),
     QT_TRANSLATE_NOOP("ControllerCodes", "Jog away from the plane, or change the waypoint.")},
    {153, QT_TRANSLATE_NOOP("ControllerCodes", "Position deviates from path"),
     QT_TRANSLATE_NOOP("ControllerCodes", "The arm is not where the controller sent it."),
     QT_TRANSLATE_NOOP("ControllerCodes",
                       "Look for an obstacle; check payload, centre of gravity and mounting; lower the "
                       "acceleration.")},
    {154, QT_TRANSLATE_NOOP("ControllerCodes", "Singularity"),
     QT_TRANSLATE_NOOP("ControllerCodes", "The straight move leads through a singular position of the arm."),
     QT_TRANSLATE_NOOP("ControllerCodes", "Jog single joints out of it; use MoveJ through this region.")},
    {155, QT_TRANSLATE_NOOP("ControllerCodes", "Cannot hold its position"),
     QT_TRANSLATE_NOOP("ControllerCodes", "The arm sagged or was pushed while it stood."),
     QT_TRANSLATE_NOOP("ControllerCodes", "Check payload, centre of gravity and mounting.")},
    {156, QT_TRANSLATE_NOOP("ControllerCodes", "Wrong payload or mounting"),
     QT_TRANSLATE_NOOP(
         "ControllerCodes",
         "The forces do not fit the payload, or something pushed the arm when Freedrive began."),
     QT_TRANSLATE_NOOP("ControllerCodes", "Correct payload and mounting, let go of the arm, and try again.")},
    {157, QT_TRANSLATE_NOOP("ControllerCodes", "Collision noticed by a joint"),
     QT_TRANSLATE_NOOP("ControllerCodes", "A joint needed more torque than the motion explains."),
     QT_TRANSLATE_NOOP("ControllerCodes", "Remove the obstacle; if there was none, check the payload.")},
    {158, QT_TRANSLATE_NOOP("ControllerCodes", "Collision noticed by the tool force"),
     QT_TRANSLATE_NOOP("ControllerCodes", "The force at the tool exceeded what is allowed."),
     QT_TRANSLATE_NOOP("ControllerCodes", "Remove the obstacle; if there was none, check the payload.")},
    {159, QT_TRANSLATE_NOOP("ControllerCodes", "Position deviation"),
     QT_TRANSLATE_NOOP("ControllerCodes", "A joint left its commanded position."),
     QT_TRANSLATE_NOOP("ControllerCodes", "Look for an obstacle and check payload and mounting.")},
    {163, QT_TRANSLATE_NOOP("ControllerCodes", "Too many protective stops"),
     QT_TRANSLATE_NOOP("ControllerCodes", "One joint had more than fifty protective stops in eight hours."),
     QT_TRANSLATE_NOOP("ControllerCodes",
                       "Find the cause of the stops before going on; then restart the "
                       "controller.")},
    {203, QT_TRANSLATE_NOOP("ControllerCodes", "Sudden change of target position"),
     QT_TRANSLATE_NOOP("ControllerCodes", "A program asked for a jump in position."),
     QT_TRANSLATE_NOOP("ControllerCodes",
                       "Let the program begin where the arm is, and keep its servo steps small.")},
    {204, QT_TRANSLATE_NOOP("ControllerCodes", "Sudden change of target speed"),
     QT_TRANSLATE_NOOP("ControllerCodes", "A program asked for a jump in speed."),
     QT_TRANSLATE_NOOP("ControllerCodes", "Lower the acceleration, or smooth the path.")},
    {209, QT_TRANSLATE_NOOP("ControllerCodes", "Protective stop by a program"),
     QT_TRANSLATE_NOOP("ControllerCodes", "The running program itself asked for the stop."),
     QT_TRANSLATE_NOOP("ControllerCodes", "See the program's own messages before it.")},
    {210, QT_TRANSLATE_NOOP("ControllerCodes", "Robot is in Local control"),
     QT_TRANSLATE_NOOP("ControllerCodes", "A script was sent, but the robot listens to its pendant only."),
     QT_TRANSLATE_NOOP("ControllerCodes", "Switch to Remote control on the teach pendant.")},
});

}  // namespace

CodeWords controllerCode(int code) {
    for (const Row& row : kCodes) {
        if (row.code == code) {
            return {tr(row.title), tr(row.meaning), tr(row.action), true};
        }
    }
    return {tr("Controller message C%1").arg(code), tr("The controller reported this number."),
            tr("Look C%1 up in the manufacturer's error code directory.").arg(code), false};
}

}  // namespace tiller
