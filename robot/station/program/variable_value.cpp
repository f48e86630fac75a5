// SPDX-License-Identifier: MIT
#include "robot/station/program/variable_value.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>

#include "robot/core/typed_number.h"
#include "robot/station/program/program_text.h"

namespace tiller::program {

using script::GateVariable;

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

QString scriptValue(GateVariable::Type type, double value) {
    switch (type) {
        case GateVariable::Type::Number: {
            const QString text = QString::number(value, 'g', std::numeric_limits<double>::max_digits10);
            // Without a point or an exponent, the value would be an integer.
            return text.contains(QLatin1Char('.')) || text.contains(QLatin1Char('e'))
                       ? text
                       : text + QStringLiteral(".0");
        }
        case GateVariable::Type::Whole:
            return QString::number(value, 'f', 0);
        case GateVariable::Type::Flag:
            return value != 0 ? QStringLiteral("True") : QStringLiteral("False");
    }
    return {};
}

}  // namespace tiller::program
