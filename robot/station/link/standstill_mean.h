// SPDX-License-Identifier: MIT
#pragma once

// Mean reading of the force sensor over about one second at rest, because a single sample is too noisy. Any
// motion invalidates the result.

#include <optional>

#include "robot/kinematics/payload_estimation.h"
#include "robot/station/link/session_state.h"

namespace tiller {

class StandstillMean {
public:
    /// Number of averaged states with new data.
    static constexpr int kSamples = 50;

    enum class Outcome { Collecting, Done, Moved, NoForce };

    void begin() { *this = {}; }
    Outcome add(const SessionState& state);
    /// Fraction of the samples collected so far: 0 ... 1.
    double progress() const { return static_cast<double>(count_) / kSamples; }

    /// After Done: the reading at the flange, including everything mounted on it. Also available if the
    /// software does not report the raw value.
    kinematics::PayloadReading reading() const { return reading_; }
    /// After Done: the force at the TCP that remains after subtracting the payload set on the robot, in the
    /// base frame.
    Wrench remaining() const { return remaining_; }
    double payloadMass() const { return payloadMass_; }  ///< Mass set on the robot [kg].

private:
    int count_ = 0;
    std::uint64_t sequence_ = 0;
    Wrench felt_;
    Wrench left_;
    kinematics::PayloadReading reading_;
    Wrench remaining_;
    double payloadMass_ = 0;
};

}  // namespace tiller
