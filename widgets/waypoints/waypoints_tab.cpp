// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/waypoints/waypoints_tab.h"

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QHBoxLayout>
#include <QItemSelectionModel>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QStackedWidget>
#include <QToolButton>
#include <QVBoxLayout>

#include "robot/kinematics/arm_kinematics.h"
#include "widgets/common/hold_button.h"
#include "widgets/common/notice_bar.h"
#include "widgets/common/text_entry.h"
#include "widgets/project/project_document.h"
#include "widgets/session/move_time.h"
#include "widgets/session/texts.h"
#include "widgets/waypoints/waypoint_details.h"
#include "widgets/waypoints/waypoint_model.h"
#include "widgets/waypoints/waypoint_motion.h"
#include "widgets/waypoints/waypoint_table.h"

namespace tiller {

WaypointPort waypointPort(RobotSession& session) {
    return {
        .beginMove = [&session](const MoveRequest& request) { return session.beginMove(request); },
        .hold = [&session](RobotSession::MotionId id) { return session.hold(id); },
        .endMotion = [&session](RobotSession::MotionId id,
                                control::StopCause cause) { session.endMotion(id, cause); },
        .limits = [&session] { return session.limits(); },
    };
}

WaypointsTab::WaypointsTab(RobotSession& session, ProjectDocument& document, QWidget* parent)
    : WaypointsTab(session, document, waypointPort(session), parent) {}

WaypointsTab::WaypointsTab(RobotSession& session, ProjectDocument& document, WaypointPort port,
                           QWidget* parent)
    : QWidget(parent)
    , session_(session)
    , port_(std::move(port))
    , state_(session.state())
    , document_(document)
    , model_(std::make_unique<WaypointModel>(document)) {
    setObjectName(QStringLiteral("waypoints"));
    setAccessibleName(tr("Waypoints"));
    buildLayout();
    buildActions();
    setUpGoTo();

    // Figures that change sixty times a second cannot be read.
    detailsTimer_.setSingleShot(true);
    detailsTimer_.setInterval(100);
    connect(&detailsTimer_, &QTimer::timeout, this, [this] { details_->setLive(state_); });

    connect(&session_, &RobotSession::stateChanged, this, &WaypointsTab::onState);
    connect(table_, &WaypointTable::currentRowChanged, this, &WaypointsTab::onSelection);
    connect(&document_, &ProjectDocument::waypointsAppeared, this,
            [this](int first, int) { selectRow(first); });
    connect(&document_, &ProjectDocument::projectReplaced, this,
            [this] { selectRow(model_->rowCount() > 0 ? 0 : -1); });
    connect(model_.get(), &WaypointModel::editRefused, this, &WaypointsTab::showProblem);
    connect(&document_, &ProjectDocument::documentChanged, this, [this] {
        pages_->setCurrentIndex(model_->rowCount() == 0 ? 0 : 1);
        goTo_->guard().stop(control::StopCause::SelectionChanged);
        onSelection();
        updateAvailability();
        Q_EMIT marksChanged();
        Q_EMIT ghostChanged();
    });
    onState(state_);
    onSelection();
}

WaypointsTab::~WaypointsTab() {
    qApp->removeEventFilter(this);
    goTo_->guard().stop(control::StopCause::WindowClosed);
}

void WaypointsTab::buildLayout() {
    teach_ = new QPushButton(tr("Teach here  T"));
    teach_->setObjectName(QStringLiteral("waypoint.teach"));
    teach_->setAccessibleName(tr("Teach here"));
    teach_->setProperty("primary", true);
    touchUp_ = new QPushButton(tr("Touch up  U"));
    touchUp_->setObjectName(QStringLiteral("waypoint.touchUp"));
    touchUp_->setAccessibleName(tr("Touch up"));
    goTo_ = new HoldButton(tr("Go to (hold)  G"));
    goTo_->setObjectName(QStringLiteral("waypoint.goTo"));
    goTo_->setAccessibleName(tr("Go to, hold"));
    more_ = new QToolButton;
    more_->setObjectName(QStringLiteral("waypoint.more"));
    more_->setAccessibleName(tr("More"));
    more_->setText(QStringLiteral("⋯"));
    more_->setPopupMode(QToolButton::InstantPopup);

    auto* keys = new QHBoxLayout;
    keys->setContentsMargins(12, 12, 12, 8);
    keys->setSpacing(8);
    keys->addWidget(teach_, 3);
    keys->addWidget(touchUp_, 2);
    keys->addWidget(goTo_, 3);
    keys->addWidget(more_);

    notice_ = new NoticeBar;
    auto* noticeRow = new QHBoxLayout;
    noticeRow->setContentsMargins(12, 0, 12, 8);
    noticeRow->addWidget(notice_);

    auto* empty = new QLabel(tr("No waypoints yet.\nJog the arm to a place and press Teach here (T)."));
    empty->setObjectName(QStringLiteral("waypoint.empty"));
    empty->setProperty("role", "secondary");
    empty->setAlignment(Qt::AlignCenter);
    empty->setWordWrap(true);
    table_ = new WaypointTable(*model_);
    pages_ = new QStackedWidget;
    pages_->addWidget(empty);
    pages_->addWidget(table_);
    details_ = new WaypointDetails(document_, *model_);

    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addLayout(keys);
    layout->addLayout(noticeRow);
    layout->addWidget(pages_, 1);
    layout->addWidget(details_);

    connect(teach_, &QPushButton::clicked, this, &WaypointsTab::teach);
    connect(touchUp_, &QPushButton::clicked, this, &WaypointsTab::touchUp);
}

void WaypointsTab::onState(const SessionState& state) {
    state_ = state;
    if (document_.robot().id != state.model) {
        document_.setRobot(state.model);
        Q_EMIT ghostChanged();
    }
    if (!detailsTimer_.isActive()) {
        detailsTimer_.start();
    }
    goTo_->setConfirmed(goTo_->isHolding() && state.moving);
    updateAvailability();
}

void WaypointsTab::onSelection() {
    const int row = currentRow();
    const QUuid id = row < 0 ? QUuid() : document_.waypoints().at(row).id;
    details_->setWaypoint(row);
    details_->setVisible(model_->rowCount() > 0);
    if (id == lastSelected_) {
        return;
    }
    lastSelected_ = id;
    goTo_->guard().stop(control::StopCause::SelectionChanged);
    notice_->dismiss();
    updateAvailability();
    Q_EMIT selectionChanged(id);
    Q_EMIT ghostChanged();
    Q_EMIT marksChanged();
}

int WaypointsTab::currentRow() const {
    const QModelIndex current = table_->currentIndex();
    return current.isValid() && current.row() < model_->rowCount() ? current.row() : -1;
}

void WaypointsTab::selectWaypoint(const QUuid& id) {
    selectRow(document_.waypoints().indexOf(id));
}

void WaypointsTab::selectRow(int row) {
    if (row < 0 || row >= model_->rowCount()) {
        table_->selectionModel()->clear();
    } else {
        // Not through the view: it would let the modifiers of the shortcut under way extend the selection.
        const QModelIndex index = model_->index(row, WaypointModel::Name);
        table_->selectionModel()->setCurrentIndex(
            index, QItemSelectionModel::ClearAndSelect | QItemSelectionModel::Rows);
        table_->scrollTo(index);
    }
    onSelection();
}

std::optional<WaypointGhost> WaypointsTab::ghost() const {
    const int row = currentRow();
    if (row < 0) {
        return std::nullopt;
    }
    const project::Waypoint& point = document_.waypoints().at(row);
    const project::Reach& reach = document_.reach(row);
    return WaypointGhost{point.name,
                         reach.ok() ? reach.q : point.joints,
                         point.move == project::MoveKind::Linear,
                         reach.ok(),
                         point.speed(),
                         point.acceleration()};
}

std::vector<WaypointMark> WaypointsTab::marks() const {
    std::vector<WaypointMark> result;
    for (int row = 0; row < model_->rowCount(); ++row) {
        const project::Waypoint& point = document_.waypoints().at(row);
        std::optional<Pose> pose = project::poseInBase(point, document_.frames());
        if (point.ruling == project::Ruling::Joints) {
            pose = kinematics::forwardTcp(document_.robot().dh, point.joints, point.tcpOffset);
        }
        if (pose) {
            result.push_back({point.name, pose->position, row == currentRow()});
        }
    }
    return result;
}

// ---- availability ----------------------------------------------------------------------------------

QString WaypointsTab::teachObstacle() const {
    if (state_.link == LinkState::Live) {
        return {};
    }
    return state_.hasData() ? tr("The robot's data are old. Wait until they come again.")
                            : tr("No robot is connected. Connect one, or try the simulator.");
}

QString WaypointsTab::goToObstacle() const {
    if (currentRow() < 0) {
        return tr("Select a waypoint to go to.");
    }
    if (!document_.reach(currentRow()).ok()) {
        return WaypointModel::reachAdvice(document_.reach(currentRow()));
    }
    if (!state_.canMove()) {
        return state_.controlReason.isEmpty() ? tr("The arm is not under control. Take control first.")
                                              : state_.controlReason;
    }
    return {};
}

void WaypointsTab::updateAvailability() {
    const QString teachReason = teachObstacle();
    const bool selected = currentRow() >= 0;
    teach_->setEnabled(teachReason.isEmpty());
    teach_->setToolTip(teachReason.isEmpty()
                           ? tr("Add the place where the arm stands, after the selection (T)")
                           : teachReason);
    touchUp_->setEnabled(teachReason.isEmpty() && selected);
    touchUp_->setToolTip(!teachReason.isEmpty() ? teachReason
                         : selected             ? tr("Replace the selected place by where the arm stands (U)")
                                                : tr("Select a waypoint to touch up."));
    goTo_->setUnavailable(goToObstacle());
    for (QAction* action : actions_) {
        if (action->property("needsSelection").toBool()) {
            action->setEnabled(selected);
        }
    }
}

// ---- go to, while held -----------------------------------------------------------------------------

void WaypointsTab::setUpGoTo() {
    goTo_->setToolTip(tr("Moves the arm to the selected waypoint while the key is held (G)"));
    goTo_->setMotion({
        .begin = [this] { return beginGoTo(); },
        .hold = [this](HoldMotion::Id id) { return port_.hold(id); },
        .end = [this](HoldMotion::Id id, control::StopCause cause) { port_.endMotion(id, cause); },
        .runsToEnd = {},
        .bounds = [this] { return goToBounds_; },
    });
    connect(&goTo_->guard(), &HoldGuard::refused, this, [this](const Error& error) {
        const QString text = error.code == ErrorCode::NoSolution || error.code == ErrorCode::Cancelled
                                 ? error.context
                                 : texts::errorText(error);
        showProblem(text);
        Q_EMIT message(Severity::Warning, text);
    });
    connect(
        &goTo_->guard(), &HoldGuard::ended, this,
        [this] {
            if (goTo_->hasFocus()) {
                table_->setFocus();
            }
        },
        Qt::QueuedConnection);
}

Result<RobotSession::MotionId> WaypointsTab::beginGoTo() {
    if (const QString obstacle = goToObstacle(); !obstacle.isEmpty()) {
        return Error{ErrorCode::NoSolution, obstacle, {}};
    }
    notice_->dismiss();
    const Result<MoveRequest> request =
        moveRequestFor(document_.robot(), document_.waypoints().at(currentRow()), document_.frames(),
                       state_.q, state_.tcpOffset, port_.limits());
    if (!request) {
        return request.error();
    }
    const bool linear = request->kind == MoveRequest::Kind::MoveL;
    goToBounds_ = {HoldBounds::longestOf(moveSeconds(*request, state_)),
                   HoldRules::silenceAt(linear ? request->speed : 0, linear ? 0 : request->speed)};
    return port_.beginMove(*request);
}

bool WaypointsTab::typingSomewhere() const {
    const QWidget* focus = QApplication::focusWidget();
    const auto* box = qobject_cast<const QComboBox*>(focus);
    return takesText(focus) || qobject_cast<const QLineEdit*>(focus) != nullptr || box != nullptr;
}

bool WaypointsTab::goToKey(const QKeyEvent& key) {
    const KeyCode code = PhysicalKeys::codeOf(key);
    const bool press = key.type() == QEvent::KeyPress;
    if (!goToKey_.isEmpty() && !goToKey_.isDown(code)) {
        // Another key than the one that holds: two hands on the keyboard are no hold, and a release nobody
        // can place may have been that of the key itself.
        if (!key.isAutoRepeat()) {
            goTo_->guard().tell(press ? HoldNews::Kind::OtherKey : HoldNews::Kind::Unmatched);
        }
        return false;
    }
    if (goToKey_.isDown(code)) {
        // The key that holds, whatever modifier or layout it now comes with.
        switch (goToKey_.take(key, Qt::Key_G)) {
            case PhysicalKeys::Change::Up:
                goTo_->guard().release();
                break;
            case PhysicalKeys::Change::DownAgain:
                goTo_->guard().tell(HoldNews::Kind::Unmatched);
                break;
            default:
                break;
        }
        return true;
    }
    if (!press || PhysicalKeys::keyOf(key) != Qt::Key_G || key.modifiers() != Qt::NoModifier ||
        !window()->isActiveWindow() || QApplication::activeModalWidget() != nullptr ||
        QApplication::activePopupWidget() != nullptr || typingSomewhere()) {
        return false;
    }
    if (goToKey_.take(key, Qt::Key_G) == PhysicalKeys::Change::Down) {
        goTo_->guard().press({Grip::By::Keys, {code}});
    }
    return true;
}

bool WaypointsTab::eventFilter(QObject* watched, QEvent* event) {
    const bool isKey = event->type() == QEvent::KeyPress || event->type() == QEvent::KeyRelease;
    // A key passes the native window first and the widget then: once is enough.
    if (isKey && watched->isWidgetType() && goToKey(*static_cast<QKeyEvent*>(event))) {
        return true;
    }
    if (event->type() == QEvent::WindowDeactivate && watched == window()) {
        goToKey_.clear();  // its release will not be seen
    }
    return QWidget::eventFilter(watched, event);
}

void WaypointsTab::showEvent(QShowEvent* event) {
    qApp->installEventFilter(this);
    QWidget::showEvent(event);
}

void WaypointsTab::hideEvent(QHideEvent* event) {
    qApp->removeEventFilter(this);
    goToKey_.clear();
    QWidget::hideEvent(event);
}

void WaypointsTab::showNotice(const QString& title, const QString& text, const QString& accept,
                              const std::function<void()>& accepted) {
    notice_->show(NoticeBar::Kind::Warning, title, text, accept, accepted);
}

void WaypointsTab::showProblem(const QString& text) {
    notice_->show(NoticeBar::Kind::Warning, text, {});
}

}  // namespace tiller
