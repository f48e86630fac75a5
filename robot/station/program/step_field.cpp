// SPDX-License-Identifier: MIT
#include "robot/station/program/step_field.h"

#include <QLocale>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "robot/core/typed_number.h"
#include "robot/station/program/program_text.h"

namespace tiller::program {
namespace {

constexpr int kFirstConfigurable = 8;
constexpr int kFirstTool = 16;
constexpr double kDegrees = 180.0 / std::numbers::pi;
constexpr double kMillimetres = 1000.0;

}  // namespace

FieldInput fieldInput(const StepField& field, const QString& text) {
    if (field.type != FieldType::Number && field.type != FieldType::Whole) {
        return {text, {}};
    }
    if (text.trimmed().isEmpty() && field.optional) {
        return {};
    }
    const std::optional<double> typed = typedNumber(text);
    const double number = typed.value_or(0) / screenFactor(field.unit);
    constexpr double kRounding = 1e-9;
    if (!typed || !(number >= field.minimum - kRounding && number <= field.maximum + kRounding) ||
        (field.type == FieldType::Whole && number != std::floor(number))) {
        return {QJsonValue::Undefined, ProgramText::tr("“%1” must be between %2 and %3.")
                                           .arg(field.label, numberText(field.minimum, field.unit),
                                                numberText(field.maximum, field.unit))};
    }
    return {std::clamp(number, field.minimum, field.maximum), {}};
}

QString editText(const StepField& field, const QJsonValue& value) {
    if (field.type != FieldType::Number && field.type != FieldType::Whole) {
        return value.toString();
    }
    QLocale locale;
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    return value.isDouble() ? locale.toString(value.toDouble() * screenFactor(field.unit), 'g', 8)
                            : QString();
}

QString channelName(int channel, bool output) {
    const char* group = channel < kFirstConfigurable ? "D" : channel < kFirstTool ? "C" : "T";
    const int pin = channel < kFirstTool ? channel % kFirstConfigurable : channel - kFirstTool;
    return QStringLiteral("%1%2 %3").arg(QLatin1String(group), output ? "O" : "I").arg(pin);
}

double screenFactor(Unit unit) {
    switch (unit) {
        case Unit::Length:
        case Unit::Speed:
        case Unit::Acceleration:
            return kMillimetres;
        case Unit::Angle:
        case Unit::AngularSpeed:
        case Unit::AngularAcceleration:
            return kDegrees;
        case Unit::Percent:
            return 100.0;
        case Unit::None:
        case Unit::Time:
        case Unit::Force:
            return 1.0;
    }
    return 1.0;
}

QString unitText(Unit unit) {
    switch (unit) {
        case Unit::None:
            return {};
        case Unit::Length:
            return QStringLiteral("mm");
        case Unit::Speed:
            return QStringLiteral("mm/s");
        case Unit::Acceleration:
            return QStringLiteral("mm/s²");
        case Unit::Angle:
            return QStringLiteral("°");
        case Unit::AngularSpeed:
            return QStringLiteral("°/s");
        case Unit::AngularAcceleration:
            return QStringLiteral("°/s²");
        case Unit::Time:
            return QStringLiteral("s");
        case Unit::Force:
            return QStringLiteral("N");
        case Unit::Percent:
            return QStringLiteral("%");
    }
    return {};
}

QString numberText(double value, Unit unit) {
    const QString number = QLocale().toString(value * screenFactor(unit), 'g', 6);
    return unit == Unit::None ? number : QStringLiteral("%1 %2").arg(number, unitText(unit));
}

}  // namespace tiller::program
