// SPDX-License-Identifier: MIT
#pragma once

// Edits of a program's step tree, as functions that return a new program.

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

/// Position for inserting steps: before the step at `row` of a section, or after the last one.
struct StepPosition {
    QUuid section;  ///< null: the top level
    int row = 0;    ///< 0 ... number of steps there
};

/// Null when the program does not contain the step.
const project::ProgramStep* findStep(const Steps& steps, const QUuid& id);
/// Nothing when the program does not contain the step.
std::optional<StepPosition> positionOf(const project::Program& program, const QUuid& id);

/// The steps with these ids in tree order, each with its children; steps inside another selected step are
/// omitted.
Steps selectedSteps(const project::Program& program, const QSet<QUuid>& ids);

/// Copies with new ids for all steps.
Steps withNewIds(Steps steps);

/// Returns  the unchanged program when the section does not exist or is not a section, or the nesting becomes
/// too deep
project::Program withSteps(project::Program program, const StepPosition& at, const Steps& steps);
/// Removes the steps and their children.
project::Program withoutSteps(project::Program program, const QSet<QUuid>& ids);
/// Moves the steps, in tree order.
/// Returns  the unchanged program when `at` is inside one of them
project::Program withMovedSteps(const project::Program& program, const QSet<QUuid>& ids,
                                const StepPosition& at);
/// Where new steps are added when a step is selected: inside it if it is an empty section, else behind it. Without such a
/// step, at the end of the program.
StepPosition positionBehind(const project::Program& program, const QUuid& id);
/// Moves the steps past the step above (direction -1) or below (1) them.
project::Program withShifted(const project::Program& program, const QSet<QUuid>& ids, int direction);
/// Moves the steps to the end of the section above them, at their level.
/// Returns  the unchanged program when the step above is not a section
project::Program withNested(const project::Program& program, const QSet<QUuid>& ids);
/// Moves the steps behind the section they are in.
project::Program withUnnested(const project::Program& program, const QSet<QUuid>& ids);
/// The copies are inserted after the last of the steps, at its level.
project::Program withDuplicates(const project::Program& program, const QSet<QUuid>& ids);
/// Disables the steps, or enables them again.
project::Program withDisabled(project::Program program, const QSet<QUuid>& ids, bool disabled);
/// Sets a field of a step; an undefined value removes it.
project::Program withField(project::Program program, const QUuid& step, const QString& key,
                           const QJsonValue& value);

/// Steps as text for the clipboard, read by stepsFromText().
QByteArray textOf(const Steps& steps);
/// Returns the steps with new ids; nothing when the text contains no steps.
std::optional<Steps> stepsFromText(const QByteArray& text);

/// The values of a step in one line, in display units and with the names of waypoints and other entities:
/// "pick, 50 mm/s".
QString summaryOf(const project::Project& project, const project::ProgramStep& step);
/// The name of the step's kind; the word in the file where this version does not know the kind.
QString kindName(const project::ProgramStep& step);
/// The name of the kind of a step, by its number in the script. Empty: there is no such step.
QString stepName(const project::Project& project, const ProgramScript& script, int number);

/// The values that a choice, channel or reference field can have, each with its name.
std::vector<std::pair<QJsonValue, QString>> choicesOf(const project::Project& project,
                                                      const StepField& field);

}  // namespace tiller::program
