// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/waypoints/waypoints_tab.h"

#include <QAction>
#include <QApplication>
#include <QEvent>
#include <QHBoxLayout>
#include <QItemSelectionModel>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QStackedWidget>
#include <QVBoxLayout>

#include "robot/kinematics/arm_kinematics.h"
#include "robot/station/link/obstacles.h"
#include "robot/station/program/step_uses.h"
#include "robot/station/route/path_watch.h"
#include "robot/station/route/waypoint_motion.h"
#include "robot/station/text/format.h"
#include "robot/station/text/joint_name.h"
#include "robot/station/text/notation.h"
#include "robot/station/text/reach_words.h"
#include "widgets/common/bottom_overlay.h"
#include "widgets/common/notice_bar.h"
#include "widgets/common/single_click.h"
#include "widgets/project/undoable_document.h"
#include "widgets/waypoints/folding_row.h"
#include "widgets/waypoints/go_through_bar.h"
#include "widgets/waypoints/go_to_button.h"
#include "widgets/waypoints/path_controls.h"
#include "widgets/waypoints/waypoint_details.h"
#include "widgets/waypoints/waypoint_dialogs.h"
#include "widgets/waypoints/waypoint_editing.h"
#include "widgets/waypoints/waypoint_model.h"
#include "widgets/waypoints/waypoint_search.h"
#include "widgets/waypoints/waypoint_table.h"

namespace tiller {
namespace {

/// Cause of the notices that close automatically.
constexpr char kPassing[] = "waypoint.passing";

}  // namespace

WaypointsTab::WaypointsTab(RobotSession& session, UndoableDocument& document, HoldPolicy& policy,
                           QWidget* parent)
    : WaypointsTab(session, document, motionPort(session), policy, parent) {}

WaypointsTab::WaypointsTab(RobotSession& session, UndoableDocument& document, MotionPort port,
                           HoldPolicy& policy, QWidget* parent)
    : QWidget(parent)
    , session_(session)
    , holdPolicy_(policy)
    , limits_(port.limits)
    , state_(session.state())
    , document_(document)
    , model_(std::make_unique<WaypointModel>(document)) {
    setObjectName(QStringLiteral("waypoints"));
    setAccessibleName(tr("Waypoints"));
    watch_ = new PathWatch(
        document_,
        [this, permits = port.permits](int row) -> Result<void> {
            const Result<MoveRequest> move = moveTo(row);
            return permits && move ? permits({&*move, 1}) : Result<void>();
        },
        this);
    connect(watch_, &PathWatch::looked, model_.get(), &WaypointModel::setPathLimit);
    buildLayout(std::move(port), policy);
    buildActions();

    // Limit the update rate, because values that change 60 times per second are not legible.
    detailsTimer_.setSingleShot(true);
    detailsTimer_.setInterval(100);
    connect(&detailsTimer_, &QTimer::timeout, this, [this] {
        details_->setLive(state_);
        showSpeed();
        goThrough_->showSpeed();
        notice_->refresh();
        if (touchUpGhost_ && touchUpGhost_->q != state_.q) {
            touchUpGhost_->q = state_.q;
            Q_EMIT ghostChanged();
        }
    });

    connect(&session_, &RobotSession::stateChanged, this, &WaypointsTab::onState);
    connect(table_, &WaypointTable::currentRowChanged, this, &WaypointsTab::onSelection);
    connect(&document_, &ProjectDocument::waypointsAppeared, this,
            [this](int first, int) { selectRow(first); });
    connect(&document_, &ProjectDocument::projectReplaced, this,
            [this] { selectRow(model_->rowCount() > 0 ? 0 : -1); });
    connect(&document_, &ProjectDocument::stepTaken, this, [this](const ProjectStep& step) {
        if (step.part == ProjectPart::Waypoints && !step.id.isNull()) {
            selectWaypoint(step.id);
        }
    });
    connect(model_.get(), &WaypointModel::editRefused, this,
            [this](const QString& reason) { showProblem(reason); });
    connect(&document_, &ProjectDocument::documentChanged, this, [this] {
        pages_->setCurrentIndex(model_->rowCount() == 0 ? 0 : 1);
        goTo_->stop(control::StopCause::SelectionChanged);
        goThrough_->followDocument(currentRow(), table_->selectedRows());
        onSelection();
        updateAvailability();
        Q_EMIT marksChanged();
        Q_EMIT ghostChanged();
    });
    onState(state_);
    onSelection();
}

WaypointsTab::~WaypointsTab() {
    goTo_->stop(control::StopCause::WindowClosed);
    goThrough_->stop(control::StopCause::WindowClosed);
}

void WaypointsTab::buildLayout(MotionPort port, HoldPolicy& policy) {
    teach_ = new QPushButton(tr("Teach here  T"));
    teach_->setObjectName(QStringLiteral("waypoint.teach"));
    teach_->setAccessibleName(tr("Teach here"));
    new SingleClick(*teach_);  // a double click would teach the same position twice
    teach_->setProperty("primary", true);
    touchUp_ = new QPushButton(tr("Touch up  U"));
    touchUp_->setObjectName(QStringLiteral("waypoint.touchUp"));
    touchUp_->setAccessibleName(tr("Touch up"));
    const ActionPort actions{
        [this](std::uint32_t mask, std::uint32_t values, const QString& what, const OutputOrder& order) {
            session_.outputs().setDigitalOutputs(mask, values, what, order);
        }};
    goThrough_ = new GoThroughBar(port, policy, actions, document_, heldSpeed_);
    paths_ = new PathControls(session_, document_,
                              {[this] { return currentRow(); }, [this] { return table_->selectedRows(); }});
    goTo_ = new GoToButton(std::move(port), policy, [this] { return goToRequest(); });
    goTo_->setState(state_);
    more_ = new QPushButton;
    more_->setObjectName(QStringLiteral("waypoint.more"));
    more_->setAccessibleName(tr("More"));
    more_->setText(QStringLiteral("···"));

    auto* keys = new QHBoxLayout;
    keys->setContentsMargins(12, 12, 12, 8);
    keys->setSpacing(8);
    keys->addWidget(teach_, 3);
    keys->addWidget(touchUp_, 2);
    keys->addWidget(goTo_, 3);
    keys->addWidget(more_);

    auto* empty = new QLabel(tr("No waypoints yet.\nJog the arm to a position and press “Teach here” (T)."));
    empty->setObjectName(QStringLiteral("waypoint.empty"));
    empty->setProperty("role", "secondary");
    empty->setAlignment(Qt::AlignCenter);
    empty->setWordWrap(true);
    table_ = new WaypointTable(*model_);
    pages_ = new QStackedWidget;
    pages_->addWidget(empty);
    pages_->addWidget(table_);
    constexpr int kMinTable = 104;  // [px] header and two rows
    pages_->setMinimumHeight(kMinTable);
    details_ = new WaypointDetails(document_, *model_);

    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addLayout(keys);
    routes_ = new FoldingRow;
    auto* routes = new QHBoxLayout(routes_);
    routes->setContentsMargins(0, 0, 0, 0);
    routes->setSpacing(0);
    routes->addWidget(goThrough_, 1);
    routes->addWidget(paths_);
    layout->addWidget(routes_);
    layout->addWidget(pages_, 1);
    layout->addWidget(details_);
    notice_ = new NoticeBar;
    notice_->installEventFilter(this);
    new BottomOverlay(*notice_, *this, {pages_});

    connect(&document_, &ProjectDocument::documentChanged, notice_, &NoticeBar::dismissQuestion);

    connect(teach_, &QPushButton::clicked, this, &WaypointsTab::teach);
    connect(touchUp_, &QPushButton::clicked, this, &WaypointsTab::touchUp);
    // A reason that disappears automatically is also in the log, so its notice need not be closed by hand.
    passing_.setSingleShot(true);
    passing_.setInterval(kPassingMs);
    connect(&passing_, &QTimer::timeout, this, [this, &policy] {
        if (policy.holding != nullptr || QApplication::mouseButtons() != Qt::NoButton) {
            passing_.start();
        } else {
            notice_->resolve(QLatin1String(kPassing));
        }
    });
    const auto refuse = [this](const QString& reason, bool passing) {
        setTouchUpGhost(std::nullopt);
        notice_->show(NoticeBar::Kind::Warning,
                      {.title = reason, .text = {}, .cause = passing ? QLatin1String(kPassing) : QString()});
        if (passing) {
            passing_.start();
        }
        session_.journal().add(Severity::Warning, reason);
    };
    connect(goTo_, &GoToButton::refused, this, refuse);
    connect(goThrough_, &GoThroughBar::refused, this, refuse);
    connect(paths_, &PathControls::refused, this, &WaypointsTab::showProblem);
    connect(paths_, &PathControls::kept, this, [this](const QString& summary) {
        setTouchUpGhost(std::nullopt);
        notice_->show(NoticeBar::Kind::Question, tr("Path recorded"), summary);
        session_.journal().add(Severity::Info, summary);
    });
    connect(&paths_->recorder(), &PathRecorder::changed, this, [this] {
        showPathRecording();
        if (!paths_->recorder().isRecording() && !paths_->recorder().isBusy()) {
            Q_EMIT pathStored();
        }
    });
    connect(paths_, &PathControls::reported, this,
            [this](const QString& summary) { session_.journal().add(Severity::Info, summary); });
    connect(details_, &WaypointDetails::placeWanted, this, &WaypointsTab::fitRoutes);
    connect(goThrough_, &GoThroughBar::comingChanged, this, &WaypointsTab::onComing);
    connect(table_->selectionModel(), &QItemSelectionModel::selectionChanged, this,
            [this] { goThrough_->setSelection(currentRow(), table_->selectedRows()); });
    connect(
        &goTo_->guard(), &HoldGuard::ended, this,
        [this] {
            if (goTo_->hasFocus()) {
                table_->setFocus();
            }
        },
        Qt::QueuedConnection);
    editing_ = new WaypointEditing(document_, *table_, this);
    connect(editing_, &WaypointEditing::refused, this, &WaypointsTab::showProblem);
    connect(editing_, &WaypointEditing::rowWanted, this, &WaypointsTab::selectRow);
    dialogs_ = new WaypointDialogs(document_, *table_, this);
    connect(dialogs_, &WaypointDialogs::refused, this, &WaypointsTab::showProblem);
    connect(dialogs_, &WaypointDialogs::done, this,
            [this](const QString& text) { session_.journal().add(Severity::Info, text); });
    search_ = new WaypointSearch(document_, *table_);
    new BottomOverlay(*search_, *this, {pages_});
    connect(search_, &WaypointSearch::rowWanted, this, &WaypointsTab::selectRow);
}

void WaypointsTab::onState(const SessionState& state) {
    state_ = state;
    const RobotModel before = document_.robot();
    if (state.hasData()) {
        document_.setRobot(state.arm());
    } else if (state.link == LinkState::Disconnected) {
        document_.clearRobot();
    }
    if (document_.robot().id != before.id || document_.robot().dh != before.dh) {
        Q_EMIT ghostChanged();
    }
    if (!detailsTimer_.isActive()) {
        detailsTimer_.start();
    }
    if (state.hasData()) {
        editing_->setLive(state.q, state.tcpOffset);
        dialogs_->setLive(state.q, state.tcpOffset);
    }
    goTo_->setState(state);
    goThrough_->setState(state);
    paths_->setState(state);
    watch_->setState(state);
    updateAvailability();
}

void WaypointsTab::onComing() {
    const int row = goThrough_->comingRow();
    model_->setComing(row < 0 ? QUuid() : document_.waypoints().at(row).id);
    if (row >= 0 && goThrough_->isHolding()) {
        table_->scrollTo(model_->index(row, WaypointModel::Name));
    }
    Q_EMIT ghostChanged();
    Q_EMIT marksChanged();
}

void WaypointsTab::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    fitRoutes();
}

/// Marks the menu button, because in a narrow panel "Stop recording path" is available only in its menu.
void WaypointsTab::showPathRecording() {
    const QString usual = QStringLiteral("···");
    const QString marked = QStringLiteral("● ···");
    const QString recording = paths_->recordingText();
    more_->setText(marked);
    more_->setMinimumWidth(more_->sizeHint().width());
    more_->setText(recording.isEmpty() ? usual : marked);
    more_->setToolTip(recording);
    more_->setAccessibleDescription(recording);
}

void WaypointsTab::fitRoutes() {
    details_->setValuesSlot(0);
    routes_->setMinimumHeight(0);
    // In a narrow panel, "Record path" is available only in the menu.
    paths_->setVisible(true);
    paths_->setVisible(routes_->sizeHint().width() <= width());
    const int spare = height() - minimumSizeHint().height();
    const bool both = routes_->sizeHint().height() <= spare;
    const bool instead = !both && details_->isPlaceWanted();
    details_->offerPlace(!both);
    details_->setValuesVisible(!instead);
    // Insert the route controls below the headline, where the values were, so that the pressed button keeps
    // its position.
    auto* column = static_cast<QVBoxLayout*>(layout());
    const bool below = column->indexOf(routes_) > column->indexOf(details_);
    if (instead != below) {
        column->removeWidget(routes_);
        column->insertWidget(instead ? column->indexOf(details_) + 1 : column->indexOf(pages_), routes_);
    }
    const int available = spare + details_->valuesHeight();
    const int wanted = routes_->sizeHint().height();
    routes_->fitInto({width(), instead ? available : spare});
    if (!both) {
        // Values and route controls have the same height, so that swapping them does not move the headline.
        const int slot = std::max(details_->valuesHeight(), std::min(wanted, available));
        details_->setValuesSlot(slot);
        routes_->setMinimumHeight(instead ? slot : 0);
    }
}

QSize WaypointsTab::minimumSizeHint() const {
    QSize least = QWidget::minimumSizeHint();
    // Include the reserved height while the route controls replace the values, so that the panel keeps its
    // size.
    const bool slotIsKept = details_->areValuesVisible() || routes_->minimumHeight() > 0;
    least.rheight() += slotIsKept ? 0 : details_->valuesHeight();
    if (details_->isHidden()) {
        // Reserve space for the details, which appear with the first waypoint. They must not move the buttons
        // of a panel with little height.
        least.rheight() += details_->minimumSizeHint().height() + layout()->spacing();
    }
    return least;
}

bool WaypointsTab::eventFilter(QObject* watched, QEvent* event) {
    // The user has answered the touch-up question.
    if (watched == notice_ && event->type() == QEvent::Hide) {
        setTouchUpGhost(std::nullopt);
        // Move the focus. Otherwise, the next widget of the window would get it, such as a button that
        // records.
        if (notice_->isHidden() && notice_->isAncestorOf(QApplication::focusWidget())) {
            (table_->isVisible() ? static_cast<QWidget*>(table_) : this)->setFocus(Qt::OtherFocusReason);
        }
    }
    return QWidget::eventFilter(watched, event);
}

void WaypointsTab::setTouchUpGhost(const std::optional<Ghost>& ghost) {
    if (ghost || touchUpGhost_) {
        touchUpGhost_ = ghost;
        Q_EMIT ghostChanged();
    }
}

void WaypointsTab::onSelection() {
    const int row = currentRow();
    const QUuid id = row < 0 ? QUuid() : document_.waypoints().at(row).id;
    details_->setWaypoint(row);
    const int uses = row < 0 ? 0 : program::countUses(document_.project(), document_.waypoints().at(row));
    details_->setUsedIn(uses > 0 ? std::optional(uses) : std::nullopt);
    details_->setVisible(model_->rowCount() > 0);
    if (id == lastSelected_) {
        return;
    }
    lastSelected_ = id;
    goTo_->stop(control::StopCause::SelectionChanged);
    goThrough_->setSelection(row, table_->selectedRows());
    notice_->dismissWithoutCause();
    updateAvailability();
    showSpeed();
    Q_EMIT selectionChanged(id);
    Q_EMIT ghostChanged();
    Q_EMIT marksChanged();
}

int WaypointsTab::currentRow() const {
    const QModelIndex current = table_->currentIndex();
    return current.isValid() && current.row() < model_->rowCount() ? current.row() : -1;
}

bool WaypointsTab::isStoringPath() const {
    return paths_->recorder().isRecording() || paths_->recorder().isBusy();
}

bool WaypointsTab::storePath() {
    PathRecorder& recorder = paths_->recorder();
    recorder.stop(currentRow());
    return recorder.isBusy();
}

void WaypointsTab::selectWaypoint(const QUuid& id) {
    selectRow(document_.waypoints().indexOf(id));
}

void WaypointsTab::selectRow(int row) {
    if (row < 0 || row >= model_->rowCount()) {
        table_->selectionModel()->clear();
    } else {
        // Use the selection model, because the view would extend the selection according to the modifiers of
        // the shortcut.
        const QModelIndex index = model_->index(row, WaypointModel::Name);
        table_->selectionModel()->setCurrentIndex(
            index, QItemSelectionModel::ClearAndSelect | QItemSelectionModel::Rows);
        table_->scrollTo(index);
    }
    onSelection();
}

std::optional<Ghost> WaypointsTab::ghost() const {
    // Show the next waypoint while the arm runs the route.
    const int row =
        goThrough_->isHolding() && goThrough_->comingRow() >= 0 ? goThrough_->comingRow() : currentRow();
    if (row < 0) {
        return std::nullopt;
    }
    const project::Waypoint& point = document_.waypoints().at(row);
    const project::Reach& reach = document_.reach(row);
    const Result<MoveRequest> move =
        reach.ok() && state_.hasData() ? moveTo(row) : Error{ErrorCode::NoSolution, {}, {}};
    return Ghost{point.name,
                 reach.ok() ? reach.q : point.joints,
                 point.move == project::MoveKind::Linear,
                 reach.ok(),
                 move ? move->speed : point.speed(),
                 point.acceleration(),
                 reach.obstacle == project::Reach::Obstacle::OtherModel};
}

std::vector<WaypointMark> WaypointsTab::marks() const {
    std::vector<WaypointMark> result;
    for (int row = 0; row < model_->rowCount(); ++row) {
        const project::Waypoint& point = document_.waypoints().at(row);
        std::optional<Pose> pose = project::poseInBase(point, document_.frames());
        if (point.priority == project::TargetKind::Joints) {
            pose = kinematics::forwardTcp(document_.robot().dh, point.joints, point.tcpOffset);
        }
        if (pose) {
            const bool coming = row == goThrough_->comingRow();
            result.push_back({coming ? QStringLiteral("▶ ") + point.name : point.name, pose->position,
                              coming || row == currentRow()});
        }
    }
    return result;
}

// ---- availability ----------------------------------------------------------------------------------

QString WaypointsTab::teachObstacle() const {
    const QString obstacle = dataObstacle(state_);
    // Positions taught with different arm models could not be distinguished in one project.
    return obstacle.isEmpty() && document_.isOfOtherModel()
               ? reachAdvice({project::Reach::Obstacle::OtherModel, {}})
               : obstacle;
}

QString WaypointsTab::positionObstacle() const {
    const QString obstacle = teachObstacle();
    return obstacle.isEmpty() ? storeObstacle(state_) : obstacle;
}

QString WaypointsTab::goToObstacle() const {
    if (currentRow() < 0) {
        return tr("Select a waypoint to go to.");
    }
    if (!document_.reach(currentRow()).ok()) {
        return reachAdvice(document_.reach(currentRow()));
    }
    if (!state_.canMove()) {
        return state_.controlReason.isEmpty() ? tr("Tiller is not in control. Take control first.")
                                              : state_.controlReason;
    }
    return {};
}

void WaypointsTab::updateAvailability() {
    const QString teachReason = teachObstacle();
    const bool selected = currentRow() >= 0;
    teach_->setEnabled(teachReason.isEmpty());
    teach_->setToolTip(teachReason.isEmpty() ? tr("Add the current position after the selection (T)")
                                             : teachReason);
    touchUp_->setEnabled(teachReason.isEmpty() && selected);
    touchUp_->setToolTip(!teachReason.isEmpty() ? teachReason
                         : selected ? tr("Replace the selected waypoint with the current position (U)")
                                    : tr("Select a waypoint to touch up."));
    goTo_->setUnavailable(goToObstacle());
    for (QAction* action : actions_) {
        if (action->property("needsSelection").toBool()) {
            action->setEnabled(selected);
        }
    }
}

Result<MoveRequest> WaypointsTab::goToRequest() {
    if (const QString obstacle = goToObstacle(); !obstacle.isEmpty()) {
        return Error{ErrorCode::NoSolution, obstacle, {}};
    }
    notice_->dismissWithoutCause();
    return moveTo(currentRow());
}

Result<MoveRequest> WaypointsTab::moveTo(int row) const {
    Result<MoveRequest> move = moveRequestFor(document_.robot(), document_.waypoints().at(row),
                                              document_.frames(), state_.q, state_.tcpOffset, limits_());
    return move ? slowedTo(heldSpeed_(), *move, state_) : move;
}

void WaypointsTab::setPathLimitText(const QString& text) {
    details_->setPathLimitText(text);
}

void WaypointsTab::setHeldSpeed(std::function<HeldSpeed()> speed) {
    heldSpeed_ = std::move(speed);
    showSpeed();
}

void WaypointsTab::setGripper(GripperPort gripper) {
    goThrough_->setGripper(std::move(gripper));
}

void WaypointsTab::followSpeed() {
    goThrough_->stop(control::StopCause::SelectionChanged);  // otherwise, the motion would change its speed
    showSpeed();
    goThrough_->showSpeed();
    Q_EMIT ghostChanged();
}

void WaypointsTab::showSpeed() {
    if (goTo_->isHolding()) {
        return;  // the speed of the current motion does not change
    }
    const Result<MoveRequest> move =
        currentRow() >= 0 && state_.hasData() && document_.reach(currentRow()).ok()
            ? moveTo(currentRow())
            : Error{ErrorCode::NoSolution, {}, {}};
    goTo_->setDetail(move ? moveSpeedText(*move, state_) : QString());
}

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
                                [this] { teachByKey(); });
    QAction* touchUp = onSelected(addCommand("waypoint.action.touchUp", tr("Touch up"),
                                             QKeySequence(Qt::Key_U), [this] { this->touchUp(); }));
    // Add the actions to the whole window, because the focus may be on the jog pad during teaching.
    addAction(teach);
    addAction(touchUp);

    auto* menu = new QMenu(this);
    menu->setObjectName(QStringLiteral("waypoint.menu"));
    const auto addTo = [this](QMenu* to, QAction* action) {
        action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
        to->addAction(action);
        addAction(action);
    };
    const auto add = [&](QAction* action) { addTo(menu, action); };
    add(onSelected(addCommand("waypoint.action.rename", tr("Rename"), QKeySequence(Qt::Key_F2),
                              [this] { table_->renameCurrent(); })));
    add(onSelected(addCommand("waypoint.action.duplicate", tr("Duplicate"),
                              QKeySequence(Qt::CTRL | Qt::Key_D), [this] { editing_->duplicate(); })));
    // Del applies only to the list with the focus, and not to a question or a field of the tab.
    QAction* remove = onSelected(addCommand("waypoint.action.delete", tr("Delete"),
                                            QKeySequence(Qt::Key_Delete), [this] { editing_->remove(); }));
    remove->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    menu->addAction(remove);
    table_->addAction(remove);
    add(onSelected(addCommand("waypoint.action.up", tr("Move up"), QKeySequence(Qt::ALT | Qt::Key_Up),
                              [this] { editing_->move(-1); })));
    add(onSelected(addCommand("waypoint.action.down", tr("Move down"), QKeySequence(Qt::ALT | Qt::Key_Down),
                              [this] { editing_->move(1); })));
    menu->addSeparator();
    add(onSelected(addCommand("waypoint.action.copy", tr("Copy as table"), QKeySequence(QKeySequence::Copy),
                              [this] { editing_->copy(); })));
    add(addCommand("waypoint.action.paste", tr("Paste"), QKeySequence(QKeySequence::Paste),
                   [this] { editing_->paste(); }));
    menu->addSeparator();
    add(addCommand("waypoint.action.find", tr("Find waypoints"), QKeySequence(QKeySequence::Find),
                   [this] { search_->open(); }));
    add(onSelected(addCommand("waypoint.action.properties", tr("Group, colour, note, speeds…"),
                              QKeySequence(Qt::ALT | Qt::Key_Return), [this] { dialogs_->properties(); })));
    add(onSelected(addCommand("waypoint.action.actions", tr("Actions…"), QKeySequence(Qt::ALT | Qt::Key_A),
                              [this] { dialogs_->actions(); })));
    add(onSelected(addCommand("waypoint.action.shift", tr("Offset, rotate or mirror…"), {},
                              [this] { dialogs_->moveSelection(); })));
    add(onSelected(addCommand("waypoint.action.history", tr("History…"), QKeySequence(Qt::ALT | Qt::Key_H),
                              [this] { dialogs_->history(); })));
    menu->addSeparator();
    // Rarely used functions are in a menu, so that the buttons fit on the smallest screen.
    const auto addMenu = [menu](const char* name, const QString& text) {
        QMenu* part = menu->addMenu(text);
        part->setObjectName(QLatin1String(name));
        return part;
    };
    QMenu* files = addMenu("waypoint.menu.files", tr("Import and export"));
    addTo(files, addCommand("waypoint.action.import", tr("Import waypoints…"), {},
                            [this] { dialogs_->importFile(); }));
    addTo(files, addCommand("waypoint.action.export", tr("Export waypoints…"), {},
                            [this] { dialogs_->exportFile(); }));
    QMenu* pattern = addMenu("waypoint.menu.pattern", tr("Pattern"));
    addTo(pattern, addCommand("waypoint.action.pattern", tr("Create or edit pattern…"), {},
                              [this] { dialogs_->pattern(); }));
    addTo(pattern, onSelected(addCommand("waypoint.action.dissolve", tr("Convert pattern to waypoints"), {},
                                         [this] { dialogs_->dissolvePattern(); })));
    addTo(pattern,
          onSelected(addCommand("waypoint.action.removePattern", tr("Delete pattern and its waypoints"), {},
                                [this] { dialogs_->removePattern(); })));
    QMenu* path = addMenu("waypoint.menu.path", tr("Path"));
    for (QAction* action : paths_->actions()) {
        path->addAction(action);
        actions_.append(action);
    }
    path->addMenu(paths_->toleranceMenu());
    menu->addSeparator();
    QUndoStack& undo = document_.undoStack();
    for (QAction* action :
         {undo.createUndoAction(this, tr("Undo")), undo.createRedoAction(this, tr("Redo"))}) {
        const bool isUndo = actions_.last()->objectName() != QLatin1String("waypoint.action.undo");
        // Undo and redo through the document, which also reports the change.
        disconnect(action, nullptr, &undo, nullptr);
        connect(action, &QAction::triggered, &document_,
                isUndo ? &UndoableDocument::undo : &UndoableDocument::redo);
        action->setObjectName(isUndo ? QStringLiteral("waypoint.action.undo")
                                     : QStringLiteral("waypoint.action.redo"));
        action->setShortcuts(isUndo ? QList<QKeySequence>{QKeySequence(Qt::CTRL | Qt::Key_Z)}
                                    : QList<QKeySequence>{QKeySequence(Qt::CTRL | Qt::Key_Y),
                                                          QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z)});
        actions_.append(action);
        add(action);
    }
    more_->setMenu(menu);
    showPathRecording();
    table_->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(table_, &QWidget::customContextMenuRequested, this,
            [this, menu](const QPoint& position) { menu->popup(table_->viewport()->mapToGlobal(position)); });
}

void WaypointsTab::addToMenu(const QList<QAction*>& actions) {
    more_->menu()->addSeparator();
    QMenu* project = more_->menu()->addMenu(tr("Project"));
    project->setObjectName(QStringLiteral("waypoint.menu.project"));
    project->addActions(actions);
}

// ---- teaching --------------------------------------------------------------------------------------

void WaypointsTab::teach() {
    if (const QString obstacle = positionObstacle(); !obstacle.isEmpty()) {
        showProblem(obstacle);
        return;
    }
    notice_->dismissWithoutCause();
    const int row = currentRow();
    project::Waypoint point;
    if (row >= 0) {
        // Neighbouring waypoints usually have the same move type, frame and speed, so use the values of the
        // selected waypoint.
        point = document_.waypoints().at(row);
        point.extra = {};
        point.note.clear();
        point.actions.clear();
        point.place = {};
        point.history = {};
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

void WaypointsTab::teachByKey() {
    const QWidget* focus = QApplication::focusWidget();
    const bool isElsewhere = focus == nullptr || !isAncestorOf(focus);
    const int before = model_->rowCount();
    teach();
    if (!isElsewhere || model_->rowCount() == before || holdPolicy_.holding != nullptr) {
        return;
    }
    // Offer to undo, because the key may have been pressed by mistake. In the table, F2 renames the waypoint.
    table_->setFocus(Qt::ShortcutFocusReason);
    const project::Waypoint& taught = document_.waypoints().at(currentRow());
    const auto undo = [this, id = taught.id] {
        if (const int row = document_.waypoints().indexOf(id); row >= 0) {
            document_.removeWaypoints({row});
        }
    };
    notice_->resolve(QLatin1String(kPassing));
    notice_->show(NoticeBar::Kind::Question, {.title = tr("Taught “%1”").arg(taught.name),
                                              .accept = tr("Undo"),
                                              .accepted = undo,
                                              .dismiss = tr("Close"),
                                              .cause = QLatin1String(kPassing)});
    passing_.start();
}

void WaypointsTab::touchUp() {
    const int row = currentRow();
    const QString obstacle = row < 0 ? tr("Select a waypoint to touch up.") : positionObstacle();
    if (!obstacle.isEmpty()) {
        showProblem(obstacle);
        return;
    }
    if (!taughtNow(row)) {
        showProblem(tr("The frame of “%1” is not in this project. Choose a different frame first.")
                        .arg(document_.waypoints().at(row).name));
        return;
    }
    const project::Waypoint& before = document_.waypoints().at(row);
    notice_->show(NoticeBar::Kind::Question,
                  {.title = tr("Touch up “%1”?").arg(before.name),
                   .accept = tr("Touch up"),
                   .accepted = [this, id = before.id] { replaceByTouchUp(id); },
                   .liveText = [this, id = before.id] { return touchUpText(id); }});
    setTouchUpGhost(Ghost{before.name, state_.q, before.move == project::MoveKind::Linear});
}

std::optional<project::Waypoint> WaypointsTab::taughtNow(int row) const {
    return project::taughtAt(document_.waypoints().at(row), state_.q, state_.tcpPose, state_.tcpOffset,
                             document_.frames());
}

QString WaypointsTab::touchUpText(const QUuid& id) const {
    const int row = document_.waypoints().indexOf(id);
    if (row < 0) {
        return {};
    }
    const project::Waypoint& before = document_.waypoints().at(row);
    const Pose old = kinematics::forwardTcp(
        document_.robot().dh, document_.reach(row).ok() ? document_.reach(row).q : before.joints,
        before.tcpOffset);
    const project::PoseDifference by = project::poseDifference(old, state_.tcpPose);
    const Vector6 turns = state_.q.values - before.joints.values;
    int joint = 0;
    turns.cwiseAbs().maxCoeff(&joint);
    return tr("The current position is %1 away (%2, base frame). Largest joint change: %3 %4.")
        .arg(format::difference(by.distance, by.angle), format::shift(state_.tcpPose.position - old.position),
             jointName(joint), format::degrees(turns[joint], 1));
}

void WaypointsTab::replaceByTouchUp(const QUuid& id) {
    const int row = document_.waypoints().indexOf(id);
    if (row < 0) {
        return;
    }
    if (const QString obstacle = positionObstacle(); !obstacle.isEmpty()) {
        showProblem(obstacle);
        return;
    }
    if (const std::optional<project::Waypoint> taught = taughtNow(row)) {
        document_.changeWaypoint(row, *taught, tr("Touch up “%1”").arg(taught->name));
    }
}

void WaypointsTab::showNotice(const Notice& notice) {
    setTouchUpGhost(std::nullopt);
    notice_->show(NoticeBar::Kind::Warning, notice);
}

void WaypointsTab::resolveNotice(const QString& cause) {
    notice_->resolve(cause);
}

void WaypointsTab::showProblem(const QString& text, const QString& details) {
    setTouchUpGhost(std::nullopt);
    notice_->show(NoticeBar::Kind::Warning, text, details);
}

}  // namespace tiller

#include "moc_waypoints_tab.cpp"
