// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli_program.h"

#include "robot/station/program/program_edit.h"

namespace tiller::app {

namespace {

Error noSuch(const QString& what) {
    return {ErrorCode::InvalidArgument, what, {}};
}

}  // namespace

Result<LoadedProgram> loadProgram(const QString& path, const QString& name, int fromStep,
                                  const std::vector<NumberedAssignment>& assignments) {
    Result<project::Project> project = project::loadProject(path);
    if (!project) {
        return project.error();
    }
    LoadedProgram loaded;
    loaded.project = std::move(*project);
    const project::ProgramList& programs = loaded.project.programs;
    QStringList names;
    for (const project::Program& program : programs) {
        names.append(program.name);
    }
    const project::Program* chosen =
        name.isEmpty() && programs.size() == 1 ? &programs.at(0) : programs.findByName(name);
    if (chosen == nullptr) {
        return noSuch(names.isEmpty()  ? QStringLiteral("%1 has no programs").arg(path)
                      : name.isEmpty() ? QStringLiteral("--program NAME is missing; %1 has: %2")
                                             .arg(path, names.join(QStringLiteral(", ")))
                                       : QStringLiteral("%1 has no program '%2'; it has: %3")
                                             .arg(path, name, names.join(QStringLiteral(", "))));
    }
    loaded.program = chosen->id;
    const program::ProgramScript whole = program::writeScript(loaded.project, loaded.program);
    const auto idOf = [&](int number, const char* option) -> Result<QUuid> {
        if (number < 1 || number > static_cast<int>(whole.steps.size())) {
            return noSuch(QStringLiteral("the program has %1 steps; use a smaller step number with %2")
                              .arg(whole.steps.size())
                              .arg(QLatin1String(option)));
        }
        return whole.steps[static_cast<std::size_t>(number - 1)].step;
    };
    if (fromStep > 0) {
        const Result<QUuid> first = idOf(fromStep, "--from");
        if (!first) {
            return first.error();
        }
        loaded.options.from = *first;
    }
    for (const NumberedAssignment& assignment : assignments) {
        const Result<QUuid> step = idOf(assignment.step, "--set");
        if (!step) {
            return step.error();
        }
        loaded.options.assignments.push_back({*step, assignment.variable, assignment.value});
    }
    loaded.script = program::writeScript(loaded.project, loaded.program, loaded.options);
    return loaded;
}

QString stepName(const LoadedProgram& loaded, int number) {
    return program::stepName(loaded.project, loaded.script, number);
}

QString problemText(const LoadedProgram& loaded, int step, const QString& text) {
    return step == 0 ? text : QStringLiteral("step %1 (%2): %3").arg(step).arg(stepName(loaded, step), text);
}

}  // namespace tiller::app
