// SPDX-License-Identifier: MIT
#include "robot/station/program/detail/script_builder.h"

#include <QRegularExpression>
#include <algorithm>
#include <cmath>

#include "robot/project/reachability.h"
#include "robot/script/supervised_program.h"
#include "robot/station/program/expression.h"
#include "robot/station/program/program_edit.h"
#include "robot/station/program/program_text.h"
#include "robot/station/program/variable_value.h"

namespace tiller::program {

using project::ProgramStep;

namespace {

constexpr int kMaxCallDepth = 20;
constexpr int kSignificantDigits = 10;

const char* initialValue(VariableType type) {
    switch (type) {
        case VariableType::Number:
            return "0.0";
        case VariableType::Whole:
            return "0";
        case VariableType::Flag:
            return "False";
        case VariableType::Text:
            return "\"\"";
        case VariableType::Pose:
            return "p[0, 0, 0, 0, 0, 0]";
    }
    return "0";
}

/// Type of a variable whose value can be changed during a run. Empty for all other types.
std::optional<script::GateVariable::Type> gateType(VariableType type) {
    using Type = script::GateVariable::Type;
    switch (type) {
        case VariableType::Number:
            return Type::Number;
        case VariableType::Whole:
            return Type::Whole;
        case VariableType::Flag:
            return Type::Flag;
        case VariableType::Text:
        case VariableType::Pose:
            break;
    }
    return std::nullopt;
}

RobotModelId modelOf(const project::Project& project, const ScriptOptions& options) {
    return options.model.value_or(project.robot.value_or(RobotModelId::UR5e));
}

template <class List>
bool hasEntity(const List& list, const QUuid& id) {
    return list.find(id) != nullptr;
}

bool isInProject(const project::Project& project, FieldType type, const QUuid& id) {
    switch (type) {
        case FieldType::Waypoint:
            return project.waypoints.indexOf(id) >= 0;
        case FieldType::Pattern:
            return hasEntity(project.patterns, id);
        case FieldType::Frame:
            return hasEntity(project.frames, id);
        case FieldType::Tool:
            return hasEntity(project.tooling.tools, id);
        case FieldType::Payload:
            return hasEntity(project.tooling.payloads, id);
        case FieldType::Program:
            return hasEntity(project.programs, id);
        default:
            return false;
    }
}

}  // namespace

// ---- numbers, poses and terminals as text ---------------------------------------------------------------

QString scriptNumber(double value) {
    return QString::number(value == 0 ? 0.0 : value, 'g', kSignificantDigits);
}

namespace {
QString numberList(const std::array<double, 6>& values) {
    QStringList texts;
    for (const double value : values) {
        texts.append(scriptNumber(value));
    }
    return QStringLiteral("[%1]").arg(texts.join(QStringLiteral(", ")));
}
}  // namespace

QString scriptPose(const Pose& pose) {
    return QLatin1Char('p') + numberList(pose.array());
}
QString scriptJoints(const JointPositions& q) {
    return numberList(q.array());
}
QString scriptFlag(bool value) {
    return value ? QStringLiteral("True") : QStringLiteral("False");
}

namespace {
struct Terminal {
    const char* group;
    int pin;
};
Terminal terminalOf(int channel) {
    constexpr int kFirstConfigurablePin = 8;
    constexpr int kFirstToolPin = 16;
    return channel < kFirstConfigurablePin ? Terminal{"standard", channel}
           : channel < kFirstToolPin       ? Terminal{"configurable", channel - kFirstConfigurablePin}
                                           : Terminal{"tool", channel - kFirstToolPin};
}
}  // namespace

QString inputCall(int channel) {
    const Terminal terminal = terminalOf(channel);
    return QStringLiteral("get_%1_digital_in(%2)").arg(QLatin1String(terminal.group)).arg(terminal.pin);
}
QString outputCall(int channel, bool value) {
    const Terminal terminal = terminalOf(channel);
    return QStringLiteral("set_%1_digital_out(%2, %3)")
        .arg(QLatin1String(terminal.group))
        .arg(terminal.pin)
        .arg(scriptFlag(value));
}

// ---- the builder ----------------------------------------------------------------------------------------

StepWriter::Private::Private(const project::Project& wholeProject, const ScriptOptions& scriptOptions)
    : project(wholeProject)
    , options(scriptOptions)
    , model(robotModel(modelOf(wholeProject, scriptOptions))) {}

void StepWriter::Private::numberSteps(const project::Program& owner, const Steps& steps) {
    for (const ProgramStep& step : steps) {
        result.steps.push_back({owner.id, step.id});
        numbers.insert({owner.id, step.id}, static_cast<int>(result.steps.size()));
        numberSteps(owner, step.steps);
    }
}

void StepWriter::Private::report(const QString& fieldKey, const QString& text) {
    ProgramProblem problem;
    problem.program = program ? program->id : QUuid();
    problem.step = place.step ? place.step->id : QUuid();
    problem.number = place.step ? numberOf(*place.step) : 0;
    problem.field = fieldKey;
    problem.text = text;
    // A called program is written once per scope, so the same problem can be found twice.
    if (std::find(result.problems.begin(), result.problems.end(), problem) == result.problems.end()) {
        result.problems.push_back(std::move(problem));
    }
}

const StepField* StepWriter::Private::field(const char* key) const {
    const auto found = std::find_if(
        place.fields.begin(), place.fields.end(),
        [&](const StepField& candidate) { return QLatin1String(candidate.key) == QLatin1String(key); });
    return found == place.fields.end() ? nullptr : &*found;
}

QJsonValue StepWriter::Private::value(const char* key) const {
    const StepField* found = field(key);
    return found != nullptr ? fieldValue(*place.step, *found) : QJsonValue(QJsonValue::Undefined);
}

QString StepWriter::Private::fieldError(const StepField& checked) const {
    const QJsonValue given = fieldValue(*place.step, checked);
    const QString text = given.toString();
    if (given.isUndefined() || given.isNull() || (given.isString() && text.isEmpty())) {
        return checked.optional
                   ? QString()
                   : ProgramText::tr("“%1” is not set. Select or enter a value.").arg(checked.label);
    }
    const QString wrong =
        ProgramText::tr("“%1” has an invalid value. Enter a different value.").arg(checked.label);
    switch (checked.type) {
        case FieldType::Number:
        case FieldType::Whole: {
            const double number = given.toDouble(std::numeric_limits<double>::quiet_NaN());
            if (!std::isfinite(number) ||
                (checked.type == FieldType::Whole && number != std::floor(number))) {
                return wrong;
            }
            if (number < checked.minimum || number > checked.maximum) {
                return ProgramText::tr("“%1” is %2. The value must be between %3 and %4.")
                    .arg(checked.label, numberText(number, checked.unit),
                         numberText(checked.minimum, checked.unit),
                         numberText(checked.maximum, checked.unit));
            }
            return {};
        }
        case FieldType::DigitalInput:
        case FieldType::DigitalOutput: {
            constexpr int kLastChannel = 17;
            const double number = given.toDouble(-1);
            return number == std::floor(number) && number >= 0 && number <= kLastChannel ? QString() : wrong;
        }
        case FieldType::Flag:
            return given.isBool() ? QString() : wrong;
        case FieldType::Choice:
            return std::any_of(checked.choices.begin(), checked.choices.end(),
                               [&](const Choice& choice) { return text == QLatin1String(choice.key); })
                       ? QString()
                       : wrong;
        case FieldType::Text:
        case FieldType::Lines:
            return given.isString() ? QString() : wrong;
        case FieldType::Expression:
            return given.isString() ? parseExpression(text).error : wrong;
        case FieldType::Variable: {
            QString why;
            isVariableName(text, &why);
            return given.isString() ? why : wrong;
        }
        case FieldType::Group:
            return std::any_of(project.waypoints.begin(), project.waypoints.end(),
                               [&](const project::Waypoint& point) { return point.group == text; })
                       ? QString()
                       : ProgramText::tr(
                             "The group “%1” contains no waypoints. Add waypoints to the group, or select a "
                             "different group.")
                             .arg(text);
        case FieldType::Waypoint:
        case FieldType::Pattern:
        case FieldType::Frame:
        case FieldType::Tool:
        case FieldType::Payload:
        case FieldType::Program:
            return isInProject(project, checked.type, QUuid(text))
                       ? QString()
                       : ProgramText::tr(
                             "“%1” refers to an item that was deleted from the project. Select a different "
                             "item.")
                             .arg(checked.label);
    }
    return wrong;
}

bool StepWriter::Private::checkFields() {
    bool good = true;
    for (const StepField& checked : place.fields) {
        if (const QString why = fieldError(checked); !why.isEmpty()) {
            report(QLatin1String(checked.key), why);
            good = false;
        }
    }
    return good;
}

std::ptrdiff_t StepWriter::Private::neighbour(int direction) const {
    const auto size = static_cast<std::ptrdiff_t>(place.siblings->size());
    for (auto at = static_cast<std::ptrdiff_t>(place.index) + direction; at >= 0 && at < size;
         at += direction) {
        const ProgramStep& candidate = (*place.siblings)[static_cast<std::size_t>(at)];
        if (!candidate.disabled && candidate.kind != QLatin1String("comment")) {
            return at;
        }
    }
    return -1;
}

void StepWriter::Private::checkPosition() {
    const StepKind& kind = *place.kind;
    if (!kind.follows.empty()) {
        const std::ptrdiff_t before = neighbour(-1);
        const QString kindBefore =
            before < 0 ? QString() : (*place.siblings)[static_cast<std::size_t>(before)].kind;
        if (std::none_of(kind.follows.begin(), kind.follows.end(),
                         [&](const char* id) { return kindBefore == QLatin1String(id); })) {
            report({}, ProgramText::tr("“%1” must come directly after “%2”.")
                           .arg(kind.name(), findStepKind(QLatin1String(kind.follows.front()))->name()));
        }
    }
    if (*kind.inside != '\0' && QLatin1String(place.parentKind) != QLatin1String(kind.inside)) {
        report({}, ProgramText::tr("“%1” must be inside “%2”.")
                       .arg(kind.name(), findStepKind(QLatin1String(kind.inside))->name()));
    }
    if (kind.moves && scope.isParallel) {
        report({},
               ProgramText::tr(
                   "Steps in “Watch in parallel” cannot move the arm. Move this step out of the section."));
    }
    if (!kind.isSection && !place.step->steps.empty()) {
        report({}, ProgramText::tr("“%1” cannot contain steps. Move its steps to another section.")
                       .arg(kind.name()));
    }
}

void StepWriter::Private::writeStep() {
    place.kind = findStepKind(place.step->kind);
    if (place.kind == nullptr) {
        report(
            {},
            ProgramText::tr(
                "This version of Tiller does not support the step “%1”. Update Tiller, or delete the step.")
                .arg(place.step->kind));
        return;
    }
    place.fields = place.kind->fields();
    checkPosition();
    const bool good = checkFields();
    StepWriter writer(*this);
    if (place.kind->group != StepGroup::Motion && !place.kind->isMarker) {
        lastMove = {};
    }
    if (!place.kind->isMarker) {
        writer.mark();
    }
    if (good) {
        place.kind->write(writer);
    } else {
        writer.steps();  // report the problems of these steps as well
    }
    if (place.kind->isSection) {
        lastMove = {};
    }
}

void StepWriter::Private::writeSteps(const Steps& steps) {
    const Place outer = place;
    const char* parentKind = outer.kind != nullptr && outer.step != nullptr ? outer.kind->id : "";
    const int parent = outer.step != nullptr ? numberOf(*outer.step) : 0;
    for (std::size_t i = 0; i < steps.size(); ++i) {
        if (!steps[i].disabled) {
            place = {&steps[i], nullptr, {}, &steps, i, parent, parentKind};
            writeStep();
        }
    }
    place = outer;
}

void StepWriter::Private::writeFrom(const project::Program& owner) {
    if (options.from.isNull()) {
        writeSteps(owner.steps);
        return;
    }
    const auto first = std::find_if(owner.steps.begin(), owner.steps.end(),
                                    [&](const ProgramStep& step) { return step.id == options.from; });
    const StepKind* kind = first == owner.steps.end() ? nullptr : findStepKind(first->kind);
    if (kind == nullptr || !kind->follows.empty()) {
        report({}, ProgramText::tr("A program can start only at a top-level step, and not at a branch such "
                                   "as Else. Select a different step."));
        return;
    }
    // Write the remaining steps as a separate list, which exists until the call returns.
    const Steps rest(first, owner.steps.end());
    writeSteps(rest);
    checkSkipped(Steps(owner.steps.begin(), first), rest);
}

void StepWriter::Private::addEffects(const Steps& steps, int caller, int depth,
                                     std::vector<Effect>& effects) const {
    for (const ProgramStep& step : steps) {
        const StepKind* kind = findStepKind(step.kind);
        if (step.disabled || kind == nullptr) {
            continue;
        }
        const int number = caller > 0 ? caller : numberOf(step);
        for (const StepField& field : kind->fields()) {
            const QString variable =
                field.type == FieldType::Variable ? fieldValue(step, field).toString() : QString();
            if (!variable.isEmpty()) {
                effects.push_back({number, variable});
            }
        }
        if (step.kind == QLatin1String("payload") || (step.kind == QLatin1String("watch") && caller == 0)) {
            effects.push_back({number, {}});
        }
        const project::Program* called =
            step.kind == QLatin1String("call")
                ? project.programs.find(QUuid(step.fields.value(QLatin1String("program")).toString()))
                : nullptr;
        if (called != nullptr && depth < kMaxCallDepth) {
            addEffects(called->steps, number, depth + 1, effects);
        }
        addEffects(step.steps, caller, depth, effects);
    }
}

/// Returns true if the first line that uses the variable does not set it at the top level of the program.
bool StepWriter::Private::usesBeforeSetting(const QString& variable) const {
    static const QRegularExpression kText(QStringLiteral("\"[^\"]*\"|#.*"));
    const QRegularExpression word(QStringLiteral("\\b%1\\b").arg(QRegularExpression::escape(variable)));
    const QString assignment = QStringLiteral("  global %1 = ").arg(variable);
    for (const Lines* part : {&functions, &main}) {
        for (const Line& line : *part) {
            const QString code = QString(line.text).remove(kText);
            if (code.contains(word)) {
                return !code.startsWith(assignment) || code.mid(assignment.size()).contains(word);
            }
        }
    }
    return false;
}

void StepWriter::Private::checkSkipped(const Steps& skipped, const Steps& rest) {
    std::vector<Effect> effects;
    addEffects(skipped, 0, 0, effects);
    const auto next = std::find_if(rest.begin(), rest.end(), [](const ProgramStep& step) {
        return !step.disabled && step.kind != QLatin1String("comment");
    });
    const bool setsPayload = next != rest.end() && next->kind == QLatin1String("payload");
    for (const Effect& effect : effects) {
        const NumberedStep& at = result.steps[static_cast<std::size_t>(effect.step - 1)];
        const ProgramStep* step = findStep(program->steps, at.step);
        const QString name = findStepKind(step->kind)->name();
        if (!effect.variable.isEmpty()) {
            if (usesBeforeSetting(effect.variable)) {
                report(
                    {},
                    ProgramText::tr(
                        "Later steps use the variable “%1” from step %2 (%3). Start at that step or earlier.")
                        .arg(effect.variable)
                        .arg(effect.step)
                        .arg(name));
            }
        } else if (!setsPayload || step->kind == QLatin1String("watch")) {
            report({}, ProgramText::tr("Later steps depend on step %1 (%2). Start at that step or earlier.")
                           .arg(effect.step)
                           .arg(name));
        }
    }
}

ProgramScript StepWriter::Private::write(const QUuid& id) {
    program = project.programs.find(id);
    if (program == nullptr) {
        report({}, ProgramText::tr("The project does not contain this program. Select a different program."));
        return result;
    }
    result.name =
        QStringLiteral("program_") + scriptName(program->name);  // must differ from the names of functions
    if (options.model && project.robot && *options.model != *project.robot) {
        report({}, ProgramText::tr("The project was taught with a %1, but the robot is a %2. Use “Adapt "
                                   "project to this robot…” first.")
                       .arg(QLatin1String(robotModel(*project.robot).name), QLatin1String(model.name)));
    }
    numberSteps(*program, program->steps);
    calls.append(program->id.toString());
    lines = &main;
    StepWriter writer(*this);
    if (const auto* tool = project.tooling.tools.find(project.tooling.activeTool)) {
        scope.tcp = tool->tcpOffset;
        add(QStringLiteral("set_tcp(%1)").arg(scriptPose(tool->tcpOffset)));
    }
    if (!program->parameters.isEmpty()) {
        report({}, ProgramText::tr("A program with parameters cannot be started directly. Use a “Call "
                                   "program” step in another program."));
    }
    writeFrom(*program);
    if (result.steps.empty()) {
        report({}, ProgramText::tr("The program has no steps. Add steps first."));
    }
    if (!result.problems.empty()) {
        return result;
    }
    QStringList text;
    const auto put = [&](const QString& line, int step) {
        text.append(line);
        result.stepOfLine.push_back(step);
    };
    put(QStringLiteral("def %1():").arg(result.name), 0);
    put(QStringLiteral("  # %1").arg(scriptComment(program->name)), 0);
    put(QStringLiteral("  # The number of the running step is in output_int_register_%1.").arg(kStepRegister),
        0);
    // A condition of a watch can call functions that URScript text defines.
    const auto uses = [&](QLatin1String kind) {
        return std::ranges::any_of(result.steps, [&](const NumberedStep& at) {
            const project::Program* owner = project.programs.find(at.program);
            const project::ProgramStep* step = owner != nullptr ? findStep(owner->steps, at.step) : nullptr;
            return step != nullptr && step->kind == kind;
        });
    };
    result.changesMayMove =
        result.changesMayMove || (uses(QLatin1String("watch")) && uses(QLatin1String("script")));
    for (const auto& [name, type] : variables) {
        if (const auto changed = gateType(type); changed && !result.changesMayMove) {
            result.variables.push_back({name, *changed});
        }
        result.declared.append(name);
        put(QStringLiteral("  global %1 = %2").arg(name, QLatin1String(initialValue(type))), 0);
    }
    for (const QString& helper : helpers) {
        for (const QString& line : helper.split(QLatin1Char('\n'), Qt::SkipEmptyParts)) {
            put(QStringLiteral("  ") + line, 0);
        }
    }
    for (const Lines* part : {&functions, &main}) {
        for (const Line& line : *part) {
            if (!line.gated.isEmpty()) {
                const bool isStep = line.gated.contains(QLatin1String("tiller_step"));
                result.gateLines.push_back(
                    {static_cast<std::size_t>(text.size()), line.gated, isStep ? line.step : 0});
            }
            put(line.text, line.step);
        }
    }
    put(QStringLiteral("  write_output_integer_register(%1, 0)").arg(kStepRegister), 0);
    put(QStringLiteral("end"), 0);
    result.text = text.join(QLatin1Char('\n')) + QLatin1Char('\n');
    return result;
}

// ---- functions for step kinds -------------------------------------------------------------------------

const ProgramStep& StepWriter::step() const {
    return *d_.place.step;
}
int StepWriter::number() const {
    return d_.numberOf(step());
}
int StepWriter::parentNumber() const {
    return d_.place.parent;
}
const StepKind* StepWriter::previous() const {
    const std::ptrdiff_t at = d_.neighbour(-1);
    return at < 0 ? nullptr : findStepKind((*d_.place.siblings)[static_cast<std::size_t>(at)].kind);
}
const StepKind* StepWriter::next() const {
    const std::ptrdiff_t at = d_.neighbour(1);
    return at < 0 ? nullptr : findStepKind((*d_.place.siblings)[static_cast<std::size_t>(at)].kind);
}

double StepWriter::number(const char* key) const {
    return d_.value(key).toDouble();
}
std::optional<double> StepWriter::given(const char* key) const {
    return has(key) ? std::optional(number(key)) : std::nullopt;
}
int StepWriter::whole(const char* key) const {
    return d_.value(key).toInt();
}
bool StepWriter::flag(const char* key) const {
    return d_.value(key).toBool();
}
QString StepWriter::text(const char* key) const {
    return d_.value(key).toString();
}
bool StepWriter::has(const char* key) const {
    const QJsonValue value = d_.value(key);
    return !value.isUndefined() && !value.isNull() && !(value.isString() && value.toString().isEmpty());
}
QString StepWriter::expression(const char* key) const {
    return parseExpression(text(key)).script;
}
QUuid StepWriter::id(const char* key) const {
    return QUuid(text(key));
}

const project::Project& StepWriter::project() const {
    return d_.project;
}
const RobotModel& StepWriter::model() const {
    return d_.model;
}
const SoftwareVersion& StepWriter::version() const {
    return d_.options.version;
}
const SpeedLimits& StepWriter::speedLimits() const {
    return d_.options.limits;
}
double StepWriter::toolSpeed(double speed) const {
    return std::min(speed * d_.scope.speedFactor, d_.options.limits.tool);
}
double StepWriter::jointSpeed(double speed) const {
    return std::min(speed * d_.scope.speedFactor, d_.options.limits.joint);
}
StepWriter::Scope& StepWriter::scope() {
    return d_.scope;
}

void StepWriter::line(const QString& text) {
    d_.add(text);
}
void StepWriter::open(const QString& text) {
    d_.add(text);
    ++d_.indent;
}
void StepWriter::close(const QString& text) {
    --d_.indent;
    if (!text.isEmpty()) {
        d_.add(text);
    }
}
void StepWriter::mark() {
    if (d_.scope.isParallel || d_.scope.isForce) {
        markReturn();
    } else {
        d_.add(QStringLiteral("write_output_integer_register(%1, %2)").arg(kStepRegister).arg(number()),
               QStringLiteral("tiller_step(%1)").arg(number()));
    }
}
void StepWriter::markReturn() {
    if (!d_.scope.isParallel) {
        d_.add(QStringLiteral("write_output_integer_register(%1, %2)").arg(kStepRegister).arg(number()));
    }
}
void StepWriter::countCycle(const QString& counter) {
    const QString count = QStringLiteral("%1 = %1 + 1").arg(counter);
    if (d_.scope.isParallel || d_.scope.isCycle) {
        d_.add(count);
        return;
    }
    d_.add(count, QStringLiteral("%1 = tiller_turn(%1 + 1)").arg(counter));
    d_.result.cycles.push_back(number());
}
void StepWriter::steps() {
    const bool wasTop = d_.scope.isTop;
    const bool setTcp = d_.scope.setsTcp;
    d_.scope.isTop = false;
    d_.lastMove = {};
    d_.writeSteps(step().steps);
    d_.scope.isTop = wasTop;
    d_.scope.setsTcp = setTcp;  // the section may not run
}

void StepWriter::inScope(const std::function<void()>& write) {
    const Scope before = d_.scope;
    write();
    d_.scope = before;
}

void StepWriter::function(const QString& header, const std::function<void()>& body) {
    Private::Lines own;
    Private::Lines* const outer = std::exchange(d_.lines, &own);
    const int outerIndent = std::exchange(d_.indent, 0);
    const Private::LastMove outerMove = std::exchange(d_.lastMove, {});
    open(header);
    inScope(body);
    close();
    d_.lines = outer;
    d_.indent = outerIndent;
    d_.lastMove = outerMove;
    d_.functions.insert(d_.functions.end(), own.begin(), own.end());
}

void StepWriter::require(const QString& name, const QString& definition) {
    d_.helpers.insert(name, definition);
}

void StepWriter::fail(const QString& text) {
    failWith(scriptString(text));
}

void StepWriter::failWith(const QString& message) {
    if (d_.scope.isFunction) {
        line(QStringLiteral("return %1").arg(message));
        return;
    }
    require(QStringLiteral("tiller_fail"),
            QStringLiteral("def tiller_fail(step, message):\n"
                           "  write_output_integer_register(%1, -step)\n"
                           "  textmsg(message)\n"
                           "  popup(message, title=%2, error=True, blocking=False)\n"
                           "  halt\n"
                           "end\n")
                .arg(kStepRegister)
                .arg(scriptString(d_.project.programs.find(QUuid(d_.calls.front()))->name)));
    line(QStringLiteral("tiller_fail(%1, %2)").arg(number()).arg(message));
}

void StepWriter::failIfChosen(const char* key, const QString& condition, const QString& text) {
    if (this->text(key) == QLatin1String("fail")) {
        open(QStringLiteral("if %1:").arg(condition));
        fail(text);
        close();
    }
}

void StepWriter::declare(const QString& variable, VariableType type) {
    const auto known = std::find_if(d_.variables.begin(), d_.variables.end(),
                                    [&](const auto& row) { return row.first == variable; });
    if (known == d_.variables.end()) {
        d_.variables.emplace_back(variable, type);
    } else if (known->second != type) {
        error("variable", ProgramText::tr("The variable “%1” has a different type elsewhere in the program. "
                                          "Use the same type or a different name.")
                              .arg(variable));
    }
}

QString StepWriter::programFunction(const QUuid& id) {
    const project::Program* called = project().programs.find(id);
    const QString key = id.toString();
    if (d_.calls.contains(key)) {
        error("program", ProgramText::tr("A program cannot call itself. Select a different program."));
        return {};
    }
    if (d_.calls.size() > kMaxCallDepth) {
        error("program", ProgramText::tr("Program calls are nested too deeply. Use fewer levels of calls."));
        return {};
    }
    const QString variant = key + scriptNumber(d_.scope.speedFactor) + scriptPose(d_.scope.T_base_frame) +
                            (d_.scope.tcp ? scriptPose(*d_.scope.tcp) : QString()) +
                            (d_.scope.setsTcp ? QStringLiteral("tcp") : QString()) +
                            (d_.scope.isParallel ? QStringLiteral("parallel") : QString()) +
                            (d_.scope.isForce ? QStringLiteral("force") : QString()) +
                            (d_.scope.isCycle ? QStringLiteral("cycle") : QString());
    if (const QString known = d_.callFunctions.value(variant); !known.isEmpty()) {
        return known;
    }
    const QString name =
        QStringLiteral("tiller_call_%1_%2").arg(d_.callFunctions.size() + 1).arg(scriptName(called->name));
    d_.callFunctions.insert(variant, name);
    const Private::Place place = d_.place;
    const project::Program* const caller = std::exchange(d_.program, called);
    d_.calls.append(key);
    if (!called->steps.empty() && !d_.numbers.contains({called->id, called->steps.front().id})) {
        d_.numberSteps(*called, called->steps);
    }
    d_.place = {};
    for (const QString& parameter : called->parameters) {
        if (QString why; !isVariableName(parameter, &why)) {
            d_.report({}, why);
        }
    }
    function(QStringLiteral("def %1(%2):").arg(name, called->parameters.join(QStringLiteral(", "))), [&] {
        d_.scope.isFunction = true;
        d_.scope.isTop = false;
        d_.scope.loops = 0;
        d_.writeSteps(called->steps);
        d_.place = {};
        d_.add(QStringLiteral("return \"\""));
    });
    d_.calls.removeLast();
    d_.program = caller;
    d_.place = place;
    return name;
}

void StepWriter::waitUntil(const QString& condition, std::optional<double> limit) {
    if (!limit) {
        open(QStringLiteral("while not (%1):").arg(condition));
        line(QStringLiteral("sync()"));
        close();
        return;
    }
    const QString waited = QStringLiteral("tiller_waited_%1").arg(number());
    line(QStringLiteral("%1 = 0.0").arg(waited));
    open(QStringLiteral("while not (%1) and %2 < %3:").arg(condition, waited, scriptNumber(*limit)));
    line(QStringLiteral("sync()"));
    line(QStringLiteral("%1 = %1 + %2").arg(waited, script::stepTimeText(version())));
    close();
}

std::optional<Pose> StepWriter::tcpFor(const project::Waypoint& waypoint, const char* key) {
    if (d_.scope.tcp) {
        return d_.scope.tcp;
    }
    if (d_.scope.setsTcp) {
        return waypoint
            .tcpOffset;  // the TCP in the text is not known, and the operator is responsible for it
    }
    if (!d_.result.tcp) {
        d_.result.tcp = waypoint.tcpOffset;
    } else if (!(d_.result.tcp->transform().isApprox(waypoint.tcpOffset.transform(), 1e-6))) {
        error(key, ProgramText::tr("“%1” was taught with a different TCP than the waypoints before it. Set "
                                   "the active TCP, or put the step in a TCP section.")
                       .arg(waypoint.name));
    }
    return d_.result.tcp;
}

void StepWriter::noteMove(const std::optional<Pose>& target, double blend) {
    const Private::LastMove last = std::exchange(d_.lastMove, {target, blend});
    if (!last.target || !target) {
        return;
    }
    const double distance = (last.target->position - target->position).norm();
    if (last.blend > 0 && last.blend + blend > distance) {
        error("blend",
              ProgramText::tr("The blend radii of this move and the previous move (%1 and %2) exceed the "
                              "distance of %3 between the two targets. Reduce a blend radius.")
                  .arg(numberText(blend, Unit::Length), numberText(last.blend, Unit::Length),
                       numberText(distance, Unit::Length)));
    }
}

void StepWriter::noteOwnThread() {
    d_.result.changesMayMove = true;
}

void StepWriter::error(const char* key, const QString& text) {
    d_.report(QLatin1String(key), text);
}

// ---- the program ----------------------------------------------------------------------------------------

namespace {

/// The assignment as URScript; an error sentence if it is not possible.
Result<QString> assignmentText(const ProgramScript& script, const StepAssignment& assignment) {
    const auto wrong = [](const QString& why) { return Error{ErrorCode::InvalidArgument, why, {}}; };
    const auto variable =
        std::ranges::find(script.variables, assignment.variable, &script::GateVariable::name);
    if (variable == script.variables.end()) {
        return wrong(
            script.changesMayMove
                ? ProgramText::tr("A URScript step in this program could move the arm after a change.")
            : script.declared.contains(assignment.variable)
                ? ProgramText::tr("Only numbers and True or False values can be changed.")
                : ProgramText::tr("The program has no variable “%1”.").arg(assignment.variable));
    }
    if (!script.canPauseBefore(assignment.step)) {
        return wrong(ProgramText::tr("The program cannot pause before this step. Select a different step."));
    }
    const Result<double> value = typedValue(variable->type, assignment.value);
    return value ? Result<QString>(QStringLiteral("global %1 = %2")
                                       .arg(variable->name, scriptValue(variable->type, *value)))
                 : value.error();
}

/// Inserts the text as a line after each line that marks the step.
void insertAfterMark(ProgramScript& script, const QUuid& step, const QString& inserted) {
    QStringList lines = script.text.split(QLatin1Char('\n'));
    std::size_t added = 0;
    for (ProgramScript::GateLine& gate : script.gateLines) {
        gate.line += added;
        if (gate.step > 0 && script.steps[static_cast<std::size_t>(gate.step - 1)].step == step) {
            const QString& mark = lines.at(static_cast<qsizetype>(gate.line));
            const auto isSpace = [](QChar letter) { return letter.isSpace(); };
            const auto indent = std::find_if_not(mark.begin(), mark.end(), isSpace) - mark.begin();
            const auto next = static_cast<std::ptrdiff_t>(gate.line) + 1;
            lines.insert(next, mark.first(indent) + inserted);
            script.stepOfLine.insert(script.stepOfLine.begin() + next, gate.step);
            ++added;
        }
    }
    script.text = lines.join(QLatin1Char('\n'));
}

}  // namespace

ProgramScript writeScript(const project::Project& project, const QUuid& program,
                          const ScriptOptions& options) {
    ProgramScript script = StepWriter::Private(project, options).write(program);
    if (!script.ok()) {
        return script;
    }
    // Insert the lines in reverse order, because each line is inserted directly after the mark.
    for (auto assignment = options.assignments.rbegin(); assignment != options.assignments.rend();
         ++assignment) {
        if (const Result<QString> text = assignmentText(script, *assignment)) {
            insertAfterMark(script, assignment->step, *text);
        } else {
            ProgramProblem problem;
            problem.program = program;
            problem.step = assignment->step;
            problem.number = script.numberOf(assignment->step);
            problem.text = text.error().context;
            script.problems.push_back(std::move(problem));
        }
    }
    if (!script.problems.empty()) {
        script.text.clear();
    }
    return script;
}

QString ProgramScript::gatedText(const QSet<QUuid>& breakpoints) const {
    QStringList lines = text.split(QLatin1Char('\n'));
    for (const GateLine& gate : gateLines) {
        QString& line = lines[static_cast<qsizetype>(gate.line)];
        line = gate.text;
        if (gate.step > 0 && breakpoints.contains(steps[static_cast<std::size_t>(gate.step - 1)].step)) {
            line.replace(QLatin1String("tiller_step"), QLatin1String("tiller_break"));
        }
    }
    return lines.join(QLatin1Char('\n'));
}

bool ProgramScript::canPauseBefore(const QUuid& step) const {
    return std::any_of(gateLines.begin(), gateLines.end(), [&](const GateLine& gate) {
        return gate.step > 0 && steps[static_cast<std::size_t>(gate.step - 1)].step == step;
    });
}

int ProgramScript::numberOf(const QUuid& step) const {
    const auto found = std::find_if(steps.begin(), steps.end(),
                                    [&](const NumberedStep& candidate) { return candidate.step == step; });
    return found == steps.end() ? 0 : static_cast<int>(found - steps.begin()) + 1;
}

int ProgramScript::stepAt(int line) const {
    return line < 1 || line > static_cast<int>(stepOfLine.size())
               ? 0
               : stepOfLine[static_cast<std::size_t>(line - 1)];
}

}  // namespace tiller::program
