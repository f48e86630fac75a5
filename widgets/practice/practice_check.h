// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The practice tasks and what tells that one is done: from what the robot and the project say, never from a key
// that was pressed. A check follows one try; a new try gets a new check.

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

/// For the settings: "recover".
QString practiceName(PracticeTask task);
QString practiceTitle(PracticeTask task);
/// What to do, in two or three sentences.
QString practiceText(PracticeTask task);

class PracticeCheck {
public:
    virtual ~PracticeCheck() = default;
    PracticeCheck() = default;
    PracticeCheck(const PracticeCheck&) = delete;
    PracticeCheck& operator=(const PracticeCheck&) = delete;

    /// With every state, and after every edit of the project.
    virtual void follow(const SessionState& state, const project::Project& project) = 0;
    /// A figure that was measured, where the task asks for one; nothing while there is none.
    virtual void setAnswer(std::optional<double> /*figure*/) {}

    /// Once passed, it stays passed.
    bool passed() const { return passed_; }
    /// What is there, and what is missing.
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

/// How far the part of the task "touch up" has moved, along X of the base [m].
inline constexpr double kPartMoved = 0.020;

/// Where the part was: a waypoint for the task "touch up", at the arm's place.
project::Waypoint practiceWaypoint(const SessionState& state, const project::Project& project);

/// project   as it is when the try begins
/// waypoint  the one made for "touch up"; null for the other tasks
std::unique_ptr<PracticeCheck> practiceCheck(PracticeTask task, const project::Project& project,
                                             const QUuid& waypoint = {});

}  // namespace tiller
