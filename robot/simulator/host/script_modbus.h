// SPDX-License-Identifier: MIT
#pragma once

// Access of a program to the Modbus device.

#include "robot/simulator/equipment/modbus_device.h"
#include "robot/simulator/urscript/host.h"

namespace tiller::simulator {

/// Threads  the simulator thread
class ScriptModbus : public virtual urscript::ModbusHost {
public:
    ModbusDevice& modbus() { return modbus_; }

    Result<void> addModbusSignal(const urscript::ModbusSignal& signal) override;
    Result<void> deleteModbusSignal(std::string_view name) override;
    Result<urscript::ModbusStatus> modbusStatus(std::string_view name) const override;
    Result<std::int32_t> modbusError(std::string_view name,
                                     urscript::ModbusErrorSource source) const override;
    Result<double> modbusInvalidTime(std::string_view name) const override;
    Result<void> setModbusOutput(std::string_view name, bool digital,
                                 std::span<const std::int32_t> values) override;
    Result<void> setModbusFrequency(std::string_view name, double hertz) override;
    Result<void> setModbusWatchdog(std::string_view name, double seconds) override;
    Result<void> setModbusFreedrive(std::string_view name, bool freedrive) override;
    Result<void> setModbusRunState(std::string_view name, int state) override;
    Result<void> sendModbusCommand(int function, std::span<const std::uint8_t> data) override;
    bool isModbusConnected() const override;

private:
    ModbusDevice modbus_;
};

}  // namespace tiller::simulator
