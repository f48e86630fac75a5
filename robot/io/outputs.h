// SPDX-License-Identifier: MIT
#pragma once

// Sets digital and analog outputs and the speed slider through a separate RTDE connection, with or without a
// running program. Masks leave all other outputs unchanged. A command completes when the robot reports the
// new value. Inputs used by other clients are unavailable; all others remain usable.

#include <QString>
#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "robot/core/deadline.h"
#include "robot/core/result.h"
#include "robot/core/text.h"
#include "robot/receive/receiver.h"
#include "robot/rtde/protocol.h"

namespace tiller::io {

using tiller::operator<<;  // makes the enumerations below printable

/// Bit numbers of the digital outputs.
inline constexpr int kStandardOutputs = 8;    ///< 0 ... 7
inline constexpr int kFirstConfigurable = 8;  ///< 8 ... 15
inline constexpr int kFirstTool = 16;         ///< 16, 17
inline constexpr int kDigitalOutputs = 18;
/// Minimum of the speed slider. Lower values are refused, not clamped, because 0 has caused protective stops. To
/// stop the arm, stop or pause the program.
inline constexpr double kLowestSpeedFraction = 0.02;

/// Values reported by the robot, used for confirmation.
struct Report {
    std::uint64_t sequence =
        0;  ///< increases with every report; only reports newer than the command confirm it
    std::optional<std::uint64_t> digitalOutputs;  ///< bits 0-7 standard, 8-15 configurable, 16-17 tool
    std::optional<double> speedSlider;            ///< 0 ... 1
    /// Both analog outputs as reported by the robot (mA or A, V), and their domains in bits 0 and 1: 0 = current, 1
    /// = voltage.
    std::optional<std::array<double, 2>> analogOutputs;
    unsigned analogDomains = 0;
};
struct OutputFeedback {
    /// Returns the newest report. Called from the thread that waits for a confirmation.
    std::function<Report()> newest;
    /// RTDE names of fields that are never reported. Commands that need them for confirmation are refused.
    std::vector<std::string> absent = {};

    /// Reads the newest sample of a receiver, which must outlive the Outputs object. The receiver has to
    /// subscribe to the fields that confirm the commands used: actual_digital_output_bits,
    /// target_speed_fraction, analog_io_types, standard_analog_output0 and standard_analog_output1.
    static OutputFeedback fromReceiver(const receive::Receiver& receiver);
};

enum class AnalogDomain : std::uint8_t { Current, Voltage };

struct OutputsOptions {
    Text host = {};
    std::uint16_t port = rtde::kPort;
};

/// Threads  any; calls are serialized. There is no internal thread. Call from a worker, because confirmation
///          blocks.
class Outputs {
public:
    Outputs(OutputsOptions options, OutputFeedback feedback);
    ~Outputs();
    Outputs(const Outputs&) = delete;
    Outputs& operator=(const Outputs&) = delete;

    /// Opens a new connection, replacing an existing one. The set functions connect automatically.
    /// Errors  as for rtde::Connection::open(); inputs used by other clients do not cause an error here
    Result<void> connect(const Deadline& deadline);
    /// Disconnects and ends waiting calls. Waits for a connection attempt in progress; the token of its
    /// deadline can cancel the attempt.
    void disconnect();
    /// True if the connection was open when it was last used. Blocks: never
    bool isConnected() const;

    /// Sets the outputs selected by `mask` to the bits of `values`; other outputs are unchanged.
    /// Errors  NotConnected, InvalidArgument (no such output), RegisterInUse (another client uses the inputs
    ///         of this group), FieldUnknown (the robot does not have the input, or the receiver does not
    ///         receive the field that confirms it: nothing was sent), LinkLost, Timeout (sent, but the robot
    ///         does not report it), Cancelled
    /// Blocks  until the robot reports the new values, at most until the deadline
    Result<void> setDigitalOutputs(std::uint32_t mask, std::uint32_t values, const Deadline& deadline);
    /// Sets a single output. Errors and blocking: as for setDigitalOutputs()
    Result<void> setDigitalOutput(int output, bool on, const Deadline& deadline);

    /// fraction  0.02 ... 1
    /// Errors    as for setDigitalOutputs(); InvalidArgument for NaN or a value outside the range, including 0
    Result<void> setSpeedSlider(double fraction, const Deadline& deadline);

    /// Sets the level and the domain of an analog output.
    /// output  0 or 1
    /// level   0 ... 1, for 4 to 20 mA or 0 to 10 V
    /// Errors  as for setDigitalOutputs()
    Result<void> setAnalogOutput(int output, AnalogDomain domain, double level, const Deadline& deadline);

    /// Succeeds if the group of outputs can be set; otherwise the error contains the reason.
    Result<void> canSetDigitalOutput(int output) const;
    Result<void> canSetSpeedSlider() const;   ///< Like canSetDigitalOutput().
    Result<void> canSetAnalogOutput() const;  ///< Like canSetDigitalOutput().

private:
    struct Link;
    std::unique_ptr<Link> d_;
};

}  // namespace tiller::io
