// SPDX-License-Identifier: MIT
#pragma once

// Sets outputs, the speed slider and general purpose registers through a separate RTDE connection, with or
// without a running program. All other outputs do not change.

#include <ur_rtde/rtde_utility.h>

#include <cstdint>
#include <memory>
#include <string>

namespace ur_rtde {

/// Setters return true when the command has been sent. They return false without a connection (after one
/// attempt to reconnect), if the robot is not reading the data, or if another client or a fieldbus uses the
/// input. Arguments out of range throw std::range_error before anything is sent.
/// Threads  any; calls are serialized
class RTDEIOInterface {
public:
    /// use_upper_range_registers  registers 42-46 instead of 18-22
    /// Throws std::runtime_error if the controller cannot be reached within 3 s.
    explicit RTDEIOInterface(std::string hostname, bool verbose = false,
                             bool use_upper_range_registers = false, int rt_priority = RT_PRIORITY_UNDEFINED);
    virtual ~RTDEIOInterface();
    RTDEIOInterface(const RTDEIOInterface&) = delete;
    RTDEIOInterface& operator=(const RTDEIOInterface&) = delete;

    void disconnect();
    bool reconnect();

    bool setStandardDigitalOut(std::uint8_t output_id, bool signal_level);      ///< 0 ... 7
    bool setConfigurableDigitalOut(std::uint8_t output_id, bool signal_level);  ///< 0 ... 7
    bool setToolDigitalOut(std::uint8_t output_id, bool signal_level);          ///< 0, 1
    /// speed  0.02 ... 1; lower values are refused, because 0 has caused protective stops. To stop the arm,
    ///        pause or stop the program
    bool setSpeedSlider(double speed);
    bool setAnalogOutputVoltage(std::uint8_t output_id,
                                double voltage_ratio);  ///< 0, 1; ratio 0 ... 1 of 10 V
    bool setAnalogOutputCurrent(std::uint8_t output_id, double current_ratio);  ///< 0, 1; 0 ... 1 of 4-20 mA
    bool setInputIntRegister(int input_id, int value);                          ///< 18-22; upper range: 42-46
    bool setInputDoubleRegister(int input_id, double value);                    ///< 18-22; upper range: 42-46

private:
    struct Private;
    std::unique_ptr<Private> d_;
};

}  // namespace ur_rtde
