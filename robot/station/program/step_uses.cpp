// SPDX-License-Identifier: MIT
#include "robot/station/program/step_uses.h"

#include <QHash>
#include <QJsonValue>
#include <QStringList>
#include <functional>

#include "robot/station/program/step_kind.h"

namespace tiller::program {

namespace {

/// Fields of a step kind that refer to waypoints.
struct WaypointFields {
    std::vector<QString> waypoints;
    std::vector<QString> groups;
};

WaypointFields waypointFields(const QString& id) {
    WaypointFields found;
    if (const StepKind* kind = findStepKind(id)) {
        for (const StepField& field : kind->fields()) {
            if (field.type == FieldType::Waypoint) {
                found.waypoints.push_back(QLatin1String(field.key));
            } else if (field.type == FieldType::Group) {
                found.groups.push_back(QLatin1String(field.key));
            }
        }
    }
    return found;
}

QHash<QUuid, QStringList> linesOfSteps(const ProgramScript& script) {
    QHash<QUuid, QStringList> lines;
    const QStringList text = script.text.split(QLatin1Char('\n'));
    for (std::size_t i = 0; i < script.stepOfLine.size(); ++i) {
        if (const int step = script.stepOfLine[i]; step > 0) {
            lines[script.steps[static_cast<std::size_t>(step - 1)].step].append(
                text.at(static_cast<qsizetype>(i)));
        }
    }
    return lines;
}

}  // namespace

int countUses(const project::Project& project, const project::Waypoint& waypoint) {
    // A program can have thousands of steps, but only a few kinds.
    QHash<QString, WaypointFields> kinds;
    int count = 0;
    const std::function<void(const std::vector<project::ProgramStep>&)> add =
        [&](const std::vector<project::ProgramStep>& steps) {
            for (const project::ProgramStep& step : steps) {
                auto kind = kinds.find(step.kind);
                if (kind == kinds.end()) {
                    kind = kinds.insert(step.kind, waypointFields(step.kind));
                }
                const auto refersTo = [&](const std::vector<QString>& keys, const auto& matches) {
                    return std::any_of(keys.begin(), keys.end(), [&](const QString& key) {
                        return matches(step.fields.value(key).toString());
                    });
                };
                const bool isUse =
                    refersTo(kind->waypoints,
                             [&](const QString& text) { return QUuid(text) == waypoint.id; }) ||
                    (!waypoint.group.isEmpty() &&
                     refersTo(kind->groups, [&](const QString& text) { return text == waypoint.group; }));
                count += isUse ? 1 : 0;
                add(step.steps);
            }
        };
    for (const project::Program& program : project.programs) {
        add(program.steps);
    }
    return count;
}

QSet<QUuid> changedSteps(const ProgramScript& before, const ProgramScript& after) {
    QSet<QUuid> changed;
    const QHash<QUuid, QStringList> old = linesOfSteps(before);
    const QHash<QUuid, QStringList> now = linesOfSteps(after);
    for (auto step = now.begin(); step != now.end(); ++step) {
        const auto same = old.find(step.key());
        if (same != old.end() && *same != *step) {
            changed.insert(step.key());
        }
    }
    return changed;
}

}  // namespace tiller::program
