// SPDX-License-Identifier: MIT
#include "robot/station/program/run/run_variables.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "robot/core/typed_number.h"
#include "robot/station/program/program_text.h"

namespace tiller::program {

using script::GateVariable;
using script::ProgramVariable;

namespace {

constexpr std::uint64_t kConfirmStates = 20;  // a robot sends ten states per second

/// The typed value; an error sentence if it does not fit the type.
Result<double> typedValue(GateVariable::Type type, const QString& text) {
    const std::optional<double> number = typedNumber(text);
    const auto wrong = [](const QString& why) { return Error{ErrorCode::InvalidArgument, why, {}}; };
    switch (type) {
        case GateVariable::Type::Number:
            if (number && std::isfinite(*number)) {
                return *number;
            }
            return wrong(ProgramText::tr("“%1” is not a number. Enter a number.").arg(text));
        case GateVariable::Type::Whole: {
            using Limits = std::numeric_limits<std::int32_t>;
            if (number && *number == std::floor(*number) && *number >= Limits::min() &&
                *number <= Limits::max()) {
                return *number;
            }
            return wrong(
                ProgramText::tr("“%1” is not a whole number. Enter a number without decimals.").arg(text));
        }
        case GateVariable::Type::Flag:
            for (const auto& [word, value] : {std::pair("True", 1.0), std::pair("False", 0.0)}) {
                if (text.trimmed().compare(QLatin1String(word), Qt::CaseInsensitive) == 0) {
                    return value;
                }
            }
            return wrong(ProgramText::tr("“%1” is not True or False. Enter one of these values.").arg(text));
    }
    return 0.0;
}

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

Result<script::VariableChange> RunVariables::change(const QString& name, const QString& text) {
    const ProgramVariable* variable = find(name);
    const auto type = changeableType(name);
    if (variable == nullptr || !type) {
        return Error{ErrorCode::InvalidArgument,
                     variable == nullptr ? ProgramText::tr("The program has no variable “%1”.").arg(name)
                                         : fixedReason(*variable),
                     {}};
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
