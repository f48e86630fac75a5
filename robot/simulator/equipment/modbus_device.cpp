// SPDX-License-Identifier: MIT
#include "robot/simulator/equipment/modbus_device.h"

#include <algorithm>

namespace tiller::simulator {

namespace {

constexpr int kLastAddress = 65535;
constexpr std::size_t kMaxSignals = 1000;
constexpr double kPeriodTolerance = 1e-9;  // tolerance for rounding errors in sums of periods

Error noSignal(std::string_view name) {
    return urscript::scriptError("Modbus signal '" + std::string(name) + "' does not exist");
}

bool isDigital(ModbusDevice::Kind kind) {
    return kind == ModbusDevice::Kind::Input || kind == ModbusDevice::Kind::Coil;
}

}  // namespace

ModbusDevice::Signal* ModbusDevice::find(std::string_view name) {
    const auto it = signals_.find(name);
    return it == signals_.end() ? nullptr : &it->second;
}

const ModbusDevice::Signal* ModbusDevice::find(std::string_view name) const {
    const auto it = signals_.find(name);
    return it == signals_.end() ? nullptr : &it->second;
}

// ---- signals --------------------------------------------------------------------------------------------

Result<void> ModbusDevice::add(const urscript::ModbusSignal& signal) {
    if (signals_.size() >= kMaxSignals && find(signal.name) == nullptr) {
        return urscript::scriptError("too many Modbus signals");
    }
    Signal added;
    added.what = signal;
    added.values.assign(static_cast<std::size_t>(signal.count), 0);
    update(added);
    signals_.insert_or_assign(signal.name, std::move(added));
    return {};
}

void ModbusDevice::remove(std::string_view name) {
    if (const auto it = signals_.find(name); it != signals_.end()) {
        signals_.erase(it);
    }
}

Result<urscript::ModbusStatus> ModbusDevice::status(std::string_view name) const {
    const Signal* const signal = find(name);
    if (signal == nullptr) {
        return noSignal(name);
    }
    if (signal->invalidFor > signal->watchdog) {
        return urscript::scriptError("Modbus signal '" + std::string(name) + "' receives no answer");
    }
    return urscript::ModbusStatus{signal->values, signal->what.isDigital(), signal->what.list};
}

Result<std::int32_t> ModbusDevice::error(std::string_view name, urscript::ModbusErrorSource source) const {
    const Signal* const signal = find(name);
    if (signal == nullptr) {
        return noSignal(name);
    }
    const std::int32_t connection = connected_ ? 0 : kDisconnected;
    switch (source) {
        case urscript::ModbusErrorSource::Device:
            return signal->deviceError;
        case urscript::ModbusErrorSource::Connection:
            return connection;
        case urscript::ModbusErrorSource::Combined:
            break;
    }
    // The upper half contains the connection error.
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(connection) << 16 |
                                     static_cast<std::uint32_t>(signal->deviceError));
}

Result<double> ModbusDevice::invalidTime(std::string_view name) const {
    const Signal* const signal = find(name);
    return signal == nullptr ? Result<double>(noSignal(name)) : Result<double>(signal->invalidFor);
}

Result<void> ModbusDevice::setOutput(std::string_view name, bool digital,
                                     std::span<const std::int32_t> values) {
    Signal* const signal = find(name);
    if (signal == nullptr) {
        return noSignal(name);
    }
    if (!signal->what.isOutput() || signal->what.isDigital() != digital) {
        return urscript::scriptError("Modbus signal '" + std::string(name) + "' is not " +
                                     (digital ? "a digital output" : "an output register"));
    }
    if (values.size() > static_cast<std::size_t>(signal->what.writeCount)) {
        return urscript::scriptError("Modbus signal '" + std::string(name) + "' has only " +
                                     std::to_string(signal->what.writeCount) + " values");
    }
    signal->wanted.resize(std::max(signal->wanted.size(), values.size()));
    std::copy(values.begin(), values.end(), signal->wanted.begin());
    update(*signal);
    return {};
}

Result<void> ModbusDevice::setFrequency(std::string_view name, double hertz) {
    Signal* const signal = find(name);
    if (signal == nullptr) {
        return noSignal(name);
    }
    signal->period = hertz > 0 ? 1 / hertz : 0;
    signal->untilUpdate = 0;
    return {};
}

Result<void> ModbusDevice::setWatchdog(std::string_view name, double seconds) {
    Signal* const signal = find(name);
    if (signal == nullptr) {
        return noSignal(name);
    }
    signal->watchdog = seconds;
    return {};
}

Result<void> ModbusDevice::setFreedrive(std::string_view name, bool freedrive) {
    Signal* const signal = find(name);
    if (signal == nullptr) {
        return noSignal(name);
    }
    signal->freedrive = freedrive;
    return {};
}

Result<void> ModbusDevice::setRunState(std::string_view name, RunState state) {
    Signal* const signal = find(name);
    if (signal == nullptr) {
        return noSignal(name);
    }
    signal->runState = state;
    return {};
}

void ModbusDevice::command(int function, std::span<const std::uint8_t> data) {
    const auto word = [&data](std::size_t at) { return data[at] << 8 | data[at + 1]; };
    if (!connected_ || data.size() < 4) {
        return;
    }
    constexpr int kWriteCoil = 5, kWriteRegister = 6;
    const std::int32_t value = function == kWriteCoil ? (word(2) != 0 ? 1 : 0) : word(2);
    if (function == kWriteCoil || function == kWriteRegister) {
        write(function == kWriteCoil ? Kind::Coil : Kind::Register, word(0), {&value, 1});
    }
    // Other function codes are manufacturer-specific and have no effect.
}

// ---- the device -----------------------------------------------------------------------------------------

std::int32_t ModbusDevice::read(Kind kind, int address) const {
    const auto& table = memory_[static_cast<std::size_t>(kind)];
    const auto it = table.find(address);
    return it == table.end() ? 0 : it->second;
}

void ModbusDevice::write(Kind kind, int address, std::span<const std::int32_t> values) {
    auto& table = memory_[static_cast<std::size_t>(kind)];
    for (const std::int32_t value : values) {
        if (address > kLastAddress) {
            return;
        }
        table[address++] = isDigital(kind) ? (value != 0 ? 1 : 0) : value & 0xFFFF;
    }
}

Result<void> ModbusDevice::writeSignal(std::string_view name, std::span<const std::int32_t> values) {
    const Signal* const signal = find(name);
    if (signal == nullptr) {
        return noSignal(name);
    }
    if (values.size() > signal->values.size()) {
        return urscript::scriptError("Modbus signal '" + std::string(name) + "' has only " +
                                     std::to_string(signal->values.size()) + " values");
    }
    write(signal->what.kind, signal->what.address, values);
    return {};
}

Result<void> ModbusDevice::setDeviceError(std::string_view name, int code) {
    Signal* const signal = find(name);
    if (signal == nullptr) {
        return noSignal(name);
    }
    signal->deviceError = code;
    return {};
}

// ---- time -----------------------------------------------------------------------------------------------

void ModbusDevice::update(Signal& signal) {
    if (!isAnswered(signal)) {
        return;
    }
    write(signal.what.kind, signal.what.writeAddress, signal.wanted);
    signal.wanted.clear();
    for (std::size_t i = 0; i < signal.values.size(); ++i) {
        signal.values[i] = read(signal.what.kind, signal.what.address + static_cast<int>(i));
    }
    signal.invalidFor = 0;
}

void ModbusDevice::step(double dt) {
    for (auto& [name, signal] : signals_) {
        signal.untilUpdate -= dt;
        if (signal.untilUpdate > kPeriodTolerance) {
            signal.invalidFor += isAnswered(signal) ? 0 : dt;
            continue;
        }
        signal.untilUpdate += std::max(signal.period, dt);
        if (isAnswered(signal)) {
            update(signal);
        } else {
            signal.invalidFor += dt;
        }
    }
}

void ModbusDevice::programChanged(bool running) {
    for (auto& [name, signal] : signals_) {
        const bool acts =
            signal.runState == RunState::HighWhileRunning || (!running && signal.runState != RunState::Keep);
        if (acts && signal.what.isOutput() && signal.what.isDigital()) {
            const bool high = signal.runState == RunState::HighWhileRunning
                                  ? running
                                  : signal.runState == RunState::HighWhenStopped;
            signal.wanted.assign(static_cast<std::size_t>(signal.what.writeCount), high ? 1 : 0);
            update(signal);
        }
    }
}

bool ModbusDevice::freedriveWanted() const {
    return std::ranges::any_of(signals_, [](const auto& entry) {
        const Signal& signal = entry.second;
        return signal.freedrive && std::ranges::any_of(signal.values, [](std::int32_t v) { return v != 0; });
    });
}

}  // namespace tiller::simulator
