// SPDX-License-Identifier: MIT
#pragma once

// What the force sensor feels, as the mean of a second at rest: one sample alone is noise. A movement spoils it.

#include <optional>

#include "robot/kinematics/payload_estimation.h"
#include "robot/station/link/session_state.h"

namespace tiller {

class StandstillMean {
public:
    /// So many states with new data make a mean.
    static constexpr int kSamples = 50;

    enum class Outcome { Collecting, Done, Moved, NoForce };

    void begin() { *this = {}; }
    /// Feeds the next state.
    Outcome add(const SessionState& state);
    /// 0 ... 1
    double progress() const { return static_cast<double>(count_) / kSamples; }

    /// After Done: at the flange, with all that hangs there, whether or not the software tells the raw reading.
    kinematics::PayloadReading reading() const { return reading_; }
    /// After Done: what remains at the TCP when the payload the robot knows of is taken away, in the base frame.
    Wrench remaining() const { return remaining_; }
    double payloadMass() const { return payloadMass_; }  ///< what the robot knows of [kg]

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
