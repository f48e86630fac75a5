// SPDX-License-Identifier: MIT
#pragma once

// What a step can be. Each kind is a file in steps/ and a row of the table in step_kind.cpp.

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
    /// Writes the script of the step and reports what is wrong with it beyond its fields, which are checked before.
    void (*write)(StepWriter& writer) = nullptr;
    bool isSection = false;  ///< has steps in it
    bool moves = false;      ///< moves the arm, so it must not run in parallel
    bool takesTime = false;  ///< at least one control period
    bool isMarker = false;   ///< changes nothing by itself: comment, else, case
    /// Kinds that may come directly before it, and no others; empty: it may follow anything.
    std::vector<const char*> follows = {};
    const char* inside = "";  ///< the only kind of section it may be in; empty: any
};

std::span<const StepKind* const> stepKinds();     ///< All of them, in the order of the palette.
const StepKind* findStepKind(const QString& id);  ///< Null for a kind of a newer version.

/// A step of that kind with a new id and the initial values of its fields.
project::ProgramStep newStep(const StepKind& kind);

/// The value of a field: the step's, else the initial one.
QJsonValue fieldValue(const project::ProgramStep& step, const StepField& field);

}  // namespace tiller::program
