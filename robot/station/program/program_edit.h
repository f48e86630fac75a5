// SPDX-License-Identifier: MIT
#pragma once

// Edits of the step tree of a program, as functions that return a new program.

#include <QByteArray>
#include <QSet>
#include <QString>
#include <optional>
#include <vector>

#include "robot/project/project_file.h"
#include "robot/station/program/program_script.h"
#include "robot/station/program/step_field.h"

namespace tiller::program {

using Steps = std::vector<project::ProgramStep>;

/// Position for inserting steps: before the step at `row` of a section, or after the last step.
struct StepPosition {
    QUuid section;  ///< null: the top level of the program
    int row = 0;    ///< 0 ... number of steps in the section
};

/// Returns null if the program does not contain the step.
const project::ProgramStep* findStep(const Steps& steps, const QUuid& id);
/// Position of a step; empty if the program does not contain the step.
std::optional<StepPosition> positionOf(const project::Program& program, const QUuid& id);

/// The steps with these IDs in tree order, with their children. Steps inside another selected step are
/// omitted.
Steps selectedSteps(const project::Program& program, const QSet<QUuid>& ids);

Steps withNewIds(Steps steps);

/// Inserts steps. Returns the unchanged program if the section does not exist or is not a section, or if the
/// nesting would be too deep.
project::Program withSteps(project::Program program, const StepPosition& at, const Steps& steps);
project::Program withoutSteps(project::Program program, const QSet<QUuid>& ids);
/// Moves the steps, in tree order. Returns the unchanged program if `at` is inside one of them.
project::Program withMovedSteps(const project::Program& program, const QSet<QUuid>& ids,
                                const StepPosition& at);
/// Position for adding steps when a step is selected: inside it if it is an empty section, otherwise after
/// it. If the step does not exist, the end of the program.
StepPosition positionBehind(const project::Program& program, const QUuid& id);
/// Moves the steps before the previous step (direction -1) or after the next step (1).
project::Program withShifted(const project::Program& program, const QSet<QUuid>& ids, int direction);
/// Moves the steps to the end of the section directly above them at the same level. Returns the unchanged
/// program if the step above them is not a section.
project::Program withNested(const project::Program& program, const QSet<QUuid>& ids);
/// Moves the steps out of the section that contains them, to the position after it.
project::Program withUnnested(const project::Program& program, const QSet<QUuid>& ids);
/// Inserts copies of the steps after the last of these steps, at the same level.
project::Program withDuplicates(const project::Program& program, const QSet<QUuid>& ids);
project::Program withDisabled(project::Program program, const QSet<QUuid>& ids, bool disabled);
/// Sets a field of a step. An undefined value removes the field.
project::Program withField(project::Program program, const QUuid& step, const QString& key,
                           const QJsonValue& value);

/// Converts steps to text for the clipboard. stepsFromText() is the inverse.
QByteArray textOf(const Steps& steps);
/// Returns the steps with new IDs; empty if the text does not contain steps.
std::optional<Steps> stepsFromText(const QByteArray& text);

/// The values of a step in one line, in display units and with the names of waypoints and other entities,
/// e.g. "pick, 50 mm/s".
QString summaryOf(const project::Project& project, const project::ProgramStep& step);
/// Name of the step kind; for a kind unknown to this version, its ID in the file.
QString kindName(const project::ProgramStep& step);
/// Kind name of the step with this number in the script. Empty if the step does not exist.
QString stepName(const project::Project& project, const ProgramScript& script, int number);
/// Number of the row of the step that has this number in the script. The two numbers can differ, because the
/// program may have been edited since. Returns `number` for a step that was removed or belongs to a called
/// program.
int rowNumber(const project::Project& project, const ProgramScript& script, int number);

/// The possible values of a choice, channel or reference field, with their names.
std::vector<std::pair<QJsonValue, QString>> choicesOf(const project::Project& project,
                                                      const StepField& field);

}  // namespace tiller::program
