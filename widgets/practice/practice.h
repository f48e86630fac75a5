// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The practice tasks as they are being done: which one is shown, whether it can be started, and the check of the
// try under way. What a task needs of the simulated controller comes from outside; a real robot is never touched.

#include <QObject>
#include <QStringList>
#include <array>
#include <functional>
#include <memory>
#include <optional>

#include "widgets/practice/practice_check.h"

namespace tiller {

class ProjectDocument;
class RobotSession;

struct PracticeHooks {
    /// Why this is not the simulated robot of this program, as a sentence; empty when it is.
    std::function<QString(const SessionState&)> obstacle;
    /// Makes happen at the simulated controller what the task begins with.
    std::function<void(PracticeTask)> setUp;
    /// Takes back what setUp() left there. Harmless when there is nothing.
    std::function<void()> tidyUp;
    std::function<void(const project::Waypoint&)> addWaypoint;
};

class Practice : public QObject {
    Q_OBJECT

public:
    /// session, document  must outlive it
    Practice(RobotSession& session, ProjectDocument& document, PracticeHooks hooks,
             QObject* parent = nullptr);
    ~Practice() override;

    PracticeTask task() const { return task_; }
    /// Another task; the try under way ends.
    void choose(PracticeTask task);
    /// by  1: the next one, -1: the one before
    void turn(int by);

    /// Why the task cannot be started now; empty when it can.
    QString obstacle() const;
    void start();
    bool isRunning() const { return check_ != nullptr; }
    /// The check of this try has passed.
    bool passed() const { return check_ != nullptr && check_->passed(); }
    /// What the check says, or why there can be none.
    QString text() const;
    void setAnswer(std::optional<double> figure);
    /// The operator says that it is done: counts if the check has passed. Goes on to the next that is not.
    void finish();
    /// Ends the try under way.
    void abandon();

    bool isDone(PracticeTask task) const { return done_[static_cast<std::size_t>(task)]; }
    bool allDone() const;
    /// Names of those done, for the settings, and the way back.
    QStringList done() const;
    void setDone(const QStringList& names);

Q_SIGNALS:
    /// Anything that is shown of it.
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
    QString shown_;  ///< text(), obstacle() and passed() as they were told last
    std::array<bool, kPracticeTasks.size()> done_{};
};

}  // namespace tiller
