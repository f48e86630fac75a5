// SPDX-License-Identifier: MIT
#pragma once

// One field of a step kind: type, range, unit and initial value. The file stores the value under `key`:
// numbers in SI units, references as IDs, channels and choices as text.

#include <QJsonValue>
#include <QString>
#include <vector>

namespace tiller::program {

enum class FieldType {
    Number,         ///< `minimum` ... `maximum` in SI units
    Whole,          ///< an integer in the same range
    Flag,           ///< true or false
    Choice,         ///< the `key` of one of `choices`
    Text,           ///< one line
    Lines,          ///< several lines
    Expression,     ///< URScript, see expression.h
    Variable,       ///< name of the variable that the step sets
    DigitalInput,   ///< 0-7 standard, 8-15 configurable, 16-17 tool
    DigitalOutput,  ///< 0-7 standard, 8-15 configurable, 16-17 tool
    Group,          ///< name of a waypoint group
    // IDs of entities of the project:
    Waypoint,
    Pattern,
    Frame,
    Tool,
    Payload,
    Program,
};

enum class Unit {
    None,
    Length,
    Speed,
    Acceleration,
    Angle,
    AngularSpeed,
    AngularAcceleration,
    Time,
    Force,
    Percent
};

struct Choice {
    const char* key;
    QString label;
};

struct StepField {
    const char* key = "";
    QString label;
    FieldType type = FieldType::Text;
    QJsonValue initial = {};  ///< value in a new step, and default if missing in the file
    bool optional = false;    ///< the field may have no value
    Unit unit = Unit::None;
    double minimum = 0;
    double maximum = 0;
    std::vector<Choice> choices = {};
};

/// Entered text, converted to the value of a field.
struct FieldInput {
    QJsonValue value = QJsonValue::Undefined;  ///< undefined if there is no value
    QString refusal;                           ///< translated, with the permitted range; empty if valid
};
/// Converts the text of number, text, expression and variable fields. Numbers are in the display unit, with a
/// point or the decimal separator of the language.
FieldInput fieldInput(const StepField& field, const QString& text);
/// Text for an editor: the value in the display unit, without the unit. Empty without a value.
QString editText(const StepField& field, const QJsonValue& value);

/// Label of a channel, e.g. "DI 3", "CI 0", "TI 1", or "DO 3" if `output` is true.
QString channelName(int channel, bool output);

double screenFactor(Unit unit);  ///< Converts an SI value to the display unit.
QString unitText(Unit unit);     ///< e.g. "mm/s"; empty for a dimensionless number
/// A number with the display unit, e.g. "50 mm/s".
QString numberText(double value, Unit unit);

}  // namespace tiller::program
