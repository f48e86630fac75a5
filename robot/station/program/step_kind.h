// SPDX-License-Identifier: MIT
#pragma once

// The kinds of steps. Each kind is a file in steps/ and an entry of the table in step_kind.cpp.

#include <QString>
#include <span>
#include <vector>

#include "robot/project/program.h"
#include "robot/station/program/step_field.h"

namespace tiller::program {

class StepWriter;

enum class StepGroup { Motion, InputsOutputs, Wait, Tooling, Flow, Variables, Operator, Structure };
QString groupName(StepGroup group);  ///< Translated.

struct StepKind {
    const char* id = "";  ///< in the file
    StepGroup group = StepGroup::Structure;
    QString (*name)() = nullptr;  ///< translated
    std::vector<StepField> (*fields)() = nullptr;
    /// Writes the script of the step and reports problems beyond those of its fields, which are checked
    /// before.
    void (*write)(StepWriter& writer) = nullptr;
    bool isSection = false;  ///< contains other steps
    bool moves = false;      ///< moves the arm, so it must not run in parallel
    bool takesTime = false;  ///< at least one control period
    bool isMarker = false;   ///< has no effect on its own: comment, else, case
    /// Kinds of which one must come directly before it; empty: any.
    std::vector<const char*> follows = {};
    const char* inside = "";  ///< the kind of section that must contain it; empty: any
};

std::span<const StepKind* const> stepKinds();     ///< All kinds, in the order of the palette.
const StepKind* findStepKind(const QString& id);  ///< Null for a kind from a newer version.

/// Returns a step of that kind with a new id and initial field values.
project::ProgramStep newStep(const StepKind& kind);

/// The value of a field, or its initial value if not set.
QJsonValue fieldValue(const project::ProgramStep& step, const StepField& field);

}  // namespace tiller::program
