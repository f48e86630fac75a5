// SPDX-License-Identifier: MIT
#include "robot/station/program/step_kind.h"

#include <QUuid>
#include <algorithm>
#include <array>

#include "robot/station/program/detail/step_kinds.h"
#include "robot/station/program/program_text.h"

namespace tiller::program {

std::span<const StepKind* const> stepKinds() {
    static const std::array kinds{
        &moveJStep(),
        &moveLStep(),
        &movePStep(),
        &moveCircleStep(),
        &moveGroupStep(),
        &moveRelativeStep(),
        &moveUntilStep(),
        &setOutputStep(),
        &pulseOutputStep(),
        &setAnalogOutputStep(),
        &setRegisterStep(),
        &waitInputStep(),
        &waitStep(),
        &waitConditionStep(),
        &gripperStep(),
        &toolStep(),
        &payloadStep(),
        &frameStep(),
        &speedStep(),
        &forceStep(),
        &loopStep(),
        &whileLoopStep(),
        &forEachWaypointStep(),
        &forEachPlaceStep(),
        &leaveLoopStep(),
        &ifStep(),
        &elseIfStep(),
        &elseStep(),
        &switchStep(),
        &caseStep(),
        &defaultStep(),
        &callStep(),
        &watchStep(),
        &tryStep(),
        &onErrorStep(),
        &failStep(),
        &endProgramStep(),
        &assignStep(),
        &messageStep(),
        &questionStep(),
        &noteStep(),
        &scriptTextStep(),
        &commentStep(),
        &folderStep(),
    };
    return kinds;
}

const StepKind* findStepKind(const QString& id) {
    const auto kinds = stepKinds();
    const auto found = std::find_if(kinds.begin(), kinds.end(),
                                    [&](const StepKind* kind) { return id == QLatin1String(kind->id); });
    return found == kinds.end() ? nullptr : *found;
}

QString groupName(StepGroup group) {
    switch (group) {
        case StepGroup::Motion:
            return ProgramText::tr("Moves");
        case StepGroup::InputsOutputs:
            return ProgramText::tr("Inputs and outputs");
        case StepGroup::Wait:
            return ProgramText::tr("Waiting");
        case StepGroup::Tooling:
            return ProgramText::tr("Tool and speed");
        case StepGroup::Flow:
            return ProgramText::tr("Flow");
        case StepGroup::Variables:
            return ProgramText::tr("Variables");
        case StepGroup::Operator:
            return ProgramText::tr("Operator");
        case StepGroup::Structure:
            return ProgramText::tr("Structure");
    }
    return {};
}

project::ProgramStep newStep(const StepKind& kind) {
    project::ProgramStep step;
    step.id = QUuid::createUuid();
    step.kind = QLatin1String(kind.id);
    for (const StepField& field : kind.fields()) {
        if (!field.initial.isUndefined() && !field.initial.isNull()) {
            step.fields.insert(QLatin1String(field.key), field.initial);
        }
    }
    return step;
}

QJsonValue fieldValue(const project::ProgramStep& step, const StepField& field) {
    const QJsonValue value = step.fields.value(QLatin1String(field.key));
    return value.isUndefined() ? field.initial : value;
}

}  // namespace tiller::program
