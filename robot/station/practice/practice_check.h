// SPDX-License-Identifier: MIT
#pragma once

// The practice tasks and their completion checks. The checks evaluate the state of the robot and the project
// instead of user input. Each attempt uses a new check.

#include <QString>
#include <QUuid>
#include <array>
#include <memory>
#include <optional>

#include "robot/project/project_file.h"
#include "robot/station/link/session_state.h"

namespace tiller {

enum class PracticeTask { Recover, TeachFrame, TouchUp, FindLimit, Measure };
inline constexpr std::array kPracticeTasks = {PracticeTask::Recover, PracticeTask::TeachFrame,
                                              PracticeTask::TouchUp, PracticeTask::FindLimit,
                                              PracticeTask::Measure};

/// Name of the task in the settings, e.g. "recover".
QString practiceName(PracticeTask task);
QString practiceTitle(PracticeTask task);
/// Instruction of two or three sentences.
QString practiceText(PracticeTask task);

class PracticeCheck {
public:
    virtual ~PracticeCheck() = default;
    PracticeCheck() = default;
    PracticeCheck(const PracticeCheck&) = delete;
    PracticeCheck& operator=(const PracticeCheck&) = delete;

    /// Call this with every state and after every edit of the project.
    virtual void follow(const SessionState& state, const project::Project& project) = 0;
    /// Sets the number that the user has measured; empty if not entered. Only some tasks require this number.
    virtual void setAnswer(std::optional<double> /*figure*/) {}

    /// True once the check has passed. The value then remains true.
    bool passed() const { return passed_; }
    /// Describes the progress and the missing steps.
    QString text() const { return text_; }

protected:
    void say(const QString& text) { text_ = passed_ ? text_ : text; }
    void pass(const QString& text) {
        say(text);
        passed_ = true;
    }

private:
    bool passed_ = false;
    QString text_;
};

/// Displacement of the workpiece in the task "touch up", along X of the base frame [m].
inline constexpr double kPartMoved = 0.020;

/// Returns a waypoint for the task "touch up" at the current position of the arm. In the task, the workpiece
/// has moved away from this position.
project::Waypoint practiceWaypoint(const SessionState& state, const project::Project& project);

/// project   project at the start of the attempt
/// waypoint  created for "touch up"; null for other tasks
std::unique_ptr<PracticeCheck> practiceCheck(PracticeTask task, const project::Project& project,
                                             const QUuid& waypoint = {});

}  // namespace tiller
