// SPDX-License-Identifier: MIT
#pragma once

// A program as data: a tree of steps. A step consists of its kind and the fields of this kind, as stored in
// the file. robot/station/program interprets the steps. A step of an unknown kind keeps all its fields.

#include <QJsonObject>
#include <QString>
#include <QStringList>
#include <QUuid>
#include <vector>

#include "robot/project/entity_list.h"

namespace tiller::project {

inline constexpr int kMaxProgramDepth = 50;       ///< maximum nesting of sections
inline constexpr int kMaxProgramSteps = 100'000;  ///< maximum number of steps in a program

struct ProgramStep {
    QUuid id;
    QString kind;        ///< "moveJ"; see robot/station/program/step_kind.h
    QJsonObject fields;  ///< field values by name; numbers in SI units, references as IDs
    bool disabled = false;
    std::vector<ProgramStep> steps;  ///< steps inside a section
    friend bool operator==(const ProgramStep&, const ProgramStep&) = default;
};

struct Program {
    QUuid id;
    QString name;
    QStringList parameters;  ///< variables that are set by a call
    std::vector<ProgramStep> steps;
    QString note;
    QJsonObject extra;  ///< unknown fields of the file, preserved when saving
    friend bool operator==(const Program&, const Program&) = default;
};
using ProgramList = EntityList<Program>;

/// True if a field of the step or of a nested step refers to this waypoint, frame, tool, program or other
/// object.
bool refersTo(const ProgramStep& step, const QUuid& id);
bool refersTo(const Program& program, const QUuid& id);  ///< True if any of its steps refers to the object.

}  // namespace tiller::project
