// SPDX-License-Identifier: MIT
#pragma once

// One field of a step kind: its type, range and unit, and its initial value. The file stores the value under
// `key`: numbers in SI units, references as ids, channels and choices as words.

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
    Variable,       ///< name of a variable set by the step
    DigitalInput,   ///< 0-7 standard, 8-15 configurable, 16-17 tool
    DigitalOutput,  ///< likewise
    Group,          ///< of waypoints, by its name
    // Ids of entities of the project:
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
    QJsonValue initial = {};  ///< in a new step, and if missing in the file
    bool optional = false;    ///< may be omitted, and then has no value
    Unit unit = Unit::None;
    double minimum = 0;
    double maximum = 0;
    std::vector<Choice> choices = {};
};

/// A typed text as a value of a field.
struct FieldInput {
    QJsonValue value = QJsonValue::Undefined;  ///< undefined: no value
    QString refusal;                           ///< translated, with the permitted range; empty: accepted
};
/// For number, text, expression and variable fields. Numbers are in the unit of the screen, with the decimal separator of
/// the language or a point.
FieldInput fieldInput(const StepField& field, const QString& text);
/// The text for an editor: the value in the unit of the screen, without the unit. Empty without a value.
QString editText(const StepField& field, const QJsonValue& value);

/// "DI 3", "CI 0", "TI 1"; with `output` "DO 3".
QString channelName(int channel, bool output);

double screenFactor(Unit unit);  ///< Converts an SI value to the display unit.
QString unitText(Unit unit);     ///< "mm/s"; empty for a dimensionless number.
/// A number in the display unit: "50 mm/s".
QString numberText(double value, Unit unit);

}  // namespace tiller::program
