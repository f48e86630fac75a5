// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the tab's keys and shortcuts do, apart from moving the arm.

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QMenu>
#include <QToolButton>
#include <algorithm>

#include "robot/kinematics/arm_kinematics.h"
#include "widgets/common/format.h"
#include "widgets/common/joint_name.h"
#include "widgets/common/notation.h"
#include "widgets/common/notice_bar.h"
#include "widgets/project/project_document.h"
#include "widgets/session/texts.h"
#include "widgets/waypoints/waypoint_clipboard.h"
#include "widgets/waypoints/waypoint_details.h"
#include "widgets/waypoints/waypoint_model.h"
#include "widgets/waypoints/waypoint_table.h"
#include "widgets/waypoints/waypoints_tab.h"

namespace tiller {

QAction* WaypointsTab::addCommand(const QString& name, const QString& text, const QKeySequence& shortcut,
                                  std::function<void()> run) {
    auto* action = new QAction(text, this);
    action->setObjectName(name);
    action->setShortcut(shortcut);
    action->setAutoRepeat(false);
    connect(action, &QAction::triggered, this, [run = std::move(run)] { run(); });
    actions_.append(action);
    return action;
}

void WaypointsTab::buildActions() {
    const auto onSelected = [](QAction* action) {
        action->setProperty("needsSelection", true);
        return action;
    };
    QAction* teach = addCommand("waypoint.action.teach", tr("Teach here"), QKeySequence(Qt::Key_T),
                                [this] { this->teach(); });
    QAction* touchUp = onSelected(addCommand("waypoint.action.touchUp", tr("Touch up"),
                                             QKeySequence(Qt::Key_U), [this] { this->touchUp(); }));
    // Everywhere in the window: the hand is on the jog pad while teaching.
    addAction(teach);
    addAction(touchUp);

    auto* menu = new QMenu(this);
    menu->setObjectName(QStringLiteral("waypoint.menu"));
    const auto add = [&](QAction* action) {
        action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
        menu->addAction(action);
        addAction(action);
    };
    add(onSelected(addCommand("waypoint.action.rename", tr("Rename"), QKeySequence(Qt::Key_F2),
                              [this] { table_->renameCurrent(); })));
    add(onSelected(addCommand("waypoint.action.duplicate", tr("Duplicate"),
                              QKeySequence(Qt::CTRL | Qt::Key_D), [this] { duplicateSelected(); })));
    add(onSelected(addCommand("waypoint.action.delete", tr("Delete"), QKeySequence(Qt::Key_Delete),
                              [this] { deleteSelected(); })));
    add(onSelected(addCommand("waypoint.action.up", tr("Move up"), QKeySequence(Qt::ALT | Qt::Key_Up),
                              [this] { moveSelected(-1); })));
    add(onSelected(addCommand("waypoint.action.down", tr("Move down"), QKeySequence(Qt::ALT | Qt::Key_Down),
                              [this] { moveSelected(1); })));
    menu->addSeparator();
    add(onSelected(addCommand("waypoint.action.copy", tr("Copy as table"), QKeySequence(QKeySequence::Copy),
                              [this] { copySelected(); })));
    add(addCommand("waypoint.action.paste", tr("Paste"), QKeySequence(QKeySequence::Paste),
                   [this] { paste(); }));
    menu->addSeparator();
    QUndoStack& undo = document_.undoStack();
    for (QAction* action :
         {undo.createUndoAction(this, tr("Undo")), undo.createRedoAction(this, tr("Redo"))}) {
        const bool isUndo = actions_.last()->objectName() != QLatin1String("waypoint.action.undo");
        action->setObjectName(isUndo ? QStringLiteral("waypoint.action.undo")
                                     : QStringLiteral("waypoint.action.redo"));
        action->setShortcuts(isUndo ? QList<QKeySequence>{QKeySequence(Qt::CTRL | Qt::Key_Z)}
                                    : QList<QKeySequence>{QKeySequence(Qt::CTRL | Qt::Key_Y),
                                                          QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z)});
        actions_.append(action);
        add(action);
    }
    more_->setMenu(menu);
    table_->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(table_, &QWidget::customContextMenuRequested, this,
            [this, menu](const QPoint& position) { menu->popup(table_->viewport()->mapToGlobal(position)); });
}

void WaypointsTab::addToMenu(const QList<QAction*>& actions) {
    more_->menu()->addSeparator();
    more_->menu()->addActions(actions);
}

// ---- teaching --------------------------------------------------------------------------------------

void WaypointsTab::teach() {
    if (const QString obstacle = teachObstacle(); !obstacle.isEmpty()) {
        showProblem(obstacle);
        return;
    }
    const int row = currentRow();
    project::Waypoint point;
    if (row >= 0) {
        // A neighbour usually wants the same kind of move, frame and speed.
        point = document_.waypoints().at(row);
        point.extra = {};
    }
    point.id = QUuid::createUuid();
    point.name = document_.waypoints().nextName(tr("waypoint"));
    std::optional<project::Waypoint> taught =
        project::taughtAt(point, state_.q, state_.tcpPose, state_.tcpOffset, document_.frames());
    if (!taught) {
        point.frame = QUuid();
        taught = project::taughtAt(point, state_.q, state_.tcpPose, state_.tcpOffset, document_.frames());
    }
    document_.insertWaypoints(row < 0 ? model_->rowCount() : row + 1, {*taught},
                              tr("Teach “%1”").arg(point.name));
}

void WaypointsTab::touchUp() {
    const int row = currentRow();
    const QString obstacle = row < 0 ? tr("Select a waypoint to touch up.") : teachObstacle();
    if (!obstacle.isEmpty()) {
        showProblem(obstacle);
        return;
    }
    const project::Waypoint before = document_.waypoints().at(row);
    const std::optional<project::Waypoint> after =
        project::taughtAt(before, state_.q, state_.tcpPose, state_.tcpOffset, document_.frames());
    if (!after) {
        showProblem(
            tr("The frame of “%1” is not in this project. Choose another frame first.").arg(before.name));
        return;
    }
    const Pose old = kinematics::forwardTcp(
        document_.robot().dh, document_.reach(row).ok() ? document_.reach(row).q : before.joints,
        before.tcpOffset);
    const project::PoseDifference by = project::poseDifference(old, state_.tcpPose);
    const Vector6 turns = after->joints.values - before.joints.values;
    int joint = 0;
    turns.cwiseAbs().maxCoeff(&joint);
    const QString text = tr("The live place is %1 away (%2, base frame). Largest joint change: %3 %4.")
                             .arg(format::difference(by.distance, by.angle),
                                  format::shift(state_.tcpPose.position - old.position), jointName(joint),
                                  format::degrees(turns[joint], 1));
    notice_->show(NoticeBar::Kind::Question, tr("Touch up “%1”?").arg(before.name), text, tr("Touch up"),
                  [this, id = before.id, taught = *after] { replaceByTouchUp(id, taught); });
}

void WaypointsTab::replaceByTouchUp(const QUuid& id, const project::Waypoint& taught) {
    // What was shown is what is kept, even if the arm has moved on since.
    const int row = document_.waypoints().indexOf(id);
    if (row >= 0) {
        document_.changeWaypoint(row, taught, tr("Touch up “%1”").arg(taught.name));
    }
}

// ---- editing ---------------------------------------------------------------------------------------

void WaypointsTab::duplicateSelected() {
    const QList<int> rows = table_->selectedRows();
    if (rows.isEmpty()) {
        return;
    }
    project::WaypointList names = document_.waypoints();
    std::vector<project::Waypoint> copies;
    for (const int row : rows) {
        project::Waypoint copy = document_.waypoints().at(row);
        copy.id = QUuid::createUuid();
        copy.name = names.uniqueName(copy.name);
        names.append(copy);
        copies.push_back(std::move(copy));
    }
    const QString text = copies.size() == 1
                             ? tr("Duplicate “%1”").arg(document_.waypoints().at(rows[0]).name)
                             : tr("Duplicate %n waypoints", nullptr, static_cast<int>(copies.size()));
    document_.insertWaypoints(rows.last() + 1, copies, text);
}

void WaypointsTab::deleteSelected() {
    const QList<int> rows = table_->selectedRows();
    if (rows.isEmpty()) {
        return;
    }
    document_.removeWaypoints(rows);
    selectRow(std::min(rows.first(), model_->rowCount() - 1));
}

void WaypointsTab::moveSelected(int by) {
    const QList<int> rows = table_->selectedRows();
    if (rows.isEmpty() || (by < 0 && rows.first() == 0) ||
        (by > 0 && rows.last() == model_->rowCount() - 1)) {
        return;
    }
    document_.moveWaypointsBefore(rows, by < 0 ? rows.first() - 1 : rows.last() + 2);
}

void WaypointsTab::copySelected() {
    std::vector<project::Waypoint> chosen;
    for (const int row : table_->selectedRows()) {
        chosen.push_back(document_.waypoints().at(row));
    }
    if (!chosen.empty()) {
        QApplication::clipboard()->setText(waypoint_clipboard::toText(chosen, document_.frames()));
    }
}

void WaypointsTab::paste() {
    Result<std::vector<project::Waypoint>> pasted =
        waypoint_clipboard::fromText(QApplication::clipboard()->text(), document_.frames());
    if (!pasted) {
        notice_->show(NoticeBar::Kind::Warning, tr("Nothing was pasted"), pasted.error().context);
        return;
    }
    if (pasted->empty()) {
        showProblem(tr("There are no waypoints on the clipboard."));
        return;
    }
    project::WaypointList names = document_.waypoints();
    for (project::Waypoint& point : *pasted) {
        point.name = names.uniqueName(point.name);
        names.append(point);
    }
    const int row = currentRow();
    document_.insertWaypoints(row < 0 ? model_->rowCount() : row + 1, *pasted,
                              tr("Paste %n waypoints", nullptr, static_cast<int>(pasted->size())));
}

}  // namespace tiller
