// SPDX-License-Identifier: MIT
#pragma once

// Edits of a program's tree of steps, as functions from one program to the next.

#include <QByteArray>
#include <QSet>
#include <QString>
#include <optional>
#include <vector>

#include "robot/project/project_file.h"

namespace tiller::program {

using Steps = std::vector<project::ProgramStep>;

/// Where steps are put: in front of the step at `row` of a section's steps, or behind the last.
struct StepPosition {
    QUuid section;  ///< null: the top level
    int row = 0;    ///< 0 ... number of steps there
};

/// Null when the program has no such step.
const project::ProgramStep* findStep(const Steps& steps, const QUuid& id);
/// Nothing when the program has no such step.
std::optional<StepPosition> positionOf(const project::Program& program, const QUuid& id);

/// The steps with these ids in the order of the tree, each with what is in it; a step inside another of them is left out.
Steps selectedSteps(const project::Program& program, const QSet<QUuid>& ids);

/// Copies with new ids throughout.
Steps withNewIds(Steps steps);

/// Returns  the program as it was when the section does not exist, is no section, or the nesting becomes too deep
project::Program withSteps(project::Program program, const StepPosition& at, const Steps& steps);
/// Removes the steps and what is in them.
project::Program withoutSteps(project::Program program, const QSet<QUuid>& ids);
/// Moves the steps, in the order of the tree.
/// Returns  the program as it was when `at` is inside one of them
project::Program withMovedSteps(const project::Program& program, const QSet<QUuid>& ids,
                                const StepPosition& at);
/// The copies follow the last of the steps, at its level.
project::Program withDuplicates(const project::Program& program, const QSet<QUuid>& ids);
/// Disables the steps, or enables them again.
project::Program withDisabled(project::Program program, const QSet<QUuid>& ids, bool disabled);
/// A field of a step; an undefined value removes it.
project::Program withField(project::Program program, const QUuid& step, const QString& key,
                           const QJsonValue& value);

/// Steps as text for the clipboard, readable by stepsFromText().
QByteArray textOf(const Steps& steps);
/// With new ids; nothing where the text contains no steps.
std::optional<Steps> stepsFromText(const QByteArray& text);

/// The values of a step in one line, in the units of the screen and with the names of waypoints and the like:
/// "pick, 50 mm/s".
QString summaryOf(const project::Project& project, const project::ProgramStep& step);

}  // namespace tiller::program
