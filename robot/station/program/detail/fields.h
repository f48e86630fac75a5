// SPDX-License-Identifier: MIT
#pragma once

// Field definitions shared by the step kinds. Private to robot/station/program.

#include "robot/station/program/program_text.h"
#include "robot/station/program/step_field.h"

namespace tiller::program {

inline constexpr double kMaxStepTime = 86'400;  ///< [s]

inline StepField numberField(const char* key, const QString& label, Unit unit, double minimum, double maximum,
                             double initial) {
    return {key, label, FieldType::Number, initial, false, unit, minimum, maximum, {}};
}
inline StepField optionalNumber(const char* key, const QString& label, Unit unit, double minimum,
                                double maximum) {
    return {key, label, FieldType::Number, {}, true, unit, minimum, maximum, {}};
}
inline StepField wholeField(const char* key, const QString& label, int minimum, int maximum, int initial) {
    return {key,
            label,
            FieldType::Whole,
            initial,
            false,
            Unit::None,
            static_cast<double>(minimum),
            static_cast<double>(maximum),
            {}};
}
inline StepField flagField(const char* key, const QString& label, bool initial) {
    return {key, label, FieldType::Flag, initial, false, Unit::None, 0, 0, {}};
}
inline StepField choiceField(const char* key, const QString& label, std::vector<Choice> choices) {
    const QString first = QString::fromLatin1(choices.front().key);
    return {key, label, FieldType::Choice, first, false, Unit::None, 0, 0, std::move(choices)};
}
/// A field without a range: a string, an expression, a channel or a reference.
inline StepField plainField(const char* key, const QString& label, FieldType type,
                            const QJsonValue& initial = {}, bool optional = false) {
    return {key, label, type, initial, optional, Unit::None, 0, 0, {}};
}
inline StepField optionalField(const char* key, const QString& label, FieldType type) {
    return plainField(key, label, type, {}, true);
}
inline StepField timeLimitField() {
    return optionalNumber("timeLimit", ProgramText::tr("Timeout"), Unit::Time, 0.01, kMaxStepTime);
}
/// Choice of the reaction if the step fails.
inline StepField otherwiseField(const QString& label) {
    return choiceField("otherwise", label,
                       {{"fail", ProgramText::tr("Fail")}, {"continue", ProgramText::tr("Continue")}});
}

}  // namespace tiller::program
