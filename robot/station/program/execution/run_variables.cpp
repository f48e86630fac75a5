// SPDX-License-Identifier: MIT
#include "robot/station/program/execution/run_variables.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QRegularExpression>
#include <algorithm>
#include <utility>

#include "robot/station/program/program_text.h"
#include "robot/station/program/variable_value.h"

namespace tiller::program {

using script::GateVariable;
using script::ProgramVariable;

namespace {

constexpr std::uint64_t kConfirmStates = 20;  // a robot sends ten states per second

/// Numbers are published in single precision.
bool isValue(const ProgramVariable& published, GateVariable::Type type, double value) {
    return published.type != ProgramVariable::Type::None &&
           (type == GateVariable::Type::Number
                ? static_cast<float>(published.number) == static_cast<float>(value)
                : published.number == value);
}

/// True for a variable that Tiller adds to every program with a step gate.
bool isGateCounter(const ProgramVariable& variable) {
    return variable.name == QLatin1String("tiller_steps_begun");
}

bool isShown(const ProgramVariable& variable) {
    return !variable.name.startsWith(QLatin1String("tiller_")) ||
           variable.name == QLatin1String("tiller_error");
}

}  // namespace

QString typeName(ProgramVariable::Type type) {
    switch (type) {
        case ProgramVariable::Type::None:
            break;
        case ProgramVariable::Type::Flag:
            return ProgramText::tr("True or false");
        case ProgramVariable::Type::Whole:
            return ProgramText::tr("Whole number");
        case ProgramVariable::Type::Number:
            return ProgramText::tr("Number");
        case ProgramVariable::Type::Text:
            return ProgramText::tr("Text");
        case ProgramVariable::Type::Pose:
            return ProgramText::tr("Pose");
        case ProgramVariable::Type::List:
            return ProgramText::tr("List");
        case ProgramVariable::Type::Matrix:
            return ProgramText::tr("Matrix");
    }
    return {};
}

QJsonValue jsonValue(const ProgramVariable& variable) {
    static const QRegularExpression kNumbers(QStringLiteral("^p?(\\[[-+0-9.e, ]*\\])\\z"));
    switch (variable.type) {
        case ProgramVariable::Type::None:
            break;
        case ProgramVariable::Type::Flag:
            return variable.number != 0;
        case ProgramVariable::Type::Whole:
            return variable.number;
        case ProgramVariable::Type::Number:
            return variable.text.toDouble();  // without the digits that single precision adds
        case ProgramVariable::Type::Text:
            return variable.text.mid(1, variable.text.size() - 2);
        case ProgramVariable::Type::Pose:
        case ProgramVariable::Type::List:
        case ProgramVariable::Type::Matrix: {
            const QRegularExpressionMatch numbers = kNumbers.match(variable.text);
            return numbers.hasMatch()
                       ? QJsonValue(QJsonDocument::fromJson(numbers.captured(1).toUtf8()).array())
                       : QJsonValue(variable.text);
        }
    }
    return QJsonValue::Null;
}

void RunVariables::begin(const ProgramScript& script) {
    changeable_ = script.variables;
    changesMayMove_ = script.changesMayMove;
    isOther_ = false;
    published_.reset();
    list_.clear();
    changes_ = 0;
    pending_.reset();
}

bool RunVariables::follow(const script::ProgramVariables& published, std::uint64_t states) {
    states_ = states;
    if (!published || published == published_ ||
        std::none_of(published->begin(), published->end(), isGateCounter)) {
        return false;
    }
    return show(published);
}

bool RunVariables::followOther(const script::ProgramVariables& published) {
    if (published == published_ || (!published && !isOther_)) {
        return false;
    }
    begin({});
    isOther_ = published != nullptr;
    show(published);
    return true;
}

bool RunVariables::show(const script::ProgramVariables& published) {
    published_ = published;
    std::vector<ProgramVariable> shown;
    if (published) {
        std::copy_if(published->begin(), published->end(), std::back_inserter(shown), isShown);
    }
    const bool isNew = shown != list_;
    list_ = std::move(shown);
    return isNew;
}

const ProgramVariable* RunVariables::find(const QString& name) const {
    const auto found = std::find_if(list_.begin(), list_.end(),
                                    [&](const ProgramVariable& variable) { return variable.name == name; });
    return found == list_.end() ? nullptr : &*found;
}

std::optional<GateVariable::Type> RunVariables::changeableType(const QString& name) const {
    const auto found = std::find_if(changeable_.begin(), changeable_.end(),
                                    [&](const GateVariable& variable) { return variable.name == name; });
    return found == changeable_.end() ? std::nullopt : std::optional(found->type);
}

QString RunVariables::fixedReason(const ProgramVariable& variable) const {
    using Type = ProgramVariable::Type;
    const bool isSimple =
        variable.type == Type::Number || variable.type == Type::Whole || variable.type == Type::Flag;
    return isOther_ ? ProgramText::tr("The values of a program from another client cannot be changed.")
           : changesMayMove_
               ? ProgramText::tr("A URScript step in this program could move the arm after a change.")
           : !isSimple ? ProgramText::tr("Only numbers and True or False values can be changed.")
           : !changeableType(variable.name)
               ? ProgramText::tr(
                     "This variable is set by URScript text. Only variables of a “Set variable” step "
                     "can be changed.")
               : QString();
}

QString RunVariables::unconfirmedText() const {
    return pending_ ? ProgramText::tr("Wait until the robot has confirmed the new value of “%1”.")
                          .arg(pending_->name)
                    : QString();
}

QString RunVariables::changeObstacle(const ProgramVariable& variable, RunPhase program) const {
    const QString fixed = fixedReason(variable);
    return !fixed.isEmpty()                 ? fixed
           : program == RunPhase::NoProgram ? ProgramText::tr("No program is running.")
           : program == RunPhase::PausedOnRobot
               ? ProgramText::tr("The program is paused on the robot. Resume it on the teach pendant.")
           : program == RunPhase::Running ? ProgramText::tr("Pause the program first.")
           : states_ == 0
               ? ProgramText::tr(
                     "The robot does not report its variables. Wait until the connection is restored.")
               : unconfirmedText();
}

Result<script::VariableChange> RunVariables::change(const QString& name, const QString& text,
                                                    RunPhase program) {
    const ProgramVariable* variable = find(name);
    const QString obstacle = variable == nullptr
                                 ? ProgramText::tr("The program has no variable “%1”.").arg(name)
                                 : changeObstacle(*variable, program);
    const auto type = changeableType(name);
    if (!obstacle.isEmpty() || !type) {
        return Error{ErrorCode::InvalidArgument, obstacle, {}};
    }
    const Result<double> value = typedValue(*type, text);
    if (!value) {
        return value.error();
    }
    pending_ = {name, *type, variable->text, *value, states_};
    const auto index = std::find_if(changeable_.begin(), changeable_.end(),
                                    [&](const GateVariable& candidate) { return candidate.name == name; }) -
                       changeable_.begin();
    return script::VariableChange{++changes_, static_cast<std::int32_t>(index), *value};
}

std::optional<RunVariables::Outcome> RunVariables::takeOutcome() {
    if (!pending_) {
        return std::nullopt;
    }
    const ProgramVariable* variable = find(pending_->name);
    const bool isConfirmed = variable != nullptr && isValue(*variable, pending_->type, pending_->value);
    const bool isTooLate = states_ < pending_->since || states_ - pending_->since >= kConfirmStates;
    if (!isConfirmed && !isTooLate) {
        return std::nullopt;
    }
    const Pending ended = *std::exchange(pending_, std::nullopt);
    return isConfirmed
               ? Outcome{ProgramText::tr("Variable “%1”: %2 → %3")
                             .arg(ended.name, ended.before, variable->text),
                         true}
               : Outcome{ProgramText::tr(
                             "The robot did not confirm the new value of “%1”. Check the value in the list.")
                             .arg(ended.name),
                         false};
}

}  // namespace tiller::program
