// SPDX-License-Identifier: MIT
#pragma once

// Sets outputs, the speed slider and general purpose registers through an RTDE connection of its own, whether
// or not a program runs. Only what is asked for is touched.

#include <ur_rtde/rtde_utility.h>

#include <cstdint>
#include <memory>
#include <string>

namespace ur_rtde {

/// Every setter returns true when the command is on its way, false when there is no connection (one attempt
/// is made to get it back), the robot does not read, or another client or a fieldbus owns the input.
/// Arguments out of range throw std::range_error before anything is sent.
/// Threads  any; calls are carried out one after the other
class RTDEIOInterface {
public:
    /// use_upper_range_registers  registers 42-46 instead of 18-22
    /// Throws std::runtime_error when the controller cannot be reached within 3 s.
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
    /// speed  0.02 ... 1. Below that the arm would creep, and 0 has caused protective stops: to hold the arm still,
    /// pause the program or stop it
    bool setSpeedSlider(double speed);
    bool setAnalogOutputVoltage(std::uint8_t output_id,
                                double voltage_ratio);  ///< 0, 1; ratio 0 ... 1 of 10 V
    bool setAnalogOutputCurrent(std::uint8_t output_id, double current_ratio);  ///< 0, 1; 0 ... 1 of 4-20 mA
    bool setInputIntRegister(int input_id, int value);                          ///< 18-22, upper range 42-46
    bool setInputDoubleRegister(int input_id, double value);                    ///< likewise

private:
    struct Private;
    std::unique_ptr<Private> d_;
};

}  // namespace ur_rtde
