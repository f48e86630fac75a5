// SPDX-License-Identifier: MIT
#pragma once

// A Modbus device and the controller's signals for it. The same device responds at every IP address. The
// device has discrete inputs, coils, input registers and registers, all initially 0. Fault injection changes
// the inputs. Signals are updated at their frequency. If a signal receives no response for longer than its
// watchdog time, programs that read this signal get an error. Source: URScript manual, modbus functions.

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "robot/core/result.h"
#include "robot/simulator/plant/terminal_rules.h"
#include "robot/simulator/urscript/host.h"

namespace tiller::simulator {

/// Threads  the simulator thread
class ModbusDevice {
public:
    using Kind = urscript::ModbusSignal::Kind;

    // Functions called by URScript programs; see urscript::ModbusHost.
    Result<void> add(const urscript::ModbusSignal& signal);
    void remove(std::string_view name);
    Result<urscript::ModbusStatus> status(std::string_view name) const;
    Result<std::int32_t> error(std::string_view name, urscript::ModbusErrorSource source) const;
    Result<double> invalidTime(std::string_view name) const;
    Result<void> setOutput(std::string_view name, bool digital, std::span<const std::int32_t> values);
    Result<void> setFrequency(std::string_view name, double hertz);
    Result<void> setWatchdog(std::string_view name, double seconds);
    Result<void> setFreedrive(std::string_view name, bool freedrive);
    Result<void> setRunState(std::string_view name, RunState state);
    void command(int function, std::span<const std::uint8_t> data);
    bool isConnected() const { return connected_; }

    // Fault injection.
    /// Writes values starting at this address. Addresses above 65535 are ignored.
    void write(Kind kind, int address, std::span<const std::int32_t> values);
    Result<void> writeSignal(std::string_view name, std::span<const std::int32_t> values);
    /// Sets the response of the device to a signal: 0 no error, 1 illegal function, 2 illegal address, 3
    /// illegal value, 4 failure, 6 busy ...
    Result<void> setDeviceError(std::string_view name, int code);
    void setConnected(bool connected) { connected_ = connected; }

    void step(double dt);
    void programChanged(bool running);
    /// True if any input that acts as a freedrive button is high.
    bool freedriveWanted() const;

private:
    struct Signal {
        urscript::ModbusSignal what;
        std::vector<std::int32_t> values;  ///< last values read
        std::vector<std::int32_t> wanted;  ///< values to write; empty: nothing to write
        double period = 0.1;               ///< [s]; 0: read on request
        double untilUpdate = 0;            ///< [s]
        double invalidFor = 0;             ///< time since the last response [s]
        double watchdog = 2;               ///< [s]
        int deviceError = 0;
        bool freedrive = false;
        RunState runState = RunState::Keep;
    };
    static constexpr std::int32_t kDisconnected = -2;

    Signal* find(std::string_view name);
    const Signal* find(std::string_view name) const;
    bool isAnswered(const Signal& signal) const { return connected_ && signal.deviceError == 0; }
    void update(Signal& signal);
    std::int32_t read(Kind kind, int address) const;

    std::array<std::map<int, std::int32_t>, 4> memory_;  ///< by type and address; missing values are 0
    std::map<std::string, Signal, std::less<>> signals_;
    bool connected_ = true;
};

}  // namespace tiller::simulator
