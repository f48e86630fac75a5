// SPDX-License-Identifier: MIT
// General purpose registers and flags.

#include "robot/simulator/urscript/builtin_table.h"
#include "robot/simulator/urscript/call.h"

namespace tiller::simulator::urscript {

namespace {

constexpr int kBools = 127;
constexpr int kNumbers = 47;

template <RegisterSide side>
Status readBool(Call& c) {
    c.result = c.host.boolRegister(side, c.integerIn(0, 0, kBools));
    return Status::Done;
}
template <RegisterSide side>
Status readInt(Call& c) {
    c.result = c.host.intRegister(side, c.integerIn(0, 0, kNumbers));
    return Status::Done;
}
template <RegisterSide side>
Status readFloat(Call& c) {
    c.result = c.host.floatRegister(side, c.integerIn(0, 0, kNumbers));
    return Status::Done;
}
Status writeBool(Call& c) {
    c.host.setBoolOutput(c.integerIn(0, 0, kBools), c.boolean(1));
    return Status::Done;
}
Status writeInt(Call& c) {
    // Bools are stored as 1 or 0.
    const bool question = c.args[1].is(Value::Type::Bool);
    c.host.setIntOutput(c.integerIn(0, 0, kNumbers), question ? std::int32_t{c.boolean(1)} : c.integer(1));
    return Status::Done;
}
Status writeFloat(Call& c) {
    c.host.setFloatOutput(c.integerIn(0, 0, kNumbers), c.number(1));
    return Status::Done;
}
Status getFlag(Call& c) {
    c.result = c.host.flag(c.integerIn(0, 0, 32));
    return Status::Done;
}
Status setFlag(Call& c) {
    c.host.setFlag(c.integerIn(0, 0, 32), c.boolean(1));
    return Status::Done;
}

Status readPortBit(Call& c) {
    c.result = c.host.portBit(c.integerIn(0, 0, RegisterHost::kPorts - 1));
    return Status::Done;
}
Status writePortBit(Call& c) {
    c.host.setPortBit(c.integerIn(0, 0, RegisterHost::kPorts - 1), c.boolean(1));
    return Status::Done;
}
Status readPortRegister(Call& c) {
    c.result = std::int32_t{c.host.portRegister(c.integerIn(0, 0, RegisterHost::kPorts - 1))};
    return Status::Done;
}
// Accepts signed and unsigned 16-bit values.
Status writePortRegister(Call& c) {
    c.host.setPortRegister(c.integerIn(0, 0, RegisterHost::kPorts - 1),
                           static_cast<std::int16_t>(c.integerIn(1, -32768, 65535)));
    return Status::Done;
}

constexpr BuiltinRow kRegisterRows[] = {
    {"read_input_boolean_register(address)", readBool<RegisterSide::Input>},
    {"read_input_integer_register(address)", readInt<RegisterSide::Input>},
    {"read_input_float_register(address)", readFloat<RegisterSide::Input>},
    {"read_output_boolean_register(address)", readBool<RegisterSide::Output>},
    {"read_output_integer_register(address)", readInt<RegisterSide::Output>},
    {"read_output_float_register(address)", readFloat<RegisterSide::Output>},
    {"write_output_boolean_register(address, value)", writeBool},
    {"write_output_integer_register(address, value)", writeInt},
    {"write_output_float_register(address, value)", writeFloat},
    {"get_flag(n)", getFlag},
    {"set_flag(n, b)", setFlag},
    {"read_port_bit(address)", readPortBit},
    {"read_port_register(address)", readPortRegister},
    {"write_port_bit(address, value)", writePortBit},
    {"write_port_register(address, value)", writePortRegister},
};

}  // namespace

std::span<const BuiltinRow> registerBuiltins() {
    return kRegisterRows;
}

}  // namespace tiller::simulator::urscript
