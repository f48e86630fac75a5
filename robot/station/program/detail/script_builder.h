// SPDX-License-Identifier: MIT
#pragma once

// State of the script under construction. Private to robot/station/program.

#include <QHash>
#include <QMap>
#include <QSet>
#include <vector>

#include "robot/station/program/detail/step_writer.h"
#include "robot/station/program/program_script.h"

namespace tiller::program {

class StepWriter::Private {
public:
    Private(const project::Project& project, const ScriptOptions& options);

    ProgramScript write(const QUuid& program);

    struct Line {
        QString text;
        int step = 0;
        QString gated = {};  ///< text in a run with a step gate; empty: same as the text in other runs
    };
    using Lines = std::vector<Line>;
    struct LastMove {
        std::optional<Pose> target;
        double blend = 0;
    };
    using Steps = std::vector<project::ProgramStep>;
    /// The current step and its context.
    struct Place {
        const project::ProgramStep* step = nullptr;
        const StepKind* kind = nullptr;
        std::vector<StepField> fields;
        const Steps* siblings = nullptr;
        std::size_t index = 0;
        int parent = 0;
        const char* parentKind = "";
    };

    void add(const QString& text) {
        lines->push_back(
            {QString(2 * (indent + 1), QLatin1Char(' ')) + text, place.step ? numberOf(*place.step) : 0});
    }
    /// gated  text in a run with a step gate
    void add(const QString& text, const QString& gated) {
        add(text);
        lines->back().gated = QString(2 * (indent + 1), QLatin1Char(' ')) + gated;
    }
    int numberOf(const project::ProgramStep& step) const { return numbers.value({program->id, step.id}); }
    void numberSteps(const project::Program& program, const Steps& steps);
    void writeSteps(const Steps& steps);
    void writeStep();
    bool checkFields();
    QString fieldError(const StepField& field) const;
    void checkPosition();
    void report(const QString& field, const QString& text);
    /// Index of the previous (-1) or next (1) enabled sibling that is not a comment, or -1.
    std::ptrdiff_t neighbour(int direction) const;
    const StepField* field(const char* key) const;
    QJsonValue value(const char* key) const;
    void writeFrom(const project::Program& program);
    /// An effect of a step on later steps, outside of sections.
    struct Effect {
        int step = 0;      ///< number in the main program
        QString variable;  ///< variable set by the step; empty: payload or parallel watch
    };
    void addEffects(const Steps& steps, int caller, int depth, std::vector<Effect>& effects) const;
    bool usesBeforeSetting(const QString& variable) const;
    void checkSkipped(const Steps& skipped, const Steps& rest);

    const project::Project& project;
    const ScriptOptions options;
    const RobotModel& model;
    ProgramScript result;
    const project::Program* program = nullptr;  ///< program being written
    Lines main;
    Lines functions;
    QMap<QString, QString> helpers;
    std::vector<std::pair<QString, VariableType>> variables;
    QHash<std::pair<QUuid, QUuid>, int> numbers;  ///< step numbers by program and step ID
    QStringList calls;                            ///< IDs of the programs being written, main program first
    QHash<QString, QString> callFunctions;        ///< function names by program and scope
    Scope scope;
    Place place;
    Lines* lines = nullptr;
    int indent = 0;
    LastMove lastMove;
};

}  // namespace tiller::program
