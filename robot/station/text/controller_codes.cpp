// SPDX-License-Identifier: MIT
#include "robot/station/text/controller_codes.h"

#include <QCoreApplication>
#include <array>

namespace tiller {
namespace {

struct ControllerCodes {
    Q_DECLARE_TR_FUNCTIONS(ControllerCodes)

public:
    struct Row {
        int code;
        const char* title;
        const char* meaning;
        const char* action;
    };
    // The table contains only codes with a publicly documented meaning. Source: the manufacturer's error code
    // directory.
    static constexpr auto kRows = std::to_array<Row>({
        {150, QT_TR_NOOP("Near a joint limit"), QT_TR_NOOP("A joint came close to its limit."),
         QT_TR_NOOP("Jog the joint away from the limit, or change the waypoint.")},
        {151, QT_TR_NOOP("Near a tool orientation limit"),
         QT_TR_NOOP("The tool orientation came close to the limit set in the safety configuration."),
         QT_TR_NOOP("Rotate the tool away from the limit, or change the waypoint.")},
        {152, QT_TR_NOOP("Near a safety plane"), QT_TR_NOOP("The arm came close to a safety plane."),
         QT_TR_NOOP("Jog away from the plane, or change the waypoint.")},
        {153, QT_TR_NOOP("Position deviates from path"),
         QT_TR_NOOP("The arm is not at the commanded position."),
         QT_TR_NOOP(
             "Check for obstacles; check payload, centre of gravity and mounting; reduce the acceleration.")},
        {154, QT_TR_NOOP("Singularity"),
         QT_TR_NOOP("The linear move passes through a singularity of the arm."),
         QT_TR_NOOP(
             "Jog individual joints away from the singularity. Use MoveJ to pass through the region.")},
        {155, QT_TR_NOOP("Cannot hold position"),
         QT_TR_NOOP("The arm sagged or was pushed while at standstill."),
         QT_TR_NOOP("Check payload, centre of gravity and mounting.")},
        {156, QT_TR_NOOP("Wrong payload or mounting"),
         QT_TR_NOOP(
             "The measured forces do not match the payload, or the arm was pushed when Freedrive started."),
         QT_TR_NOOP("Correct the payload and the mounting, and do not push the arm when Freedrive starts.")},
        {157, QT_TR_NOOP("Collision detected by a joint"),
         QT_TR_NOOP("A joint required more torque than expected for the motion."),
         QT_TR_NOOP("Remove the obstacle. If the arm did not touch anything, check the payload.")},
        {158, QT_TR_NOOP("Collision detected at the tool"),
         QT_TR_NOOP("The force at the tool exceeded the limit."),
         QT_TR_NOOP("Remove the obstacle. If the arm did not touch anything, check the payload.")},
        {159, QT_TR_NOOP("Position deviation"), QT_TR_NOOP("A joint deviated from its commanded position."),
         QT_TR_NOOP("Check for obstacles, and check payload and mounting.")},
        {163, QT_TR_NOOP("Too many protective stops"),
         QT_TR_NOOP("One joint had fifty protective stops within eight hours."),
         QT_TR_NOOP("Find and correct the cause of the stops, then restart the controller.")},
        {203, QT_TR_NOOP("Sudden change in target position"),
         QT_TR_NOOP("A program commanded an abrupt change in position."),
         QT_TR_NOOP(
             "Start the program at the current position of the arm, and send servo targets in small steps.")},
        {204, QT_TR_NOOP("Sudden change in target speed"),
         QT_TR_NOOP("A program commanded an abrupt change in speed."),
         QT_TR_NOOP("Reduce the acceleration, or smooth the path.")},
        {209, QT_TR_NOOP("Protective stop requested by a program"),
         QT_TR_NOOP("The running program requested the stop."),
         QT_TR_NOOP("See the preceding program messages in the log.")},
        {210, QT_TR_NOOP("Robot is in Local control"),
         QT_TR_NOOP("A script was sent, but the robot accepts commands only from its teach pendant."),
         QT_TR_NOOP("Switch to Remote control on the teach pendant.")},
    });

    static CodeWords words(int code) {
        for (const Row& row : kRows) {
            if (row.code == code) {
                return {tr(row.title), tr(row.meaning), tr(row.action), true};
            }
        }
        return {tr("Controller message C%1").arg(code), tr("Tiller has no description of this message code."),
                tr("Look up C%1 in the manufacturer's error code directory.").arg(code), false};
    }
};

}  // namespace

CodeWords controllerCode(int code) {
    return ControllerCodes::words(code);
}

}  // namespace tiller
