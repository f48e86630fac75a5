// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the tab's keys and shortcuts do to the frames.

#include <QAction>
#include <QMenu>
#include <QToolButton>

#include "widgets/common/notation.h"
#include "widgets/common/notice_bar.h"
#include "widgets/frames/frame_details.h"
#include "widgets/frames/frame_model.h"
#include "widgets/frames/frame_table.h"
#include "widgets/frames/frame_teacher.h"
#include "widgets/frames/frames_tab.h"
#include "widgets/project/project_document.h"

namespace tiller {
namespace {

QString movedText(int waypoints) {
    return waypoints == 0 ? FramesTab::tr("No waypoint moved with it.")
                          : FramesTab::tr("%n waypoints moved with it.", nullptr, waypoints);
}

QString outOfReachText(int waypoints) {
    return waypoints == 0 ? QString()
                          : FramesTab::tr("%n of them are out of reach there.", nullptr, waypoints);
}

}  // namespace

QAction* FramesTab::addCommand(const QString& name, const QString& text, const QKeySequence& shortcut,
                               std::function<void()> run) {
    auto* action = new QAction(text, this);
    action->setObjectName(QStringLiteral("frame.action.") + name);
    action->setShortcut(shortcut);
    action->setAutoRepeat(false);
    connect(action, &QAction::triggered, this, [this, run = std::move(run)] {
        Q_EMIT frontWanted();
        run();
    });
    actions_.append(action);
    return action;
}

void FramesTab::buildActions() {
    // Letters: s a frame is selected, l live data, t three points are being taken.
    const auto with = [](QAction* action, const char* needs) {
        action->setProperty("needs", QLatin1String(needs));
        return action;
    };
    auto* menu = new QMenu(this);
    menu->setObjectName(QStringLiteral("frame.menu"));
    const auto everywhere = [&](QAction* action) {
        // The hand is on the jog pad while teaching.
        addAction(action);
        return action;
    };
    const auto here = [&](QAction* action) {
        action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
        addAction(action);
        return action;
    };
    menu->addAction(
        everywhere(with(addCommand("fromTcp", tr("Teach frame from the TCP"),
                                   QKeySequence(Qt::SHIFT | Qt::Key_T), [this] { teachFromTcp(); }),
                        "l")));
    menu->addAction(everywhere(
        with(addCommand("threePoints", tr("Teach frame from three points"),
                        QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_T), [this] { teachThreePoints(); }),
             "l")));
    everywhere(with(addCommand("takePoint", tr("Take the next point of the frame"), QKeySequence(Qt::Key_P),
                               [this] { teacher_->takeNext(); }),
                    "lt"));
    everywhere(with(addCommand("make", tr("Make the frame of the points taken"),
                               QKeySequence(Qt::CTRL | Qt::Key_Return), [this] { teacher_->finish(); }),
                    "t"));
    everywhere(with(addCommand("cancel", tr("Cancel frame teaching"), {}, [this] { endTeaching(); }), "t"));
    menu->addAction(everywhere(with(addCommand("touchUp", tr("Touch up frame from the TCP"),
                                               QKeySequence(Qt::SHIFT | Qt::Key_U), [this] { touchUp(); }),
                                    "sl")));
    menu->addAction(everywhere(with(addCommand("touchUpThreePoints", tr("Touch up frame from three points"),
                                               {}, [this] { touchUpThreePoints(); }),
                                    "sl")));
    menu->addSeparator();
    menu->addAction(everywhere(
        with(addCommand("jogIn", tr("Jog in this frame"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_J),
                        [this] {
                            if (const auto frame = current()) {
                                Q_EMIT jogRequested(frame->id);
                            }
                        }),
             "s")));
    menu->addSeparator();
    menu->addAction(here(with(addCommand("rename", tr("Rename frame"), QKeySequence(Qt::Key_F2),
                                         [this] { table_->renameCurrent(); }),
                              "s")));
    menu->addAction(here(
        with(addCommand("edit", tr("Set frame in figures"), {}, [this] { details_->editFigures(); }), "s")));
    menu->addAction(here(with(addCommand("duplicate", tr("Duplicate frame"),
                                         QKeySequence(Qt::CTRL | Qt::Key_D), [this] { duplicateSelected(); }),
                              "s")));
    menu->addAction(here(with(
        addCommand("delete", tr("Delete frame"), QKeySequence(Qt::Key_Delete), [this] { deleteSelected(); }),
        "s")));
    more_->setMenu(menu);
    table_->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(table_, &QWidget::customContextMenuRequested, this,
            [this, menu](const QPoint& position) { menu->popup(table_->viewport()->mapToGlobal(position)); });
}

// ---- teaching --------------------------------------------------------------------------------------

void FramesTab::teachFromTcp() {
    if (const QString obstacle = teachObstacle(); !obstacle.isEmpty()) {
        showProblem(obstacle);
        return;
    }
    endTeaching();
    insertFrame(state_.tcpPose);
}

void FramesTab::teachThreePoints() {
    beginTeaching({});
}

void FramesTab::touchUp() {
    const std::optional<project::Frame> frame = current();
    const QString obstacle = frame ? teachObstacle() : tr("Select a frame to touch up.");
    if (!obstacle.isEmpty()) {
        showProblem(obstacle);
        return;
    }
    endTeaching();
    askToMove(frame->id, state_.tcpPose);
}

void FramesTab::touchUpThreePoints() {
    if (const std::optional<project::Frame> frame = current()) {
        beginTeaching(frame->id);
    } else {
        showProblem(tr("Select a frame to touch up."));
    }
}

void FramesTab::beginTeaching(const QUuid& into) {
    notice_->dismiss();
    teaching_ = true;
    teachingInto_ = into;
    const std::optional<project::Frame> frame = into.isNull() ? std::nullopt : current();
    teacher_->begin(
        frame ? tr("Touch up “%1” from three points").arg(frame->name) : tr("New frame from three points"),
        frame ? tr("Touch up…") : tr("Make frame"));
    showPage();
    updateAvailability();
}

void FramesTab::endTeaching() {
    if (teaching_) {
        teaching_ = false;
        showPage();
        updateAvailability();
        Q_EMIT marksChanged();
    }
}

void FramesTab::onMade(const Pose& T_base_frame) {
    endTeaching();
    if (teachingInto_.isNull()) {
        insertFrame(T_base_frame);
    } else {
        askToMove(teachingInto_, T_base_frame);
    }
}

void FramesTab::insertFrame(const Pose& T_base_frame) {
    project::Frame frame;
    frame.id = QUuid::createUuid();
    frame.name = model_->frames().nextName(tr("frame"));
    frame.T_base_frame = T_base_frame;
    document_.insertFrame(model_->rowCount(), frame, tr("Teach “%1”").arg(frame.name));
    table_->setFocus();
}

void FramesTab::askToMove(const QUuid& id, const Pose& T_base_frame) {
    const int row = model_->rowOf(id);
    if (row < 0) {
        return;
    }
    const project::Frame frame = model_->frames().at(static_cast<std::size_t>(row));
    const project::PoseDifference by = project::poseDifference(frame.T_base_frame, T_base_frame);
    const FrameUse use = model_->use(id, T_base_frame);
    QStringList lines = {tr("It moves by %1 (%2, base frame).")
                             .arg(format::difference(by.distance, by.angle),
                                  format::shift(T_base_frame.position - frame.T_base_frame.position)),
                         use.waypoints == 0 ? tr("No waypoint is given in it.")
                                            : tr("%n waypoints move with it.", nullptr, use.waypoints)};
    if (use.outOfReach > 0) {
        lines << outOfReachText(use.outOfReach);
    }
    notice_->show(NoticeBar::Kind::Question, tr("Touch up “%1”?").arg(frame.name),
                  lines.join(QLatin1Char(' ')), tr("Touch up"), [this, id, T_base_frame, name = frame.name] {
                      // What was shown is what is kept, even if the arm has moved on since.
                      const QString moved = moveFrame(id, T_base_frame, tr("Touch up “%1”").arg(name));
                      const QString done = tr("“%1” is touched up").arg(name);
                      notice_->show(NoticeBar::Kind::Question, done, moved);
                      Q_EMIT message(Severity::Info, done + QStringLiteral(". ") + moved);
                  });
}

QString FramesTab::moveFrame(const QUuid& id, const Pose& T_base_frame, const QString& step) {
    const int row = model_->rowOf(id);
    if (row < 0) {
        return {};
    }
    project::Frame frame = model_->frames().at(static_cast<std::size_t>(row));
    frame.T_base_frame = T_base_frame;
    document_.changeFrame(row, frame, step);
    const FrameUse use = model_->use(frame);
    QString text = movedText(use.waypoints);
    if (use.outOfReach > 0) {
        text += QLatin1Char(' ') + outOfReachText(use.outOfReach);
    }
    return text;
}

// ---- editing ---------------------------------------------------------------------------------------

void FramesTab::duplicateSelected() {
    std::optional<project::Frame> frame = current();
    if (!frame) {
        return;
    }
    const QString text = tr("Duplicate “%1”").arg(frame->name);
    frame->id = QUuid::createUuid();
    frame->name = model_->frames().uniqueName(frame->name);
    document_.insertFrame(currentRow() + 1, *frame, text);
}

void FramesTab::deleteSelected() {
    const std::optional<project::Frame> frame = current();
    if (!frame) {
        return;
    }
    const int waypoints = model_->use(*frame).waypoints;
    if (waypoints == 0) {
        document_.removeFrame(currentRow());
        return;
    }
    notice_->show(
        NoticeBar::Kind::Question, tr("Delete “%1”?").arg(frame->name),
        tr("%n waypoints are given in it. They stay where they are, given in Base.", nullptr, waypoints),
        tr("Delete frame"), [this, id = frame->id] {
            if (const int row = model_->rowOf(id); row >= 0) {
                document_.removeFrame(row);
            }
        });
}

}  // namespace tiller
