// SPDX-License-Identifier: MIT
#pragma once

// Reads the RTDE data of the robot and records them to CSV files. A separate thread receives the stream and
// reconnects automatically until disconnect(). The getters return values of the newest packet, regardless of
// its age. Use isConnected() to check whether data arrive.
//
// Errors of the getters: std::runtime_error with the field name if the field was not requested (see
// `variables`) or the robot does not have it.

#include <ur_rtde/rtde.h>
#include <ur_rtde/rtde_utility.h>

#include <chrono>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace ur_rtde {

/// State of the program: paused, running, or ramping up after a pause; see getSpeedScalingCombined().
enum class PausingState { PAUSED, RUNNING, RAMPUP };

/// Threads  any
class RTDEReceiveInterface {
public:
    /// Bits of getSafetyStatusBits().
    enum SafetyStatus {
        IS_NORMAL_MODE = 0,
        IS_REDUCED_MODE = 1,
        IS_PROTECTIVE_STOPPED = 2,
        IS_RECOVERY_MODE = 3,
        IS_SAFEGUARD_STOPPED = 4,
        IS_SYSTEM_EMERGENCY_STOPPED = 5,
        IS_ROBOT_EMERGENCY_STOPPED = 6,
        IS_EMERGENCY_STOPPED = 7,
        IS_VIOLATION = 8,
        IS_FAULT = 9,
        IS_STOPPED_DUE_TO_SAFETY = 10
    };
    enum RuntimeState { STOPPING = 0, STOPPED = 1, PLAYING = 2, PAUSING = 3, PAUSED = 4, RESUMING = 5 };
    enum OutputIntRegisters {
        OUTPUT_INT_REGISTER_0 = 0,
        OUTPUT_INT_REGISTER_1 = 1,
        OUTPUT_INT_REGISTER_2 = 2,
        OUTPUT_INT_REGISTER_3 = 3,
        OUTPUT_INT_REGISTER_4 = 4,
        OUTPUT_INT_REGISTER_5 = 5,
        OUTPUT_INT_REGISTER_6 = 6,
        OUTPUT_INT_REGISTER_7 = 7,
        OUTPUT_INT_REGISTER_8 = 8,
        OUTPUT_INT_REGISTER_9 = 9,
        OUTPUT_INT_REGISTER_10 = 10,
        OUTPUT_INT_REGISTER_11 = 11,
        OUTPUT_INT_REGISTER_12 = 12,
        OUTPUT_INT_REGISTER_13 = 13,
        OUTPUT_INT_REGISTER_14 = 14,
        OUTPUT_INT_REGISTER_15 = 15,
        OUTPUT_INT_REGISTER_16 = 16,
        OUTPUT_INT_REGISTER_17 = 17,
        OUTPUT_INT_REGISTER_18 = 18,
        OUTPUT_INT_REGISTER_19 = 19,
        OUTPUT_INT_REGISTER_20 = 20,
        OUTPUT_INT_REGISTER_21 = 21,
        OUTPUT_INT_REGISTER_22 = 22,
        OUTPUT_INT_REGISTER_23 = 23,
        OUTPUT_INT_REGISTER_24 = 24,
        OUTPUT_INT_REGISTER_25 = 25,
        OUTPUT_INT_REGISTER_26 = 26,
        OUTPUT_INT_REGISTER_27 = 27,
        OUTPUT_INT_REGISTER_28 = 28,
        OUTPUT_INT_REGISTER_29 = 29,
        OUTPUT_INT_REGISTER_30 = 30,
        OUTPUT_INT_REGISTER_31 = 31,
        OUTPUT_INT_REGISTER_32 = 32,
        OUTPUT_INT_REGISTER_33 = 33,
        OUTPUT_INT_REGISTER_34 = 34,
        OUTPUT_INT_REGISTER_35 = 35,
        OUTPUT_INT_REGISTER_36 = 36,
        OUTPUT_INT_REGISTER_37 = 37,
        OUTPUT_INT_REGISTER_38 = 38,
        OUTPUT_INT_REGISTER_39 = 39,
        OUTPUT_INT_REGISTER_40 = 40,
        OUTPUT_INT_REGISTER_41 = 41,
        OUTPUT_INT_REGISTER_42 = 42,
        OUTPUT_INT_REGISTER_43 = 43,
        OUTPUT_INT_REGISTER_44 = 44,
        OUTPUT_INT_REGISTER_45 = 45,
        OUTPUT_INT_REGISTER_46 = 46,
        OUTPUT_INT_REGISTER_47 = 47,
    };
    enum OutputDoubleRegisters {
        OUTPUT_DOUBLE_REGISTER_0 = 0,
        OUTPUT_DOUBLE_REGISTER_1 = 1,
        OUTPUT_DOUBLE_REGISTER_2 = 2,
        OUTPUT_DOUBLE_REGISTER_3 = 3,
        OUTPUT_DOUBLE_REGISTER_4 = 4,
        OUTPUT_DOUBLE_REGISTER_5 = 5,
        OUTPUT_DOUBLE_REGISTER_6 = 6,
        OUTPUT_DOUBLE_REGISTER_7 = 7,
        OUTPUT_DOUBLE_REGISTER_8 = 8,
        OUTPUT_DOUBLE_REGISTER_9 = 9,
        OUTPUT_DOUBLE_REGISTER_10 = 10,
        OUTPUT_DOUBLE_REGISTER_11 = 11,
        OUTPUT_DOUBLE_REGISTER_12 = 12,
        OUTPUT_DOUBLE_REGISTER_13 = 13,
        OUTPUT_DOUBLE_REGISTER_14 = 14,
        OUTPUT_DOUBLE_REGISTER_15 = 15,
        OUTPUT_DOUBLE_REGISTER_16 = 16,
        OUTPUT_DOUBLE_REGISTER_17 = 17,
        OUTPUT_DOUBLE_REGISTER_18 = 18,
        OUTPUT_DOUBLE_REGISTER_19 = 19,
        OUTPUT_DOUBLE_REGISTER_20 = 20,
        OUTPUT_DOUBLE_REGISTER_21 = 21,
        OUTPUT_DOUBLE_REGISTER_22 = 22,
        OUTPUT_DOUBLE_REGISTER_23 = 23,
        OUTPUT_DOUBLE_REGISTER_24 = 24,
        OUTPUT_DOUBLE_REGISTER_25 = 25,
        OUTPUT_DOUBLE_REGISTER_26 = 26,
        OUTPUT_DOUBLE_REGISTER_27 = 27,
        OUTPUT_DOUBLE_REGISTER_28 = 28,
        OUTPUT_DOUBLE_REGISTER_29 = 29,
        OUTPUT_DOUBLE_REGISTER_30 = 30,
        OUTPUT_DOUBLE_REGISTER_31 = 31,
        OUTPUT_DOUBLE_REGISTER_32 = 32,
        OUTPUT_DOUBLE_REGISTER_33 = 33,
        OUTPUT_DOUBLE_REGISTER_34 = 34,
        OUTPUT_DOUBLE_REGISTER_35 = 35,
        OUTPUT_DOUBLE_REGISTER_36 = 36,
        OUTPUT_DOUBLE_REGISTER_37 = 37,
        OUTPUT_DOUBLE_REGISTER_38 = 38,
        OUTPUT_DOUBLE_REGISTER_39 = 39,
        OUTPUT_DOUBLE_REGISTER_40 = 40,
        OUTPUT_DOUBLE_REGISTER_41 = 41,
        OUTPUT_DOUBLE_REGISTER_42 = 42,
        OUTPUT_DOUBLE_REGISTER_43 = 43,
        OUTPUT_DOUBLE_REGISTER_44 = 44,
        OUTPUT_DOUBLE_REGISTER_45 = 45,
        OUTPUT_DOUBLE_REGISTER_46 = 46,
        OUTPUT_DOUBLE_REGISTER_47 = 47,
    };

    /// frequency                  packets per second; -1: maximum of the controller (500, or 125 on CB3)
    /// variables                  names of RTDE output fields to receive; empty: all fields of this interface
    /// use_upper_range_registers  receive output registers 26, 36-43 instead of 2, 12-19
    /// rt_priority                of the receive thread
    /// Throws std::runtime_error if no data arrive for 3 s, or std::invalid_argument for an unknown field
    /// name.
    explicit RTDEReceiveInterface(std::string hostname, double frequency = -1.0,
                                  std::vector<std::string> variables = {}, bool verbose = false,
                                  bool use_upper_range_registers = false,
                                  int rt_priority = RT_PRIORITY_UNDEFINED);
    virtual ~RTDEReceiveInterface();
    RTDEReceiveInterface(const RTDEReceiveInterface&) = delete;
    RTDEReceiveInterface& operator=(const RTDEReceiveInterface&) = delete;

    void disconnect();
    /// Reconnects and waits for data.
    /// Returns  false if no data arrive for 3 s; the thread keeps retrying
    bool reconnect();
    bool isConnected();

    /// Marks the start of a cycle for waitPeriod().
    std::chrono::steady_clock::time_point initPeriod();
    /// Sleeps until one period of `frequency` after the start of the cycle.
    void waitPeriod(const std::chrono::steady_clock::time_point& t_cycle_start);

    /// Starts recording, with one row per packet and one column per number (actual_q_0 ...).
    /// variables  field names in column order; empty: all received fields, `timestamp` first
    /// Throws std::invalid_argument for a field that is not received.
    /// Returns    false if the file cannot be written or a recording is active
    bool startFileRecording(const std::string& filename, const std::vector<std::string>& variables = {});
    /// Returns  false if there was no recording or the recording failed
    bool stopFileRecording();
    /// Returns after the next packet, or after 2.5 s without a packet.
    void receiveCallback();
    /// Returns after the next packet has been passed to the recording, or at once without a recording.
    void recordCallback();

    double getTimestamp();                        ///< [s] since the start of the controller
    std::vector<double> getTargetQ();             ///< [rad]
    std::vector<double> getTargetQd();            ///< [rad/s]
    std::vector<double> getTargetQdd();           ///< [rad/s2]
    std::vector<double> getTargetCurrent();       ///< [A]
    std::vector<double> getTargetMoment();        ///< [Nm]
    std::vector<double> getActualQ();             ///< [rad]
    std::vector<double> getActualQd();            ///< [rad/s]
    std::vector<double> getActualCurrent();       ///< [A]
    std::vector<double> getJointControlOutput();  ///< [A]
    std::vector<double> getActualTCPPose();       ///< base frame [m, rad]
    std::vector<double> getActualTCPSpeed();      ///< base frame [m/s, rad/s]
    std::vector<double> getActualTCPForce();      ///< base frame [N, Nm]
    std::vector<double> getTargetTCPPose();
    std::vector<double> getTargetTCPSpeed();
    uint64_t getActualDigitalInputBits();           ///< 0-7 standard, 8-15 configurable, 16-17 tool
    bool getDigitalInState(std::uint8_t input_id);  ///< 0 ... 17
    std::vector<double> getJointTemperatures();     ///< [degC]
    double getActualExecutionTime();                ///< [s]
    int32_t getRobotMode();
    uint32_t getRobotStatus();  ///< bits: 0 power on, 1 program running, 2 freedrive button, 3 power button
    std::vector<int32_t> getJointMode();
    int32_t getSafetyMode();
    uint32_t getSafetyStatusBits();                    ///< see SafetyStatus
    std::vector<double> getActualToolAccelerometer();  ///< 3 values [m/s2]
    double getSpeedScaling();                          ///< 0 ... 1
    double getTargetSpeedFraction();                   ///< speed slider, 0 ... 1
    double getActualMomentum();                        ///< [kg m/s]
    double getActualMainVoltage();                     ///< [V]
    double getActualRobotVoltage();                    ///< [V]
    double getActualRobotCurrent();                    ///< [A]
    std::vector<double> getActualJointVoltage();       ///< [V]
    uint64_t getActualDigitalOutputBits();             ///< 0-7 standard, 8-15 configurable, 16-17 tool
    bool getDigitalOutState(std::uint8_t output_id);   ///< 0 ... 17
    uint32_t getRuntimeState();
    double getStandardAnalogInput0();  ///< [mA] or [V]
    double getStandardAnalogInput1();
    double getStandardAnalogOutput0();
    double getStandardAnalogOutput1();
    bool isProtectiveStopped();
    bool isEmergencyStopped();
    int getOutputIntRegister(int output_id);  ///< 12-19; upper range: 36-43; or as requested in `variables`
    double getOutputDoubleRegister(int output_id);  ///< same registers as getOutputIntRegister()
    /// Speed scaling times speed slider. 0 while the program is paused. After a pause, increases smoothly.
    double getSpeedScalingCombined();
    std::vector<double> getFtRawWrench();     ///< flange frame [N, Nm]
    double getPayload();                      ///< [kg]
    std::vector<double> getPayloadCog();      ///< [m]
    std::vector<double> getPayloadInertia();  ///< [kg m2]

private:
    struct Private;
    std::unique_ptr<Private> d_;
};

}  // namespace ur_rtde
