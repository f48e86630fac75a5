// SPDX-License-Identifier: MIT
#include "robot/project/program.h"

namespace tiller::project {

bool refersTo(const ProgramStep& step, const QUuid& id) {
    const QString text = id.toString(QUuid::WithoutBraces);
    return std::any_of(step.fields.begin(), step.fields.end(),
                       [&](const QJsonValueConstRef& value) { return value.toString() == text; }) ||
           std::any_of(step.steps.begin(), step.steps.end(),
                       [&](const ProgramStep& inner) { return refersTo(inner, id); });
}

bool refersTo(const Program& program, const QUuid& id) {
    return std::any_of(program.steps.begin(), program.steps.end(),
                       [&](const ProgramStep& step) { return refersTo(step, id); });
}

}  // namespace tiller::project
