// SPDX-License-Identifier: MIT
#include "robot/station/program/program_edit.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <algorithm>

#include "robot/station/program/program_text.h"
#include "robot/station/program/step_kind.h"

namespace tiller::program {

using project::Program;
using project::ProgramStep;

namespace {

ProgramStep* stepIn(Steps& steps, const QUuid& id) {
    for (ProgramStep& step : steps) {
        if (step.id == id) {
            return &step;
        }
        if (ProgramStep* inner = stepIn(step.steps, id)) {
            return inner;
        }
    }
    return nullptr;
}

void collectSelected(const Steps& steps, const QSet<QUuid>& ids, Steps& selected) {
    for (const ProgramStep& step : steps) {
        if (ids.contains(step.id)) {
            selected.push_back(step);
        } else {
            collectSelected(step.steps, ids, selected);
        }
    }
}

void removeFrom(Steps& steps, const QSet<QUuid>& ids) {
    std::erase_if(steps, [&](const ProgramStep& step) { return ids.contains(step.id); });
    for (ProgramStep& step : steps) {
        removeFrom(step.steps, ids);
    }
}

void renew(Steps& steps) {
    for (ProgramStep& step : steps) {
        step.id = QUuid::createUuid();
        renew(step.steps);
    }
}

int depthOf(const Steps& steps) {
    int depth = 0;
    for (const ProgramStep& step : steps) {
        depth = std::max(depth, 1 + depthOf(step.steps));
    }
    return depth;
}

std::optional<StepPosition> positionIn(const Steps& steps, const QUuid& section, const QUuid& id) {
    for (std::size_t i = 0; i < steps.size(); ++i) {
        if (steps[i].id == id) {
            return StepPosition{section, static_cast<int>(i)};
        }
        if (const auto inner = positionIn(steps[i].steps, steps[i].id, id)) {
            return inner;
        }
    }
    return std::nullopt;
}

template <class List>
QString nameIn(const List& list, const QUuid& id) {
    const auto* entity = list.find(id);
    return entity != nullptr ? entity->name : QStringLiteral("?");
}

QString valueText(const project::Project& project, const StepField& field, const QJsonValue& value) {
    const QUuid id(value.toString());
    switch (field.type) {
        case FieldType::Number:
        case FieldType::Whole:
            return numberText(value.toDouble(), field.unit);
        case FieldType::Flag:
            return value.toBool() ? field.label : QString();
        case FieldType::Choice:
            for (const Choice& choice : field.choices) {
                if (value.toString() == QLatin1String(choice.key)) {
                    return choice.label;
                }
            }
            return value.toString();
        case FieldType::DigitalInput:
        case FieldType::DigitalOutput:
            return channelName(value.toInt(), field.type == FieldType::DigitalOutput);
        case FieldType::Waypoint: {
            const int index = project.waypoints.indexOf(id);
            return index < 0 ? QStringLiteral("?") : project.waypoints.at(index).name;
        }
        case FieldType::Pattern:
            return nameIn(project.patterns, id);
        case FieldType::Frame:
            return nameIn(project.frames, id);
        case FieldType::Tool:
            return nameIn(project.tooling.tools, id);
        case FieldType::Payload:
            return nameIn(project.tooling.payloads, id);
        case FieldType::Program:
            return nameIn(project.programs, id);
        case FieldType::Text:
        case FieldType::Lines:
        case FieldType::Expression:
        case FieldType::Variable:
        case FieldType::Group:
            return value.toString().simplified();
    }
    return {};
}

}  // namespace

const ProgramStep* findStep(const Steps& steps, const QUuid& id) {
    return stepIn(const_cast<Steps&>(steps), id);  // NOLINT: only searched
}

std::optional<StepPosition> positionOf(const Program& program, const QUuid& id) {
    return positionIn(program.steps, {}, id);
}

Steps selectedSteps(const Program& program, const QSet<QUuid>& ids) {
    Steps selected;
    collectSelected(program.steps, ids, selected);
    return selected;
}

Steps withNewIds(Steps steps) {
    renew(steps);
    return steps;
}

Program withSteps(Program program, const StepPosition& at, const Steps& steps) {
    const Program before = program;
    Steps* into = &program.steps;
    if (!at.section.isNull()) {
        ProgramStep* section = stepIn(program.steps, at.section);
        const StepKind* kind = section != nullptr ? findStepKind(section->kind) : nullptr;
        if (kind == nullptr || !kind->isSection) {
            return before;
        }
        into = &section->steps;
    }
    const auto row = std::clamp(at.row, 0, static_cast<int>(into->size()));
    into->insert(into->begin() + row, steps.begin(), steps.end());
    return depthOf(program.steps) > project::kMaxProgramDepth ? before : program;
}

Program withoutSteps(Program program, const QSet<QUuid>& ids) {
    removeFrom(program.steps, ids);
    return program;
}

Program withMovedSteps(const Program& program, const QSet<QUuid>& ids, const StepPosition& at) {
    const Steps moved = selectedSteps(program, ids);
    if (moved.empty() || (!at.section.isNull() && findStep(moved, at.section) != nullptr)) {
        return program;
    }
    // Removing the moved steps above the target row, at the same level, shifts the row.
    const Steps* there = &program.steps;
    if (!at.section.isNull()) {
        const ProgramStep* section = findStep(program.steps, at.section);
        if (section == nullptr) {
            return program;
        }
        there = &section->steps;
    }
    StepPosition place = at;
    for (int i = 0; i < std::min(at.row, static_cast<int>(there->size())); ++i) {
        place.row -= ids.contains((*there)[static_cast<std::size_t>(i)].id) ? 1 : 0;
    }
    const Program without = withoutSteps(program, ids);
    Program result = withSteps(without, place, moved);
    return result == without ? program : result;
}

StepPosition positionBehind(const Program& program, const QUuid& id) {
    const ProgramStep* step = findStep(program.steps, id);
    if (step == nullptr) {
        return {{}, static_cast<int>(program.steps.size())};
    }
    const StepKind* kind = findStepKind(step->kind);
    if (kind != nullptr && kind->isSection && step->steps.empty()) {
        return {id, 0};
    }
    const auto at = positionOf(program, id);
    return {at->section, at->row + 1};
}

Program withShifted(const Program& program, const QSet<QUuid>& ids, int direction) {
    const Steps selected = selectedSteps(program, ids);
    if (selected.empty()) {
        return program;
    }
    const auto at = positionOf(program, direction < 0 ? selected.front().id : selected.back().id);
    const int row = direction < 0 ? at->row - 1 : at->row + 2;
    return row < 0 ? program : withMovedSteps(program, ids, {at->section, row});
}

Program withNested(const Program& program, const QSet<QUuid>& ids) {
    const Steps selected = selectedSteps(program, ids);
    const auto at = selected.empty() ? std::nullopt : positionOf(program, selected.front().id);
    if (!at || at->row == 0) {
        return program;
    }
    const Steps& siblings =
        at->section.isNull() ? program.steps : findStep(program.steps, at->section)->steps;
    const ProgramStep& above = siblings[static_cast<std::size_t>(at->row - 1)];
    return withMovedSteps(program, ids, {above.id, static_cast<int>(above.steps.size())});
}

Program withUnnested(const Program& program, const QSet<QUuid>& ids) {
    const Steps selected = selectedSteps(program, ids);
    const auto at = selected.empty() ? std::nullopt : positionOf(program, selected.front().id);
    if (!at || at->section.isNull()) {
        return program;
    }
    const auto section = positionOf(program, at->section);
    return withMovedSteps(program, ids, {section->section, section->row + 1});
}

Program withDuplicates(const Program& program, const QSet<QUuid>& ids) {
    const Steps selected = selectedSteps(program, ids);
    const auto last = selected.empty() ? std::nullopt : positionOf(program, selected.back().id);
    return last ? withSteps(program, {last->section, last->row + 1}, withNewIds(selected)) : program;
}

Program withDisabled(Program program, const QSet<QUuid>& ids, bool disabled) {
    for (const QUuid& id : ids) {
        if (ProgramStep* step = stepIn(program.steps, id)) {
            step->disabled = disabled;
        }
    }
    return program;
}

Program withField(Program program, const QUuid& id, const QString& key, const QJsonValue& value) {
    if (ProgramStep* step = stepIn(program.steps, id)) {
        if (value.isUndefined()) {
            step->fields.remove(key);
        } else {
            step->fields.insert(key, value);
        }
    }
    return program;
}

QByteArray textOf(const Steps& steps) {
    // Use the file format of a project with one program, so that only one reader and one writer for steps are
    // needed.
    project::Project carrier;
    Program program;
    program.id = QUuid::createUuid();
    program.name = QStringLiteral("steps");
    program.steps = steps;
    carrier.programs.append(program);
    const Result<QByteArray> bytes = project::serializeProject(carrier);
    if (!bytes) {
        return {};
    }
    const QJsonObject root = QJsonDocument::fromJson(*bytes).object();
    const QJsonArray entries = root["programs"].toArray()[0].toObject()["steps"].toArray();
    return QJsonDocument(QJsonObject{{"tillerSteps", entries}}).toJson();
}

std::optional<Steps> stepsFromText(const QByteArray& text) {
    const QJsonArray entries = QJsonDocument::fromJson(text).object()["tillerSteps"].toArray();
    if (entries.isEmpty()) {
        return std::nullopt;
    }
    const QJsonObject program{
        {"id", QUuid::createUuid().toString(QUuid::WithoutBraces)}, {"name", "steps"}, {"steps", entries}};
    const QJsonObject root{{"format", "tiller-project"},
                           {"version", project::kProjectFileVersion},
                           {"waypoints", QJsonArray()},
                           {"programs", QJsonArray{program}}};
    const Result<project::Project> read = project::parseProject(QJsonDocument(root).toJson());
    return read && !read->programs.isEmpty() ? std::optional(withNewIds(read->programs.at(0).steps))
                                             : std::nullopt;
}

QString summaryOf(const project::Project& project, const ProgramStep& step) {
    const StepKind* kind = findStepKind(step.kind);
    if (kind == nullptr) {
        return {};
    }
    QStringList values;
    for (const StepField& field : kind->fields()) {
        const QJsonValue value = fieldValue(step, field);
        const bool isDefault =
            field.type == FieldType::Number && value == field.initial && field.initial == QJsonValue(0);
        if (!value.isUndefined() && !value.isNull() && !isDefault) {
            values.append(valueText(project, field, value));
        }
    }
    values.removeAll(QString());
    return values.join(QStringLiteral(", "));
}

QString kindName(const ProgramStep& step) {
    const StepKind* kind = findStepKind(step.kind);
    return kind != nullptr ? kind->name() : step.kind;
}

QString stepName(const project::Project& project, const ProgramScript& script, int number) {
    if (number < 1 || number > static_cast<int>(script.steps.size())) {
        return {};
    }
    const NumberedStep& numbered = script.steps[static_cast<std::size_t>(number - 1)];
    const Program* owner = project.programs.find(numbered.program);
    const ProgramStep* step = owner != nullptr ? findStep(owner->steps, numbered.step) : nullptr;
    return step != nullptr ? kindName(*step) : QString();
}

int rowNumber(const project::Project& project, const ProgramScript& script, int number) {
    if (number < 1 || number > static_cast<int>(script.steps.size())) {
        return number;
    }
    const NumberedStep& numbered = script.steps[static_cast<std::size_t>(number - 1)];
    const Program* owner = project.programs.find(numbered.program);
    if (owner == nullptr || numbered.program != script.steps.front().program) {
        return number;
    }
    int row = 0;
    const std::function<bool(const Steps&)> reaches = [&](const Steps& steps) {
        return std::any_of(steps.begin(), steps.end(), [&](const ProgramStep& step) {
            ++row;
            return step.id == numbered.step || reaches(step.steps);
        });
    };
    return reaches(owner->steps) ? row : number;
}

std::vector<std::pair<QJsonValue, QString>> choicesOf(const project::Project& project,
                                                      const StepField& field) {
    constexpr int kChannels = 18;
    std::vector<std::pair<QJsonValue, QString>> choices;
    const auto addAll = [&](const auto& list) {
        for (const auto& entity : list) {
            choices.emplace_back(entity.id.toString(QUuid::WithoutBraces), entity.name);
        }
    };
    switch (field.type) {
        case FieldType::Choice:
            for (const Choice& choice : field.choices) {
                choices.emplace_back(QString::fromLatin1(choice.key), choice.label);
            }
            break;
        case FieldType::DigitalInput:
        case FieldType::DigitalOutput:
            for (int channel = 0; channel < kChannels; ++channel) {
                choices.emplace_back(channel, channelName(channel, field.type == FieldType::DigitalOutput));
            }
            break;
        case FieldType::Group:
            for (const project::Waypoint& point : project.waypoints) {
                const std::pair<QJsonValue, QString> group{point.group, point.group};
                if (!point.group.isEmpty() &&
                    std::find(choices.begin(), choices.end(), group) == choices.end()) {
                    choices.push_back(group);
                }
            }
            break;
        case FieldType::Waypoint:
            addAll(project.waypoints);
            break;
        case FieldType::Pattern:
            addAll(project.patterns);
            break;
        case FieldType::Frame:
            addAll(project.frames);
            break;
        case FieldType::Tool:
            addAll(project.tooling.tools);
            break;
        case FieldType::Payload:
            addAll(project.tooling.payloads);
            break;
        case FieldType::Program:
            addAll(project.programs);
            break;
        case FieldType::Number:
        case FieldType::Whole:
        case FieldType::Flag:
        case FieldType::Text:
        case FieldType::Lines:
        case FieldType::Expression:
        case FieldType::Variable:
            break;
    }
    return choices;
}

}  // namespace tiller::program
