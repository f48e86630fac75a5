// SPDX-License-Identifier: GPL-3.0-or-later

// What the jog column can do, as commands: for those who have no mouse, and for the palette.

#include "app/action_table.h"
#include "app/main_window.h"
#include "widgets/jog/freedrive_axes.h"
#include "widgets/jog/jog_column.h"
#include "widgets/jog/keyboard_jog.h"

namespace tiller::app {
namespace {

constexpr double kRadPerDegree = 0.017453292519943295;

/// Source: operator-interface.md, "Numbers"
struct Step {
    double millimetres;
    double degrees;
};
constexpr Step kSteps[] = {{0.05, 0.01}, {0.1, 0.1}, {1, 1}, {5, 5}, {10, 15}, {50, 45}, {100, 90}};
constexpr double kContactForces[] = {10, 20, 50};

}  // namespace

void MainWindow::addJogActions() {
    actions_->add({"jog.keyboard", tr("Arm or disarm the keyboard"),
                   tr("Armed, the arrow keys move the arm; a frame stands around the window. Ends by itself "
                      "after half a minute."),
                   QKeySequence(Qt::CTRL | Qt::Key_J),
                   [this] { keyboard_->setArmed(!keyboard_->isArmed()); }});
    actions_->add({"jog.devices",
                   tr("Gamepad and SpaceMouse…"),
                   tr("What each device says now, and which way it will go."),
                   {},
                   [this] { showTrainer(this); }});
    actions_->add({"jog.zero", tr("Zero here"),
                   tr("Counts the way of the TCP from where it is now; once more: since the press again."),
                   QKeySequence(Qt::Key_Z), [this] { jog_->zeroHere(); }});
    int index = 0;
    for (const SpeedClass& choice : speedClasses()) {
        actions_->add({QStringLiteral("jog.speed.%1").arg(index),
                       tr("Jog speed %1 mm/s").arg(choice.tcp * 1e3, 0, 'f', 0),
                       tr("Stops the arm; the next press has this speed."),
                       {},
                       [this, index] { jog_->setSpeedClass(index); }});
        ++index;
    }
    actions_->add({"jog.speed.slowest",
                   tr("Jog speed %1 mm/s").arg(1),
                   tr("Stops the arm; the next press has this speed."),
                   {},
                   [this] { jog_->setFreeSpeed(0.001); }});
    for (const Step& step : kSteps) {
        actions_->add({QStringLiteral("jog.step.%1").arg(step.millimetres),
                       tr("Jog step %1 mm, %2°").arg(step.millimetres).arg(step.degrees),
                       step.millimetres > 10 || step.degrees > 10
                           ? tr("Moves by this much, only while the key is held.")
                           : tr("Moves by this much at each press."),
                       {},
                       [this, step] {
                           jog_->setFreeStep({step.millimetres / 1e3, step.degrees * kRadPerDegree});
                       }});
    }
    for (const double force : kContactForces) {
        actions_->add({QStringLiteral("jog.contact.%1").arg(force),
                       tr("Jog until contact, %1 N").arg(force),
                       tr("A held key moves slowly and ends when the tool meets this force."),
                       {},
                       [this, force] { jog_->setUntilContact(force); }});
    }
    // As the last entries of the column's own menus, for those who have no second mouse button.
    actions_->add({"jog.speed.other",
                   tr("Jog speed, other…"),
                   tr("Asks for the speed of the TCP in mm/s; turns and joints in proportion."),
                   {},
                   [this] { jog_->askFor(JogColumn::Entry::Speed); }});
    actions_->add({"jog.step.other",
                   tr("Jog step, other…"),
                   tr("Asks for the length of a step in mm; turns make as many degrees."),
                   {},
                   [this] { jog_->askFor(JogColumn::Entry::Step); }});
    actions_->add({"jog.contact.other",
                   tr("Jog until contact, other force…"),
                   tr("Asks for the force in N at which the motion ends."),
                   {},
                   [this] { jog_->askFor(JogColumn::Entry::ContactForce); }});
    index = 0;
    for (const FreedriveAxes axes : kFreedriveAxes) {
        actions_->add({QStringLiteral("jog.freedrive.%1").arg(index),
                       tr("Freedrive: %1").arg(freedriveAxesText(axes)),
                       tr("What the hand can move while Freedrive is held."),
                       {},
                       [this, axes] { jog_->setFreedriveAxes(axes); }});
        ++index;
    }
}

}  // namespace tiller::app
