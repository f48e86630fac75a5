// SPDX-License-Identifier: GPL-3.0-or-later

// What the jog column can do, as commands: for those who have no mouse, and for the palette.

#include "app/action_table.h"
#include "app/main_window.h"
#include "widgets/common/notation.h"
#include "widgets/jog/freedrive_axes.h"
#include "widgets/jog/jog_column.h"
#include "widgets/jog/keyboard_jog.h"

namespace tiller::app {
namespace {

constexpr double kContactForces[] = {10, 20, 50};

QString stepId(const StepPreset& step) {
    return QStringLiteral("jog.step.%1").arg(step.millimetres);
}

QString speedName(double tcpSpeed) {
    return MainWindow::tr("Jog speed %1").arg(format::speed(tcpSpeed));
}

QString stepName(const StepPreset& step) {
    return MainWindow::tr("Jog step %1, %2°")
        .arg(format::shortLength(step.millimetres / 1e3))
        .arg(step.degrees);
}

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
                       speedName(choice.tcp),
                       tr("Stops the arm; the next press has this speed."),
                       {},
                       [this, index] { jog_->setSpeedClass(index); }});
        ++index;
    }
    actions_->add({"jog.speed.slowest",
                   speedName(kSlowestJog),
                   tr("Stops the arm; the next press has this speed."),
                   {},
                   [this] { jog_->setFreeSpeed(kSlowestJog); }});
    for (const StepPreset& step : kStepPresets) {
        actions_->add({stepId(step),
                       stepName(step),
                       step.millimetres > 10 || step.degrees > 10
                           ? tr("Moves by this much, only while the key is held.")
                           : tr("Moves by this much at each press."),
                       {},
                       [this, step] { jog_->setFreeStep(step.size()); }});
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
                   tr("Asks for the speed of the TCP; turns and joints in proportion."),
                   {},
                   [this] { jog_->askFor(JogColumn::Entry::Speed); }});
    actions_->add({"jog.step.other",
                   tr("Jog step, other…"),
                   tr("Asks for the length of a step; turns make as many degrees as millimetres."),
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

void MainWindow::nameJogActions() {
    int index = 0;
    for (const SpeedClass& choice : speedClasses()) {
        actions_->find(QStringLiteral("jog.speed.%1").arg(index++))->setText(speedName(choice.tcp));
    }
    actions_->find("jog.speed.slowest")->setText(speedName(kSlowestJog));
    for (const StepPreset& step : kStepPresets) {
        actions_->find(stepId(step))->setText(stepName(step));
    }
}

}  // namespace tiller::app
