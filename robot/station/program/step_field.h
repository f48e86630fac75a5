// SPDX-License-Identifier: MIT
#pragma once

// One field of a step kind: what values it takes, in which unit, and what a new step has there. The file holds the value
// under `key`: numbers in SI units, references as ids, channels and choices as words.

#include <QJsonValue>
#include <QString>
#include <vector>

namespace tiller::program {

enum class FieldType {
    Number,         ///< `minimum` ... `maximum` in SI units
    Whole,          ///< a whole number in the same range
    Flag,           ///< true or false
    Choice,         ///< the `key` of one of `choices`
    Text,           ///< one line
    Lines,          ///< several lines
    Expression,     ///< of URScript, see expression.h
    Variable,       ///< name of a variable that the step sets
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
    QJsonValue initial = {};  ///< of a new step, and where the file has nothing
    bool optional = false;    ///< may be left out, and then has no value
    Unit unit = Unit::None;
    double minimum = 0;
    double maximum = 0;
    std::vector<Choice> choices = {};
};

/// "DI 3", "CI 0", "TI 1"; with `output` "DO 3".
QString channelName(int channel, bool output);

double screenFactor(Unit unit);  ///< From the SI unit to the unit on the screen.
QString unitText(Unit unit);     ///< "mm/s"; empty for a plain number.
/// A number in the unit of the screen: "50 mm/s".
QString numberText(double value, Unit unit);

}  // namespace tiller::program
