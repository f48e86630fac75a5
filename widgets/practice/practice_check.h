// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The practice tasks, and the checks of their completion, based on the state of the robot and the project, not on
// user input. A check belongs to one attempt; a new attempt has a new check.

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

/// Name for the settings, e.g. "recover".
QString practiceName(PracticeTask task);
QString practiceTitle(PracticeTask task);
/// Instruction in two or three sentences.
QString practiceText(PracticeTask task);

class PracticeCheck {
public:
    virtual ~PracticeCheck() = default;
    PracticeCheck() = default;
    PracticeCheck(const PracticeCheck&) = delete;
    PracticeCheck& operator=(const PracticeCheck&) = delete;

    /// Call with every state, and after every edit of the project.
    virtual void follow(const SessionState& state, const project::Project& project) = 0;
    /// A measured number, for tasks that ask for one; empty if not entered.
    virtual void setAnswer(std::optional<double> /*figure*/) {}

    /// True once the check has passed; never reset.
    bool passed() const { return passed_; }
    /// What was achieved, and what is missing.
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

/// Displacement of the part in the task "touch up" along X of the base [m].
inline constexpr double kPartMoved = 0.020;

/// The former position of the part: a waypoint for the task "touch up" at the current position of the arm.
project::Waypoint practiceWaypoint(const SessionState& state, const project::Project& project);

/// project   at the start of the attempt
/// waypoint  created for "touch up"; null for other tasks
std::unique_ptr<PracticeCheck> practiceCheck(PracticeTask task, const project::Project& project,
                                             const QUuid& waypoint = {});

}  // namespace tiller
