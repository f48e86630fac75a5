// SPDX-License-Identifier: MIT
#include "robot/simulator/pendant/terminals.h"

#include <QRegularExpression>

namespace tiller::simulator::pendant {

namespace {

using V = TerminalValue;
constexpr TerminalKind kKinds[] = {
    {"digital_in", "DigitalInputNames", "get_standard_digital_in", nullptr, 8, V::Boolean, "DI"},
    {"digital_out", "DigitalOutputNames", "get_standard_digital_out", "set_standard_digital_out", 8,
     V::Boolean, "DO"},
    {"config_in", "ConfigurableInputNames", "get_configurable_digital_in", nullptr, 8, V::Boolean, "CI"},
    {"config_out", "ConfigurableOutputNames", "get_configurable_digital_out", "set_configurable_digital_out",
     8, V::Boolean, "CO"},
    {"tool_in", "ToolDigitalInputNames", "get_tool_digital_in", nullptr, 2, V::Boolean, "TI"},
    {"tool_out", "ToolDigitalOutputNames", "get_tool_digital_out", "set_tool_digital_out", 2, V::Boolean,
     "TO"},
    {"analog_in", "AnalogInputNames", "get_standard_analog_in", nullptr, 2, V::Analog, "AI"},
    {"analog_out", "AnalogOutputNames", "get_standard_analog_out", "set_standard_analog_out", 2, V::Analog,
     "AO"},
    {"tool_analog_in", "ToolAnalogInputNames", "get_tool_analog_in", nullptr, 2, V::Analog, "TAI"},
    {"gp_bool_in", "GeneralPurposeBooleanRegisterInputNames", "read_input_boolean_register", nullptr, 128,
     V::Boolean, "GP_bool_in"},
    {"gp_int_in", "GeneralPurposeIntRegisterInputNames", "read_input_integer_register", nullptr, 48,
     V::Integer, "GP_int_in"},
    {"gp_float_in", "GeneralPurposeFloatRegisterInputNames", "read_input_float_register", nullptr, 48,
     V::Float, "GP_float_in"},
    {"gp_bool_out", "GeneralPurposeBooleanRegisterOutputNames", "read_output_boolean_register",
     "write_output_boolean_register", 128, V::Boolean, "GP_bool_out"},
    {"gp_int_out", "GeneralPurposeIntRegisterOutputNames", "read_output_integer_register",
     "write_output_integer_register", 48, V::Integer, "GP_int_out"},
    {"gp_float_out", "GeneralPurposeFloatRegisterOutputNames", "read_output_float_register",
     "write_output_float_register", 48, V::Float, "GP_float_out"},
};

}  // namespace

std::span<const TerminalKind> terminalKinds() {
    return kKinds;
}

std::optional<Terminal> terminalByDefaultName(const QString& name) {
    static const QRegularExpression kNumbered(QStringLiteral("^(\\w+)\\[(\\d{1,3})\\]$"));
    const QRegularExpressionMatch match = kNumbered.match(name);
    if (match.hasMatch()) {
        const QString kind = match.captured(1).toLower();
        const int number = match.captured(2).toInt();
        for (const TerminalKind& known : kKinds) {
            if (kind == QLatin1String(known.name) && number < known.count) {
                return Terminal{&known, number};
            }
        }
    }
    return std::nullopt;
}

}  // namespace tiller::simulator::pendant
