// SPDX-License-Identifier: MIT
#pragma once

// A program as data: a tree of steps. A step is its kind and the fields of that kind, exactly as the file has them; what
// they mean is in robot/station/program. A step of a kind that this version does not know keeps all its fields.

#include <QJsonObject>
#include <QString>
#include <QStringList>
#include <QUuid>
#include <vector>

#include "robot/project/entity_list.h"

namespace tiller::project {

inline constexpr int kMaxProgramDepth = 50;       ///< sections inside sections
inline constexpr int kMaxProgramSteps = 100'000;  ///< of one program

struct ProgramStep {
    QUuid id;
    QString kind;        ///< "moveJ"; see robot/station/program/step_kind.h
    QJsonObject fields;  ///< by name; numbers in SI units, references as ids
    bool disabled = false;
    std::vector<ProgramStep> steps;  ///< of a section
    friend bool operator==(const ProgramStep&, const ProgramStep&) = default;
};

struct Program {
    QUuid id;
    QString name;
    QStringList parameters;  ///< variables that a call gives values to
    std::vector<ProgramStep> steps;
    QString note;
    QJsonObject extra;  ///< fields of the file that this version does not know
    friend bool operator==(const Program&, const Program&) = default;
};
using ProgramList = EntityList<Program>;

/// Whether a field of the step, or of a step in it, refers to the waypoint, frame, tool, program or the like.
bool refersTo(const ProgramStep& step, const QUuid& id);
bool refersTo(const Program& program, const QUuid& id);  ///< Whether any of its steps does.

}  // namespace tiller::project
