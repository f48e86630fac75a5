// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/waypoints/go_through_bar.h"

#include <QAbstractItemView>
#include <QCheckBox>
#include <QHBoxLayout>
#include <algorithm>
#include <iterator>
#include <utility>

#include "robot/station/document/project_document.h"
#include "robot/station/route/action_words.h"
#include "widgets/common/choice_box.h"
#include "widgets/hold/hold_to_run_button.h"

namespace tiller {

using Way = RouteRunner::Way;

GoThroughBar::GoThroughBar(MotionPort port, HoldPolicy& policy, ActionPort actions,
                           const ProjectDocument& document, const std::function<HeldSpeed()>& heldSpeed,
                           QWidget* parent)
    : QWidget(parent)
    , port_(std::move(port))
    , policy_(policy)
    , actions_(std::move(actions))
    , document_(document)
    , goThrough_(port_, actions_, document, state_, heldSpeed)
    , scope_(new ChoiceBox)
    , loop_(new QCheckBox(tr("Loop"))) {
    setObjectName(QStringLiteral("waypoint.route"));
    setAccessibleName(tr("Run the route"));
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(12, 0, 12, 8);
    layout->setSpacing(8);
    layout->addWidget(
        addKey(tr("Run route (hold)"), QStringLiteral("waypoint.goThrough"), tr("Run route, hold"),
               tr("Moves from waypoint to waypoint while the button is held, no faster than the jog speed, "
                  "and runs the actions of each waypoint. Release to pause; the next press continues to the "
                  "next waypoint."),
               Way::Through),
        3);
    layout->addWidget(addKey(QStringLiteral("‹"), QStringLiteral("waypoint.stepBack"),
                             tr("Previous waypoint, hold"),
                             tr("Moves to the previous waypoint while the button is held"), Way::StepBack));
    layout->addWidget(
        addKey(QStringLiteral("›"), QStringLiteral("waypoint.stepOn"), tr("Next waypoint, hold"),
               tr("Moves to the next waypoint while the button is held, then stops"), Way::StepOn));
    through().setWidestDetail(QStringLiteral("000 waypoints · 000 mm/s"));

    scope_->setObjectName(QStringLiteral("waypoint.routeScope"));
    scope_->setAccessibleName(tr("Route waypoints"));
    scope_->view()->setAccessibleName(tr("Waypoints"));
    scope_->setToolTip(tr("Selects the waypoints to run, in list order"));
    scope_->addItems({tr("From here"), tr("Selection"), tr("All")});
    scope_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    layout->addWidget(scope_);
    loop_->setObjectName(QStringLiteral("waypoint.routeLoop"));
    loop_->setAccessibleName(tr("Loop"));
    loop_->setToolTip(
        tr("After the last waypoint, continues with the first waypoint while the button is held"));
    layout->addWidget(loop_);
    connect(scope_, &QComboBox::currentIndexChanged, this, [this] {
        stop(control::StopCause::SelectionChanged);
        goThrough_.setRows(rows());
    });
    connect(loop_, &QCheckBox::toggled, this, [this](bool loop) {
        stop(control::StopCause::SelectionChanged);
        goThrough_.setLoop(loop);
    });
    connect(&goThrough_, &RouteRunner::failed, this,
            [this](const QString& reason) { Q_EMIT refused(reason, false); });
    connect(&goThrough_, &RouteRunner::routeChanged, this, &GoThroughBar::showRoute);
    showRoute();
}

GoThroughBar::~GoThroughBar() {
    stop(control::StopCause::WindowClosed);
}

HoldToRunButton* GoThroughBar::addKey(const QString& text, const QString& objectName,
                                      const QString& accessibleName, const QString& toolTip, Way way) {
    auto* key = new HoldToRunButton(text, policy_);
    key->setObjectName(objectName);
    key->setAccessibleName(accessibleName);
    key->setToolTip(toolTip);
    key->setMotion(goThrough_.motion(way));
    connect(&key->guard(), &HoldGuard::began, this, &GoThroughBar::comingChanged);
    connect(&key->guard(), &HoldGuard::ended, this, &GoThroughBar::comingChanged);
    connect(&key->guard(), &HoldGuard::refused, this, [this](const Error& error) {
        Q_EMIT refused(RouteRunner::whyNot(error), error.code == ErrorCode::Cancelled);
    });
    keys_[static_cast<std::size_t>(way)] = key;
    return key;
}

QVector<int> GoThroughBar::rows() const {
    const int count = document_.waypoints().size();
    const auto scope = static_cast<Scope>(scope_->currentIndex());
    QVector<int> rows;
    if (scope == Scope::Selection) {
        std::copy_if(selected_.begin(), selected_.end(), std::back_inserter(rows),
                     [count](int row) { return row < count; });
        return rows;
    }
    for (int row = scope == Scope::FromHere ? std::max(current_, 0) : 0; row < count; ++row) {
        rows << row;
    }
    return rows;
}

void GoThroughBar::setSelection(int current, const QList<int>& selected) {
    const auto scope = static_cast<Scope>(scope_->currentIndex());
    const bool same = scope == Scope::All || (scope == Scope::FromHere && current == current_) ||
                      (scope == Scope::Selection && selected == selected_);
    current_ = current;
    selected_ = selected;
    if (!same) {
        stop(control::StopCause::SelectionChanged);
        goThrough_.setRows(rows());
    }
}

void GoThroughBar::followDocument(int current, const QList<int>& selected) {
    stop(control::StopCause::SelectionChanged);
    current_ = current;
    selected_ = selected;
    goThrough_.followRows(rows());
}

void GoThroughBar::setState(const SessionState& state) {
    state_ = state;
    for (HoldToRunButton* key : keys_) {
        key->setConfirmed(key->isHolding() && state.moving);
    }
    updateAvailability();
}

void GoThroughBar::updateAvailability() {
    QString robot;
    if (!state_.canMove()) {
        robot = state_.controlReason.isEmpty() ? tr("Tiller is not in control. Take control first.")
                                               : state_.controlReason;
    }
    for (std::size_t i = 0; i < keys_.size(); ++i) {
        // Do not disable a held button. The motion ends automatically.
        if (robot.isEmpty() && keys_[i]->isHolding()) {
            continue;
        }
        keys_[i]->setUnavailable(obstacles_[i].isEmpty() ? robot : obstacles_[i]);
    }
}

void GoThroughBar::showRoute() {
    for (const Way way : {Way::Through, Way::StepOn, Way::StepBack}) {
        obstacles_[static_cast<std::size_t>(way)] = goThrough_.obstacle(way);
    }
    updateAvailability();
    const int size = goThrough_.route().size();
    const int row = comingRow();
    QString place;
    const project::WaypointAction* acting = goThrough_.acting();
    if (row >= 0 && acting != nullptr) {
        place_ = ActionWords::of(*acting);
        place = tr("At %1: %2").arg(document_.waypoints().at(row).name, place_);
    } else if (row >= 0) {
        const int number = *goThrough_.route().coming() + 1;
        place_ = tr("%1 of %2").arg(number).arg(size);
        place = tr("Next: %1 of %2, %3").arg(number).arg(size).arg(document_.waypoints().at(row).name);
    } else if (goThrough_.isUnderWay() && size > 0) {
        place_ = tr("done");
        place = tr("Done. The next press starts at the first waypoint.");
    } else {
        place_ = tr("%n waypoints", nullptr, size);
        place = place_;
    }
    through().setAccessibleDescription(place);
    showDetail();
    Q_EMIT comingChanged();
}

HoldToRunButton& GoThroughBar::through() {
    return *keys_[static_cast<std::size_t>(Way::Through)];
}

void GoThroughBar::showSpeed() {
    if (isHolding()) {
        return;  // the speed of the current motion does not change
    }
    const bool known = state_.hasData() && obstacles_[static_cast<std::size_t>(Way::Through)].isEmpty();
    const Result<MoveRequest> move =
        known ? goThrough_.firstMove(Way::Through) : Error{ErrorCode::NoSolution, {}, {}};
    speed_ = move ? moveSpeedText(*move, state_) : QString();
    showDetail();
}

void GoThroughBar::showDetail() {
    const bool moves = !speed_.isEmpty() && goThrough_.acting() == nullptr;
    through().setDetail(moves ? tr("%1 · %2").arg(place_, speed_) : place_);
}

void GoThroughBar::stop(control::StopCause cause) {
    for (HoldToRunButton* key : keys_) {
        key->guard().stop(cause);
    }
}

bool GoThroughBar::isHolding() const {
    return std::any_of(keys_.begin(), keys_.end(),
                       [](const HoldToRunButton* key) { return key->isHolding(); });
}

int GoThroughBar::comingRow() const {
    return goThrough_.isUnderWay() ? goThrough_.comingRow() : -1;
}

}  // namespace tiller

#include "moc_go_through_bar.cpp"
