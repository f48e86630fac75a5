// SPDX-License-Identifier: MIT
#pragma once

// The step kinds. Each kind has a file in steps/ and an entry in the table in step_kind.cpp.

#include <QString>
#include <span>
#include <vector>

#include "robot/project/program.h"
#include "robot/station/program/step_field.h"

namespace tiller::program {

class StepWriter;

enum class StepGroup { Motion, InputsOutputs, Wait, Tooling, Flow, Variables, Operator, Structure };
QString groupName(StepGroup group);  ///< Returns the translated name.

struct StepKind {
    const char* id = "";  ///< name in the file
    StepGroup group = StepGroup::Structure;
    QString (*name)() = nullptr;  ///< translated
    std::vector<StepField> (*fields)() = nullptr;
    /// Writes the script of the step and reports problems. The fields have already been checked.
    void (*write)(StepWriter& writer) = nullptr;
    bool isSection = false;  ///< contains other steps
    bool moves = false;      ///< moves the arm, so it must not run in parallel
    bool takesTime = false;  ///< takes at least one control period
    bool isMarker = false;   ///< has no effect on its own: comment, else, case
    /// Kinds of steps that may directly precede this step; empty: any.
    std::vector<const char*> follows = {};
    const char* inside = "";  ///< kind of section that must contain this step; empty: any
    /// Why a program cannot continue after a stop in this step or its child steps, as a translated sentence;
    /// null: the effects of the steps determine whether it can continue.
    QString (*cannotContinue)() = nullptr;
    /// For a step whose target is relative to its start position: the translated sentence that describes the
    /// step after a stop in the middle. Null: running the step again reaches the same target.
    QString (*partlyDone)() = nullptr;
};

std::span<const StepKind* const> stepKinds();     ///< All kinds, in the order of the palette.
const StepKind* findStepKind(const QString& id);  ///< Returns null for a kind of a newer version.

/// Returns a step of this kind with a new ID and initial field values.
project::ProgramStep newStep(const StepKind& kind);

/// The value of a field, or the initial value if it is not set.
QJsonValue fieldValue(const project::ProgramStep& step, const StepField& field);

}  // namespace tiller::program
