// SPDX-License-Identifier: MIT
#include "robot/station/practice/practice.h"

#include <algorithm>

#include "robot/station/document/project_document.h"
#include "robot/station/link/robot_session.h"

namespace tiller {
namespace {

constexpr int kTasks = static_cast<int>(kPracticeTasks.size());

}  // namespace

Practice::Practice(RobotSession& session, ProjectDocument& document, PracticeHooks hooks, QObject* parent)
    : QObject(parent), document_(document), hooks_(std::move(hooks)), state_(session.state()) {
    connect(&session, &RobotSession::stateChanged, this, &Practice::onState);
    connect(&document_, &ProjectDocument::documentChanged, this, &Practice::follow);
}

Practice::~Practice() {
    if (check_) {
        hooks_.tidyUp();
    }
}

void Practice::choose(PracticeTask task) {
    abandon();
    task_ = task;
    Q_EMIT changed();
}

void Practice::turn(int by) {
    choose(kPracticeTasks[static_cast<std::size_t>((static_cast<int>(task_) + by + kTasks) % kTasks)]);
}

QString Practice::obstacle() const {
    if (!state_.hasData() || state_.link != LinkState::Live) {
        return tr("Start the simulated robot in the Robot menu first.");
    }
    if (const QString other = hooks_.obstacle(state_); !other.isEmpty()) {
        return other;
    }
    if (state_.robotMode != RobotMode::Running) {
        return tr("Power on the arm and release the brakes first.");
    }
    return allowsMotion(state_.safety()) ? QString()
                                         : tr("The safety system has stopped the arm. Use “Recover…” first.");
}

void Practice::start() {
    if (!obstacle().isEmpty()) {
        Q_EMIT changed();
        return;
    }
    abandon();
    project::Waypoint point;
    if (task_ == PracticeTask::TouchUp) {
        point = practiceWaypoint(state_, document_.project());
        hooks_.addWaypoint(point);
    }
    check_ = practiceCheck(task_, document_.project(), point.id);
    hooks_.setUp(task_);
    follow();
    Q_EMIT changed();
}

QString Practice::text() const {
    if (check_) {
        return check_->text();
    }
    const QString why = obstacle();
    return !why.isEmpty()  ? why
           : isDone(task_) ? tr("Done. Press “Start” to repeat the task.")
                           : tr("Press “Start”.");
}

void Practice::setAnswer(std::optional<double> figure) {
    if (check_) {
        check_->setAnswer(figure);
        follow();
    }
}

void Practice::finish() {
    if (!passed()) {
        return;
    }
    const PracticeTask finished = task_;
    done_[static_cast<std::size_t>(finished)] = true;
    abandon();
    for (int i = 1; i < kTasks && isDone(task_); ++i) {
        task_ = kPracticeTasks[static_cast<std::size_t>((static_cast<int>(finished) + i) % kTasks)];
    }
    if (allDone()) {
        task_ = finished;
    }
    Q_EMIT taskDone(finished);
    Q_EMIT changed();
}

void Practice::abandon() {
    if (check_) {
        check_.reset();
        hooks_.tidyUp();
        Q_EMIT changed();
    }
}

bool Practice::allDone() const {
    return std::all_of(done_.begin(), done_.end(), [](bool done) { return done; });
}

QStringList Practice::done() const {
    QStringList names;
    for (const PracticeTask task : kPracticeTasks) {
        if (isDone(task)) {
            names << practiceName(task);
        }
    }
    return names;
}

void Practice::setDone(const QStringList& names) {
    for (const PracticeTask task : kPracticeTasks) {
        done_[static_cast<std::size_t>(task)] = names.contains(practiceName(task));
    }
    Q_EMIT changed();
}

void Practice::onState(const SessionState& state) {
    state_ = state;
    // No robot is connected, or the task was prepared on a different robot.
    if (check_ && (state.link == LinkState::Disconnected || !hooks_.obstacle(state).isEmpty())) {
        abandon();
    }
    follow();
}

void Practice::follow() {
    if (check_ && state_.link == LinkState::Live) {
        check_->follow(state_, document_.project());
    }
    QString now = text() + QLatin1Char('\n') + obstacle() + (passed() ? QLatin1Char('+') : QLatin1Char('-'));
    if (now != shown_) {
        shown_ = std::move(now);
        Q_EMIT changed();
    }
}

}  // namespace tiller

#include "moc_practice.cpp"
