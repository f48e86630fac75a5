// SPDX-License-Identifier: MIT
// Digital and analog pins, tool connector.

#include <algorithm>
#include <cmath>

#include "robot/simulator/urscript/builtin_table.h"
#include "robot/simulator/urscript/call.h"

namespace tiller::simulator::urscript {

namespace {

template <DigitalBank bank, int last>
Status digitalIn(Call& c) {
    c.result = c.host.digitalInput(bank, c.integerIn(0, 0, last));
    return Status::Done;
}
template <DigitalBank bank, int last>
Status digitalOut(Call& c) {
    c.result = c.host.digitalOutput(bank, c.integerIn(0, 0, last));
    return Status::Done;
}
template <DigitalBank bank, int last>
Status setDigitalOut(Call& c) {
    c.host.setDigitalOutput(bank, c.integerIn(0, 0, last), c.boolean(1));
    return Status::Done;
}

// The older functions use one number range: 0..7 standard, 8 and 9 tool.
struct Pin {
    DigitalBank bank;
    int number;
};
Pin pin(const Call& c) {
    const int n = c.integerIn(0, 0, 9);
    return n < 8 ? Pin{DigitalBank::Standard, n} : Pin{DigitalBank::Tool, n - 8};
}
Status anyDigitalIn(Call& c) {
    const Pin p = pin(c);
    c.result = c.host.digitalInput(p.bank, p.number);
    return Status::Done;
}
Status anyDigitalOut(Call& c) {
    const Pin p = pin(c);
    c.result = c.host.digitalOutput(p.bank, p.number);
    return Status::Done;
}
Status setAnyDigitalOut(Call& c) {
    const Pin p = pin(c);
    c.host.setDigitalOutput(p.bank, p.number, c.boolean(1));
    return Status::Done;
}

template <AnalogPort port>
Status analog(Call& c) {
    c.result = c.host.analog(port, c.integerIn(0, 0, 1));
    return Status::Done;
}
Status anyAnalogIn(Call& c) {
    const int n = c.integerIn(0, 0, 3);
    c.result =
        n < 2 ? c.host.analog(AnalogPort::StandardInput, n) : c.host.analog(AnalogPort::ToolInput, n - 2);
    return Status::Done;
}
Status setAnalogOut(Call& c) {
    c.host.setAnalogOutput(c.integerIn(0, 0, 1), std::clamp(c.finite(1), 0.0, 1.0));
    return Status::Done;
}
template <AnalogPort port>
Status setDomain(Call& c) {
    c.host.setAnalogDomain(port, c.integerIn(0, 0, 1), c.integerIn(1, 0, 1));
    return Status::Done;
}
Status setInputRange(Call& c) {
    const int n = c.integerIn(0, 0, 3);
    const int range = c.integerIn(1, 0, 4);
    // Range 0 selects current. Ranges above 0 select voltage.
    c.host.setAnalogDomain(n < 2 ? AnalogPort::StandardInput : AnalogPort::ToolInput, n % 2,
                           range > 0 ? 1 : 0);
    return Status::Done;
}

Status setToolVoltage(Call& c) {
    const std::int32_t volts = c.integer(0);
    if (volts != 0 && volts != 12 && volts != 24) {
        fault("set_tool_voltage: voltage must be 0, 12 or 24");
    }
    c.host.setToolVoltage(volts);
    return Status::Done;
}

Status setToolCommunication(Call& c) {
    ToolCommunication settings;
    settings.enabled = c.boolean(0);
    settings.baudRate = c.integerIn(1, 9600, 5'000'000);
    settings.parity = c.integerIn(2, 0, 2);
    settings.stopBits = c.integerIn(3, 1, 2);
    settings.rxIdleChars = c.finite(4);
    settings.txIdleChars = c.finite(5);
    if (settings.rxIdleChars < 1 || settings.rxIdleChars > 40 || settings.txIdleChars < 0 ||
        settings.txIdleChars > 40) {
        fault("set_tool_communication: idle characters are out of range");
    }
    c.host.setToolCommunication(settings);
    return Status::Done;
}

Status setToolOutputMode(Call& c) {
    c.host.setToolOutputMode(c.integerIn(0, 0, 1));
    return Status::Done;
}
Status setToolDigitalOutputMode(Call& c) {
    c.host.setToolDigitalOutputMode(c.integerIn(0, 0, 1), c.integerIn(1, 1, 3));
    return Status::Done;
}

template <RuledInput input, int last>
Status inputAction(Call& c) {
    const std::string& action = c.string(1);
    if (action != "default" && action != "freedrive") {
        fault(c.name() + ": action must be \"default\" or \"freedrive\"");
    }
    c.host.setFreedriveInput(input, c.integerIn(0, 0, last), action == "freedrive");
    return Status::Done;
}
Status resetInputActions(Call& c) {
    c.host.resetInputActions();
    return Status::Done;
}

template <RuledOutput output, int last>
Status runState(Call& c) {
    c.host.setRunState(output, c.integerIn(0, 0, last), c.integerIn(1, 0, 3));
    return Status::Done;
}

/// Sets outputs that are high while a program is running. Exported programs contain these calls for the
/// outputs of the installation. Other outputs are independent of the program.
template <RuledOutput output, int last>
Status runStateOutputs(Call& c) {
    constexpr int kIndependent = 0, kHighWhileRunning = 3;
    const std::vector<double> high = c.numbers(0);
    if (std::any_of(high.begin(), high.end(), [](double n) { return n < 0 || n > last; })) {
        c.badArgument(0, "a list of outputs");
    }
    for (int n = 0; n <= last; ++n) {
        const bool isListed = std::find(high.begin(), high.end(), n) != high.end();
        c.host.setRunState(output, n, isListed ? kHighWhileRunning : kIndependent);
    }
    return Status::Done;
}

constexpr BuiltinRow kIoRows[] = {
    {"get_standard_digital_in(n)", digitalIn<DigitalBank::Standard, 7>},
    {"get_standard_digital_out(n)", digitalOut<DigitalBank::Standard, 7>},
    {"get_configurable_digital_in(n)", digitalIn<DigitalBank::Configurable, 7>},
    {"get_configurable_digital_out(n)", digitalOut<DigitalBank::Configurable, 7>},
    {"get_tool_digital_in(n)", digitalIn<DigitalBank::Tool, 1>},
    {"get_tool_digital_out(n)", digitalOut<DigitalBank::Tool, 1>},
    {"get_digital_in(n)", anyDigitalIn},
    {"get_digital_out(n)", anyDigitalOut},
    {"set_standard_digital_out(n, b)", setDigitalOut<DigitalBank::Standard, 7>},
    {"set_configurable_digital_out(n, b)", setDigitalOut<DigitalBank::Configurable, 7>},
    {"set_tool_digital_out(n, b)", setDigitalOut<DigitalBank::Tool, 1>},
    {"set_digital_out(n, b)", setAnyDigitalOut},
    {"get_standard_analog_in(n)", analog<AnalogPort::StandardInput>},
    {"get_standard_analog_out(n)", analog<AnalogPort::StandardOutput>},
    {"get_tool_analog_in(n)", analog<AnalogPort::ToolInput>},
    {"get_analog_in(n)", anyAnalogIn},
    {"get_analog_out(n)", analog<AnalogPort::StandardOutput>},
    {"set_standard_analog_out(n, f)", setAnalogOut},
    {"set_analog_out(n, f)", setAnalogOut},
    {"set_analog_inputrange(port, range)", setInputRange},
    {"set_analog_outputdomain(port, domain)", setDomain<AnalogPort::StandardOutput>},
    {"set_standard_analog_input_domain(port, domain)", setDomain<AnalogPort::StandardInput>},
    {"set_tool_analog_input_domain(port, domain)", setDomain<AnalogPort::ToolInput>},
    {"set_tool_voltage(voltage)", setToolVoltage},
    {"set_tool_communication(enabled, baud_rate, parity, stop_bits, rx_idle_chars, tx_idle_chars)",
     setToolCommunication, kPlain, kSeries5, nullptr, "no device is connected to the tool connector"},
    {"set_tool_digital_output_mode(n, mode)", setToolDigitalOutputMode, kPlain, kAfter2019By2020},
    {"set_tool_output_mode(mode)", setToolOutputMode, kPlain, kAfter2019By2020},
    {"set_runstate_outputs(outputs)", runStateOutputs<RuledOutput::Standard, 7>},
    {"set_runstate_standard_digital_outputs(outputs)", runStateOutputs<RuledOutput::Standard, 7>},
    {"set_runstate_configurable_digital_outputs(outputs)", runStateOutputs<RuledOutput::Configurable, 7>},
    {"set_runstate_tool_digital_outputs(outputs)", runStateOutputs<RuledOutput::Tool, 1>},
    {"set_runstate_standard_analog_outputs(outputs)", runStateOutputs<RuledOutput::Analog, 1>},
    {"set_runstate_gp_boolean_outputs(outputs)", runStateOutputs<RuledOutput::Register, 127>},
    {"set_runstate_standard_digital_output_to_value(outputId, state)", runState<RuledOutput::Standard, 7>},
    {"set_runstate_configurable_digital_output_to_value(outputId, state)",
     runState<RuledOutput::Configurable, 7>},
    {"set_runstate_tool_digital_output_to_value(outputId, state)", runState<RuledOutput::Tool, 1>},
    {"set_runstate_standard_analog_output_to_value(outputId, state)", runState<RuledOutput::Analog, 1>},
    {"set_runstate_gp_boolean_output_to_value(outputId, state)", runState<RuledOutput::Register, 127>},
    {"set_standard_digital_input_action(port, action)", inputAction<RuledInput::Standard, 7>, kPlain,
     kAfter33},
    {"set_configurable_digital_input_action(port, action)", inputAction<RuledInput::Configurable, 7>, kPlain,
     kAfter33},
    {"set_tool_digital_input_action(port, action)", inputAction<RuledInput::Tool, 1>, kPlain, kAfter33},
    {"set_gp_boolean_input_action(port, action)", inputAction<RuledInput::Register, 127>, kPlain, kAfter33},
    {"set_input_actions_to_default()", resetInputActions, kPlain, kAfter33},
};

}  // namespace

std::span<const BuiltinRow> ioBuiltins() {
    return kIoRows;
}

}  // namespace tiller::simulator::urscript
