// SPDX-License-Identifier: MIT
// Signals of Modbus devices, by name.

#include <algorithm>

#include "robot/simulator/urscript/builtin_table.h"
#include "robot/simulator/urscript/call.h"

namespace tiller::simulator::urscript {

namespace {

constexpr int kMaxPerRequest = 123;  ///< maximum number of registers in one request
constexpr int kMaxNameLength = 20;

template <class T>
T checked(Result<T> outcome) {
    if (!outcome.ok()) {
        fault(outcome.error());
    }
    return std::move(*outcome);
}

std::string nameAt(Call& c, std::size_t i) {
    const std::string& name = c.string(i);
    if (name.empty() || name.size() > kMaxNameLength) {
        fault(c.name() + ": the name of a signal must have 1 to 20 characters");
    }
    return name;
}

Status addSignal(Call& c) {
    using Kind = ModbusSignal::Kind;
    ModbusSignal signal;
    signal.device = c.string(0);
    c.integerIn(1, 0, 255);
    signal.address = c.integerIn(2, 0, 65535);
    switch (c.integer(3)) {
        case 0:
            signal.kind = Kind::Input;
            break;
        case 1:
        case 15:  // function code for writing multiple values
            signal.kind = Kind::Coil;
            break;
        case 2:
            signal.kind = Kind::InputRegister;
            break;
        case 3:
        case 16:
            signal.kind = Kind::Register;
            break;
        default:
            fault("Range error: modbus_add_signal argument 'signal_type' is " + std::to_string(c.integer(3)) +
                  ", allowed is 0 to 3, 15 and 16");
    }
    signal.name = nameAt(c, 4);
    signal.list = c.given(6);
    signal.count = signal.list ? c.integerIn(6, 1, kMaxPerRequest) : 1;
    signal.writeAddress = signal.address;
    signal.writeCount = signal.count;
    c.check(c.host.addModbusSignal(signal));
    return Status::Done;
}

Status addReadWriteSignal(Call& c) {
    ModbusSignal signal;
    signal.kind = ModbusSignal::Kind::Register;
    signal.device = c.string(0);
    c.integerIn(1, 0, 255);
    signal.address = c.integerIn(2, 0, 65535);
    signal.count = c.integerIn(3, 1, kMaxPerRequest);
    signal.writeAddress = c.integerIn(4, 0, 65535);
    signal.writeCount = c.integerIn(5, 1, kMaxPerRequest);
    signal.name = nameAt(c, 6);
    signal.list = true;
    c.check(c.host.addModbusSignal(signal));
    return Status::Done;
}

Status deleteSignal(Call& c) {
    c.check(c.host.deleteModbusSignal(nameAt(c, 0)));
    return Status::Done;
}

Status getStatus(Call& c) {
    const ModbusStatus status = checked(c.host.modbusStatus(nameAt(c, 0)));
    if (status.list) {
        ListData data;
        data.kind = status.digital ? ListData::Kind::Bool : ListData::Kind::Int;
        data.numbers.assign(status.values.begin(), status.values.end());
        c.result = Value::list(std::move(data));
    } else if (status.digital) {
        c.result = status.values.front() != 0;
    } else {
        c.result = status.values.front();
    }
    return Status::Done;
}

Status getError(Call& c) {
    const auto source = static_cast<ModbusErrorSource>(c.integerIn(1, 0, 2));
    c.result = checked(c.host.modbusError(nameAt(c, 0), source));
    return Status::Done;
}

Status getInvalidTime(Call& c) {
    c.result = checked(c.host.modbusInvalidTime(nameAt(c, 0)));
    return Status::Done;
}

/// Reads an argument that is a value or a list of values.
std::vector<std::int32_t> valuesAt(Call& c, std::size_t i, bool digital) {
    std::vector<double> given;
    if (c.args[i].is(Value::Type::List)) {
        given = c.numbers(i);
    } else if (digital) {
        given.push_back(c.boolean(i) ? 1 : 0);
    } else {
        given.push_back(c.integer(i));
    }
    if (given.empty() || given.size() > kMaxPerRequest) {
        fault("Range error: " + c.name() + " accepts 1 to 123 values");
    }
    std::vector<std::int32_t> values;
    for (const double value : given) {
        if (!(value >= 0 && value <= 65535)) {
            fault("Range error: " + c.name() + " accepts values from 0 to 65535");
        }
        values.push_back(static_cast<std::int32_t>(value));
    }
    return values;
}

Status setRegister(Call& c) {
    c.check(c.host.setModbusOutput(nameAt(c, 0), false, valuesAt(c, 1, false)));
    return Status::Done;
}

Status setSignal(Call& c) {
    c.check(c.host.setModbusOutput(nameAt(c, 0), true, valuesAt(c, 1, true)));
    return Status::Done;
}

Status setFrequency(Call& c) {
    c.check(c.host.setModbusFrequency(nameAt(c, 0), c.integerIn(1, -1, 500)));
    return Status::Done;
}

Status setSignalWatchdog(Call& c) {
    const double seconds = c.finite(1);
    if (seconds < 0 || seconds > 300) {
        fault("Range error: modbus_set_signal_watchdog accepts 0 to 300 s");
    }
    c.check(c.host.setModbusWatchdog(nameAt(c, 0), seconds));
    return Status::Done;
}

Status setInputAction(Call& c) {
    const std::string& action = c.string(1);
    if (action != "default" && action != "freedrive") {
        fault("modbus_set_digital_input_action: action must be \"default\" or \"freedrive\"");
    }
    c.check(c.host.setModbusFreedrive(nameAt(c, 0), action == "freedrive"));
    return Status::Done;
}

Status setRunState(Call& c) {
    c.check(c.host.setModbusRunState(nameAt(c, 0), c.integerIn(1, 0, 3)));
    return Status::Done;
}

Status sendCommand(Call& c) {
    c.string(0);
    c.integerIn(1, 0, 255);
    std::vector<std::uint8_t> bytes;
    for (const double value : c.numbers(3)) {
        if (!(value >= 0 && value <= 255)) {
            fault("Range error: modbus_send_custom_command accepts bytes from 0 to 255");
        }
        bytes.push_back(static_cast<std::uint8_t>(value));
    }
    c.check(c.host.sendModbusCommand(c.integerIn(2, 0, 255), bytes));
    return Status::Done;
}

Status resetConnection(Call& c) {
    c.string(0);
    return c.boolean(1) && !c.host.isModbusConnected() ? Status::Again : Status::Done;
}

constexpr BuiltinRow kModbusRows[] = {
    {"modbus_add_signal(IP, slave_number, signal_address, signal_type, signal_name, sequential_mode=False, "
     "register_count?)",
     addSignal},
    {"modbus_add_rw_signal(IP, slave_number, read_address, read_register_count, write_address, "
     "write_register_count, signal_name, sequential_mode=False)",
     addReadWriteSignal, kPlain, kAfter2019},
    {"modbus_delete_signal(signal_name)", deleteSignal},
    {"modbus_get_signal_status(signal_name, is_secondary_program=False)", getStatus},
    {"modbus_get_error(signal_name, error_source=0)", getError, kPlain, kAfter2019},
    {"modbus_get_time_since_signal_invalid(signal_name)", getInvalidTime, kPlain, kAfter2019},
    {"modbus_set_output_register(signal_name, register_value, is_secondary_program=False)", setRegister},
    {"modbus_set_output_signal(signal_name, digital_value, is_secondary_program=False)", setSignal},
    {"modbus_set_signal_update_frequency(signal_name, update_frequency)", setFrequency},
    {"modbus_set_signal_watchdog(signal_name, new_timeout_in_sec)", setSignalWatchdog, kPlain, kAfter2019},
    {"modbus_set_digital_input_action(signal_name, action)", setInputAction, kPlain, kAfter33},
    {"modbus_set_runstate_dependent_choice(signal_name, runstate_choice)", setRunState},
    {"modbus_send_custom_command(IP, slave_number, function_code, data)", sendCommand},
    {"modbus_reset_connection(connection_id, is_blocking=True)", resetConnection, kPlain, kAfter2019},
};

}  // namespace

std::span<const BuiltinRow> modbusBuiltins() {
    return kModbusRows;
}

}  // namespace tiller::simulator::urscript
