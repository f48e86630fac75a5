// SPDX-License-Identifier: MIT
#pragma once

// Sets digital and analog outputs and the speed slider through an RTDE connection of its own, whether or not
// a program runs. Only the bits asked for are touched (masks), and a command is done when the robot reports
// the new value, not when it was sent. Others may own some of these inputs: then only those are unavailable,
// and say so.

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

using tiller::operator<<;  // for the enumerations below

/// Digital outputs as the robot numbers their bits.
inline constexpr int kStandardOutputs = 8;    ///< 0 ... 7
inline constexpr int kFirstConfigurable = 8;  ///< 8 ... 15
inline constexpr int kFirstTool = 16;         ///< 16, 17
inline constexpr int kDigitalOutputs = 18;
/// The lowest place of the slider. Below it the arm would creep, and at zero it has caused protective stops:
/// such wishes are refused, never carried out as another speed than was asked for. Whoever wants the arm to
/// hold still stops or pauses it.
inline constexpr double kLowestSpeedFraction = 0.02;

/// What the robot reports, for confirmation.
struct Report {
    std::uint64_t sequence = 0;  ///< rises with every report; only newer ones than the command confirm it
    std::optional<std::uint64_t> digitalOutputs;  ///< bits 0-7 standard, 8-15 configurable, 16-17 tool
    std::optional<double> speedSlider;            ///< 0 ... 1
    /// Both analog outputs as the robot writes them (mA or A, V), and bit 0, 1: 0 current, 1 voltage.
    std::optional<std::array<double, 2>> analogOutputs;
    unsigned analogDomains = 0;
};
struct OutputFeedback {
    /// The newest report; called from the thread that waits for a confirmation.
    std::function<Report()> newest;
    /// RTDE names of what it never reports: commands that these would confirm are refused.
    std::vector<std::string> absent = {};

    /// From the newest sample of a receiver, which must outlive the Outputs. It has to follow actual_digital_output_bits,
    /// target_speed_fraction, analog_io_types, standard_analog_output0 and standard_analog_output1, as far as these are set.
    static OutputFeedback fromReceiver(const receive::Receiver& receiver);
};

enum class AnalogDomain : std::uint8_t { Current, Voltage };

struct OutputsOptions {
    Text host = {};
    std::uint16_t port = rtde::kPort;
};

/// Threads  any; calls are carried out one after the other. Has no thread of its own: call from a worker,
///          since confirmation waits.
class Outputs {
public:
    Outputs(OutputsOptions options, OutputFeedback feedback);
    ~Outputs();
    Outputs(const Outputs&) = delete;
    Outputs& operator=(const Outputs&) = delete;

    /// Connects anew, whatever there was before. Setting something without a connection tries it by itself.
    /// Errors  as rtde::Connection::open; inputs owned by others are no error here
    Result<void> connect(const Deadline& deadline);
    /// Ends waiting calls too; waits for one that is connecting (its deadline's token cancels that).
    void disconnect();
    /// Whether the connection stood when it was last used. Blocks: never
    bool isConnected() const;

    /// Sets the outputs whose bit is set in `mask` to their bit in `values`, others stay.
    /// Errors  NotConnected, InvalidArgument (no such output), RegisterInUse (who asks reads which inputs are
    ///         owned by another client), FieldUnknown (this robot has no such input, or the receiver does not follow the
    ///         field that confirms it: nothing was sent), LinkLost, Timeout
    ///         (sent, but the robot does not report it), Cancelled
    /// Blocks  until the robot reports the new values, at most until the deadline
    Result<void> setDigitalOutputs(std::uint32_t mask, std::uint32_t values, const Deadline& deadline);
    /// Returns when the robot reports it.
    Result<void> setDigitalOutput(int output, bool on, const Deadline& deadline);

    /// fraction  0.02 ... 1
    /// Errors    as setDigitalOutputs; InvalidArgument when it is no number or outside that range, 0 included
    Result<void> setSpeedSlider(double fraction, const Deadline& deadline);

    /// output  0 or 1
    /// level   0 ... 1 of 4 to 20 mA or 0 to 10 V. The domain is set with it: never left to what it was.
    /// Errors  as setDigitalOutputs
    Result<void> setAnalogOutput(int output, AnalogDomain domain, double level, const Deadline& deadline);

    /// Whether a group of outputs can be set; the error says why not.
    Result<void> canSetDigitalOutput(int output) const;
    Result<void> canSetSpeedSlider() const;   ///< Why not, if not.
    Result<void> canSetAnalogOutput() const;  ///< Why not, if not.

private:
    struct Link;
    std::unique_ptr<Link> d_;
};

}  // namespace tiller::io
