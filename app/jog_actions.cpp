// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/jog_actions.h"

#include "app/action_table.h"
#include "robot/station/jog/freedrive_axes.h"
#include "robot/station/text/notation.h"
#include "robot/station/text/texts.h"
#include "widgets/jog/jog_column.h"
#include "widgets/jog/jog_selectors.h"
#include "widgets/jog/keyboard_jog.h"

namespace tiller::app {
namespace {

constexpr double kContactForces[] = {10, 20, 50};

QString stepId(const StepPreset& step) {
    return QStringLiteral("jog.step.%1").arg(step.millimetres);
}

QString speedName(double tcpSpeed) {
    return JogActions::tr("Jog speed %1").arg(format::speed(tcpSpeed));
}

QString stepName(const StepPreset& step) {
    return JogActions::tr("Jog step %1, %2°")
        .arg(format::shortLength(step.millimetres / 1e3))
        .arg(step.degrees);
}

}  // namespace

void JogActions::addTo(ActionTable& table, JogColumn& column, KeyboardJog& keyboard,
                       const std::function<void()>& showTrainer) {
    table.add(
        {"jog.keyboard", tr("Arm or disarm keyboard jogging"),
         tr("While the keyboard is armed, the arrow keys move the arm and a border surrounds the window. The "
            "keyboard is disarmed after 30 s without use."),
         QKeySequence(Qt::CTRL | Qt::Key_J), [&keyboard] { keyboard.setArmed(!keyboard.isArmed()); },
         [](const SessionState& s) { return s.monitorOnly ? texts::monitorOnlyObstacle() : QString(); }});
    table.add({"jog.devices",
               tr("Gamepad and SpaceMouse…"),
               tr("Shows the live values of each device and the direction in which the arm would move."),
               {},
               showTrainer});
    table.add({"jog.zero", tr("Zero here"),
               tr("Shows the TCP displacement from the current position. Press again to show the "
                  "displacement since the start of the last motion."),
               QKeySequence(Qt::Key_Z), [&column] { column.zeroHere(); }});
    int index = 0;
    for (const SpeedClass& choice : speedClasses()) {
        table.add({QStringLiteral("jog.speed.%1").arg(index),
                   speedName(choice.tcp),
                   tr("Stops the arm. The next press uses this speed."),
                   {},
                   [&column, index] { column.selectors().setSpeedClass(index); }});
        ++index;
    }
    table.add({"jog.speed.slowest",
               speedName(kSlowestJog),
               tr("Stops the arm. The next press uses this speed."),
               {},
               [&column] { column.selectors().setFreeSpeed(kSlowestJog); }});
    for (const StepPreset& step : kStepPresets) {
        table.add({stepId(step),
                   stepName(step),
                   step.millimetres > 10 || step.degrees > 10
                       ? tr("Moves the arm by this distance while the button is held.")
                       : tr("Each press moves the arm by this distance."),
                   {},
                   [&column, step] { column.selectors().setFreeStep(step.size()); }});
    }
    for (const double force : kContactForces) {
        table.add(
            {QStringLiteral("jog.contact.%1").arg(force),
             tr("Jog until contact (%1 N)").arg(force),
             tr("Moves slowly while the button is held and stops when the contact force reaches this value."),
             {},
             [&column, force] { column.selectors().setUntilContact(force); }});
    }
    // The context menus of the column also contain this command, but some users have no right mouse button.
    table.add({"jog.speed.other",
               tr("Other jog speed…"),
               tr("Sets the TCP speed. Rotation and joint speeds change in proportion."),
               {},
               [&column] { column.selectors().askFor(JogSelectors::Entry::Speed); }});
    table.add({"jog.step.other",
               tr("Other jog step…"),
               tr("Sets the step length. The step angle does not change."),
               {},
               [&column] { column.selectors().askFor(JogSelectors::Entry::Step); }});
    table.add({"jog.turn.other",
               tr("Other jog angle…"),
               tr("Sets the step angle of tool and joint rotations. The step length does not change."),
               {},
               [&column] { column.selectors().askFor(JogSelectors::Entry::Turn); }});
    table.add({"jog.contact.other",
               tr("Other contact force for jogging…"),
               tr("Sets the contact force in N that ends the motion."),
               {},
               [&column] { column.selectors().askFor(JogSelectors::Entry::ContactForce); }});
    index = 0;
    for (const FreedriveAxes axes : kFreedriveAxes) {
        table.add({QStringLiteral("jog.freedrive.%1").arg(index),
                   tr("Freedrive: %1").arg(freedriveAxesText(axes)),
                   tr("Selects the axes that can be moved by hand during Freedrive."),
                   {},
                   [&column, axes] { column.setFreedriveAxes(axes); }});
        ++index;
    }
}

void JogActions::rename(ActionTable& table) {
    int index = 0;
    for (const SpeedClass& choice : speedClasses()) {
        table.find(QStringLiteral("jog.speed.%1").arg(index++))->setText(speedName(choice.tcp));
    }
    table.find("jog.speed.slowest")->setText(speedName(kSlowestJog));
    for (const StepPreset& step : kStepPresets) {
        table.find(stepId(step))->setText(stepName(step));
    }
}

}  // namespace tiller::app
