// SPDX-License-Identifier: MIT
#pragma once

// State of the practice tasks: the displayed task, whether the user can start it, and the check of the
// current attempt. PracticeHooks provides access to the simulated controller and the project. A real robot is
// never affected.

#include <QObject>
#include <QStringList>
#include <array>
#include <functional>
#include <memory>
#include <optional>

#include "robot/station/practice/practice_check.h"

namespace tiller {

class ProjectDocument;
class RobotSession;

struct PracticeHooks {
    /// Returns a sentence explaining why the connected robot is not the simulated robot of this application;
    /// empty if it is.
    std::function<QString(const SessionState&)> obstacle;
    /// Prepares the simulated controller for the task.
    std::function<void(PracticeTask)> setUp;
    /// Reverts the changes of setUp(). Has no effect if there are none.
    std::function<void()> tidyUp;
    std::function<void(const project::Waypoint&)> addWaypoint;
};

class Practice : public QObject {
    Q_OBJECT

public:
    /// session, document  must outlive the object
    Practice(RobotSession& session, ProjectDocument& document, PracticeHooks hooks,
             QObject* parent = nullptr);
    ~Practice() override;

    PracticeTask task() const { return task_; }
    /// Selects a task. Ends the current attempt.
    void choose(PracticeTask task);
    /// by  1: next task, -1: previous task
    void turn(int by);

    /// The reason why the user cannot start the task; empty if the task can be started.
    QString obstacle() const;
    void start();
    bool isRunning() const { return check_ != nullptr; }
    bool passed() const { return check_ != nullptr && check_->passed(); }
    /// Text of the check, or the reason why there is no check.
    QString text() const;
    void setAnswer(std::optional<double> figure);
    /// Completes the task if the check has passed, ends the attempt, and selects the next open task.
    void finish();
    void abandon();

    bool isDone(PracticeTask task) const { return done_[static_cast<std::size_t>(task)]; }
    bool allDone() const;
    /// Names of the completed tasks, for saving in the settings and restoring them.
    QStringList done() const;
    void setDone(const QStringList& names);

Q_SIGNALS:
    /// A displayed value has changed.
    void changed();
    void taskDone(tiller::PracticeTask task);

private:
    void onState(const SessionState& state);
    void follow();

    ProjectDocument& document_;
    PracticeHooks hooks_;
    SessionState state_;
    PracticeTask task_ = PracticeTask::Recover;
    std::unique_ptr<PracticeCheck> check_;
    QString shown_;  ///< last emitted state of text(), obstacle() and passed()
    std::array<bool, kPracticeTasks.size()> done_{};
};

}  // namespace tiller
