// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/frames/frames_tab.h"

#include <QAction>
#include <QEvent>
#include <QHBoxLayout>
#include <QItemSelectionModel>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QStackedWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "robot/station/document/project_document.h"
#include "robot/station/link/obstacles.h"
#include "widgets/common/bottom_overlay.h"
#include "widgets/common/notice_bar.h"
#include "widgets/frames/frame_details.h"
#include "widgets/frames/frame_editing.h"
#include "widgets/frames/frame_model.h"
#include "widgets/frames/frame_table.h"
#include "widgets/frames/frame_teacher.h"

namespace tiller {
namespace {

enum Page { kEmptyPage, kTablePage };

}  // namespace

FramesTab::FramesTab(RobotSession& session, ProjectDocument& document, QWidget* parent)
    : QWidget(parent), state_(session.state()), document_(document), model_(new FrameModel(document, this)) {
    setObjectName(QStringLiteral("frames"));
    setAccessibleName(tr("Frames"));
    buildLayout();
    editing_ = new FrameEditing(document_, *model_, *notice_, session.journal(), this);
    buildActions();

    // Limit the update rate, because values that change 60 times per second are not legible.
    liveTimer_.setSingleShot(true);
    liveTimer_.setInterval(100);
    connect(&liveTimer_, &QTimer::timeout, this, &FramesTab::showLive);
    connect(&session, &RobotSession::stateChanged, this, &FramesTab::onState);
    connect(table_, &FrameTable::currentRowChanged, this, &FramesTab::onSelection);
    connect(model_, &FrameModel::editRefused, this, &FramesTab::showProblem);
    connect(&document_, &ProjectDocument::framesChanged, this, &FramesTab::onFrames);
    // The number of waypoints that move with the selected frame may have changed.
    connect(&document_, &ProjectDocument::documentChanged, this, &FramesTab::onSelection);
    onFrames();
    showLive();
}

FramesTab::~FramesTab() {
    // The base class destroys the table after the model, and possibly after the document. Disconnect the
    // table, because the slots use both.
    disconnect(table_, nullptr, this, nullptr);
}

void FramesTab::buildLayout() {
    const auto key = [](const QString& text, const char* name) {
        auto* made = new QPushButton(text);
        made->setObjectName(QLatin1String(name));
        return made;
    };
    fromTcp_ = key(tr("From TCP"), "frame.fromTcp");
    fromTcp_->setAccessibleName(tr("Teach a frame from the TCP"));
    fromTcp_->setProperty("primary", true);
    threePoints_ = key(tr("3 points"), "frame.threePoints");
    threePoints_->setAccessibleName(tr("Teach a frame from three points"));
    touchUp_ = key(tr("Touch up"), "frame.touchUp");
    touchUp_->setAccessibleName(tr("Touch up the frame"));
    more_ = new QPushButton;
    more_->setObjectName(QStringLiteral("frame.more"));
    more_->setAccessibleName(tr("More frame commands"));
    more_->setText(QStringLiteral("···"));
    keys_ = new QWidget;
    auto* row = new QHBoxLayout(keys_);
    row->setContentsMargins(12, 12, 12, 8);
    row->setSpacing(8);
    row->addWidget(fromTcp_, 3);
    row->addWidget(threePoints_, 3);
    row->addWidget(touchUp_, 3);
    row->addWidget(more_);

    auto* empty =
        new QLabel(tr("No frames yet.\nJog the tip to a corner of the tray or table. Press “From TCP”, or "
                      "press “3 points” to record the origin, +X and +Y."));
    empty->setObjectName(QStringLiteral("frame.empty"));
    empty->setProperty("role", "secondary");
    empty->setAlignment(Qt::AlignCenter);
    empty->setWordWrap(true);
    empty->setMargin(12);
    table_ = new FrameTable(*model_);
    teacher_ = new FrameTeacher;
    pages_ = new QStackedWidget;
    pages_->addWidget(empty);
    pages_->addWidget(table_);
    details_ = new FrameDetails;

    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(keys_);
    layout->addWidget(pages_, 1);
    layout->addWidget(teacher_, 1);
    layout->addWidget(details_);
    notice_ = new NoticeBar;
    new BottomOverlay(*notice_, *this, {pages_, teacher_});
    connect(&document_, &ProjectDocument::documentChanged, notice_, &NoticeBar::dismissQuestion);

    connect(fromTcp_, &QPushButton::clicked, this, &FramesTab::teachFromTcp);
    connect(threePoints_, &QPushButton::clicked, this, &FramesTab::teachThreePoints);
    connect(touchUp_, &QPushButton::clicked, this, &FramesTab::touchUp);
    connect(teacher_, &FrameTeacher::made, this, &FramesTab::onMade);
    connect(teacher_, &FrameTeacher::cancelled, this, &FramesTab::endTeaching);
    connect(teacher_, &FrameTeacher::tipWanted, this, &FramesTab::showLive);
    connect(teacher_, &FrameTeacher::previewChanged, this, &FramesTab::marksChanged);
    connect(details_, &FrameDetails::placeEntered, this, [this](const Pose& pose) {
        if (const auto frame = current()) {
            editing_->place(*frame, pose);
        }
    });
}

void FramesTab::onState(const SessionState& state) {
    const bool sameLink = state.link == state_.link;
    state_ = state;
    if (!sameLink) {
        showLive();
    } else if (!liveTimer_.isActive()) {
        liveTimer_.start();
    }
}

void FramesTab::showLive() {
    const QString obstacle = dataObstacle(state_);
    const std::optional<Pose> tcp = state_.hasData() ? std::optional(state_.tcpPose) : std::nullopt;
    model_->setTcp(tcp);
    details_->setTcp(tcp);
    notice_->refresh();
    teacher_->setTip(obstacle.isEmpty() ? std::optional(state_.tcpPose.position) : std::nullopt, obstacle);
    updateAvailability();
}

void FramesTab::onFrames() {
    QVector<QUuid> ids;
    QUuid came;
    for (const project::Frame& frame : document_.frames()) {
        ids.append(frame.id);
        came = known_.contains(frame.id) ? came : frame.id;
    }
    const bool one = ids.size() == known_.size() + 1;
    const int before = static_cast<int>(known_.indexOf(selected_));
    known_ = ids;
    if (teaching_ && !teachingInto_.isNull() && !ids.contains(teachingInto_)) {
        endTeaching();
    }
    showPage();
    // Select the added frame (also after undo). Otherwise, keep the selected frame or select its neighbour.
    const int row = one                       ? model_->rowOf(came)
                    : ids.contains(selected_) ? model_->rowOf(selected_)
                                              : std::min(std::max(before, 0), model_->rowCount() - 1);
    selectRow(row);
    Q_EMIT marksChanged();
}

void FramesTab::showPage() {
    const bool any = model_->rowCount() > 0;
    pages_->setCurrentIndex(any ? kTablePage : kEmptyPage);
    // Hide unused content, because the tab has little height in a small window.
    pages_->setVisible(!teaching_);
    teacher_->setVisible(teaching_);
    details_->setVisible(!teaching_ && any);
    keys_->setVisible(!teaching_);
}

void FramesTab::onSelection() {
    const std::optional<project::Frame> frame = current();
    const QUuid id = frame ? frame->id : QUuid();
    details_->setFrame(frame, frame ? model_->use(*frame).waypoints : 0);
    updateAvailability();
    if (id != selected_) {
        selected_ = id;
        notice_->dismiss();
        Q_EMIT marksChanged();
    }
}

int FramesTab::currentRow() const {
    const QModelIndex current = table_->currentIndex();
    return current.isValid() && current.row() < model_->rowCount() ? current.row() : -1;
}

std::optional<project::Frame> FramesTab::current() const {
    const int row = currentRow();
    return row < 0 ? std::nullopt : std::optional(model_->frames().at(static_cast<std::size_t>(row)));
}

void FramesTab::selectRow(int row) {
    if (row < 0 || row >= model_->rowCount()) {
        table_->selectionModel()->clear();
    } else {
        // Use the selection model, because the view would extend the selection according to the modifiers of
        // the shortcut.
        const QModelIndex index = model_->index(row, FrameModel::Name);
        table_->selectionModel()->setCurrentIndex(
            index, QItemSelectionModel::ClearAndSelect | QItemSelectionModel::Rows);
        table_->scrollTo(index);
    }
    onSelection();
}

std::vector<FrameMark> FramesTab::marks() const {
    std::vector<FrameMark> result;
    for (const project::Frame& frame : model_->frames()) {
        result.push_back({frame.name, frame.T_base_frame, !teaching_ && frame.id == selected_});
    }
    if (const std::optional<Pose> preview = teaching_ ? teacher_->preview() : std::nullopt) {
        result.push_back({tr("new frame"), *preview, true});
    }
    return result;
}

void FramesTab::updateAvailability() {
    const QString obstacle = dataObstacle(state_);
    const bool live = obstacle.isEmpty();
    const bool selected = currentRow() >= 0;
    fromTcp_->setEnabled(live);
    fromTcp_->setToolTip(live ? tr("Create a frame at the TCP with the axes of the tool (Shift+T)")
                              : obstacle);
    threePoints_->setEnabled(live);
    threePoints_->setToolTip(
        live ? tr("Create a frame from its origin, a point on +X and a point towards +Y (Ctrl+Shift+T)")
             : obstacle);
    touchUp_->setEnabled(live && selected);
    touchUp_->setToolTip(!live      ? obstacle
                         : selected ? tr("Move the selected frame to the TCP (Shift+U)")
                                    : tr("Select a frame to touch up."));
    for (QAction* action : actions_) {
        const QString needs = action->property("needs").toString();
        action->setEnabled((!needs.contains(u's') || selected) && (!needs.contains(u'l') || live) &&
                           (!needs.contains(u't') || teaching_));
    }
}

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
    // Requirements of an action as letters: s = frame selected, l = live data, t = teaching from three
    // points.
    const auto with = [](QAction* action, const char* needs) {
        action->setProperty("needs", QLatin1String(needs));
        return action;
    };
    auto* menu = new QMenu(this);
    menu->setObjectName(QStringLiteral("frame.menu"));
    const auto everywhere = [&](QAction* action) {
        // Add the action to the whole tab, because the focus may be on the jog pad during teaching.
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
    everywhere(with(addCommand("takePoint", tr("Record the next point of the frame"), QKeySequence(Qt::Key_P),
                               [this] { teacher_->takeNext(); }),
                    "lt"));
    everywhere(with(addCommand("make", tr("Create frame from points"),
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
    menu->addAction(
        here(with(addCommand("edit", tr("Edit frame values"), {}, [this] { details_->editValues(); }), "s")));
    menu->addAction(
        here(with(addCommand("duplicate", tr("Duplicate frame"), QKeySequence(Qt::CTRL | Qt::Key_D),
                             [this] { withCurrent(&FrameEditing::duplicate); }),
                  "s")));
    menu->addAction(here(with(addCommand("delete", tr("Delete frame"), QKeySequence(Qt::Key_Delete),
                                         [this] { withCurrent(&FrameEditing::remove); }),
                              "s")));
    more_->setMenu(menu);
    table_->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(table_, &QWidget::customContextMenuRequested, this,
            [this, menu](const QPoint& position) { menu->popup(table_->viewport()->mapToGlobal(position)); });
}

// ---- teaching --------------------------------------------------------------------------------------

void FramesTab::teachFromTcp() {
    if (const QString obstacle = dataObstacle(state_); !obstacle.isEmpty()) {
        showProblem(obstacle);
        return;
    }
    endTeaching();
    insert(state_.tcpPose);
}

void FramesTab::teachThreePoints() {
    beginTeaching({});
}

void FramesTab::touchUp() {
    const std::optional<project::Frame> frame = current();
    const QString obstacle = frame ? storeObstacle(state_) : tr("Select a frame to touch up.");
    if (!obstacle.isEmpty()) {
        showProblem(obstacle);
        return;
    }
    endTeaching();
    editing_->askToMove(frame->id, [this] {
        return FrameEditing::NewPose{state_.tcpPose, storeObstacle(state_)};
    });
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
        frame ? tr("Touch up…") : tr("Create frame"));
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
        insert(T_base_frame);
    } else {
        editing_->askToMove(teachingInto_, [T_base_frame] { return FrameEditing::NewPose{T_base_frame}; });
    }
}

void FramesTab::insert(const Pose& T_base_frame) {
    editing_->insert(T_base_frame);
    table_->setFocus();
}

void FramesTab::withCurrent(void (FrameEditing::*edit)(const project::Frame&)) {
    if (const std::optional<project::Frame> frame = current()) {
        (editing_->*edit)(*frame);
    }
}

void FramesTab::showProblem(const QString& text) {
    notice_->show(NoticeBar::Kind::Warning, text, {});
}

}  // namespace tiller

#include "moc_frames_tab.cpp"
