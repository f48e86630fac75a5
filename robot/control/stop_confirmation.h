// SPDX-License-Identifier: MIT
#pragma once

// Follows a stop until the robot's own data confirm it, and decides when to stop on every route to the robot, the
// end of the control program included: when the control connection is silent, when the robot's data are late, and
// when the arm moves on although everything seems to work, because another program has replaced ours.

#include <cstdint>
#include <optional>

namespace tiller::control {

/// What is known at one moment. Speeds, standstill and `stopped` come from the receiver, not from the control
/// connection.
struct StopEvidence {
    std::int64_t nowNs = 0;
    bool fresh = false;               ///< the receiver's data are no older than 100 ms
    std::int64_t dataNs = 0;          ///< when its newest sample arrived
    bool moving = true;               ///< by that sample
    double tcpSpeed = 0;              ///< [m/s]
    double jointSpeed = 0;            ///< of the fastest joint [rad/s]
    bool stopped = false;             ///< no program runs
    bool inControl = false;           ///< by control data no older than 100 ms
    std::uint64_t restingEpoch = 0;   ///< ControllerStatus::restingEpoch
    std::uint64_t executedEpoch = 0;  ///< of the motion that the control program executes; 0: none
};

/// Threads  one
class StopConfirmation {
public:
    /// epoch  of the stop: Controller::stop()
    StopConfirmation(std::uint64_t epoch, const StopEvidence& evidence);

    /// Another stop before the verdict. It is to be confirmed in place of the first, in the time of the first: who presses
    /// again and again does not postpone the verdict.
    void repeat(std::uint64_t epoch) { epoch_ = epoch; }

    enum class Verdict {
        Waiting,
        Confirmed,   ///< the arm is at standstill, and our program says so or none runs
        EveryRoute,  ///< nothing confirms it in time: stop on every route
    };
    /// To be asked every 20 ms or so, until the verdict is another than Waiting.
    Verdict look(const StopEvidence& evidence);

private:
    bool isConfirmed(const StopEvidence& evidence) const;
    bool isSlower(const StopEvidence& evidence) const;

    std::uint64_t epoch_;
    std::int64_t requestNs_;
    std::int64_t lookNs_;  ///< when the speed is compared next
    double tcpSpeed_;      ///< when it was compared last
    double jointSpeed_;
};

}  // namespace tiller::control
