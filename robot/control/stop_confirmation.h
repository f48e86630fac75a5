// SPDX-License-Identifier: MIT
#pragma once

// Monitors a stop until robot data confirm it. Decides when to stop through all interfaces, including the end
// of the control program: if the control connection does not respond, if robot data are late, or if the arm
// keeps moving because another program has replaced the control program.

#include <cstdint>
#include <optional>

namespace tiller::control {

/// Input of the decision. Speeds, standstill and `stopped` come from the receiver instead of the control
/// connection.
struct StopEvidence {
    std::int64_t nowNs = 0;
    bool fresh = false;               ///< the receiver's data are not older than 100 ms
    std::int64_t dataNs = 0;          ///< arrival time of the newest sample
    bool moving = true;               ///< the newest sample reports motion
    double tcpSpeed = 0;              ///< [m/s]
    double jointSpeed = 0;            ///< speed of the fastest joint [rad/s]
    bool stopped = false;             ///< no program is running
    bool inControl = false;           ///< from control data not older than 100 ms
    std::uint64_t restingEpoch = 0;   ///< ControllerStatus::restingEpoch
    std::uint64_t executedEpoch = 0;  ///< id of the motion executed by the control program; 0: none
};

/// Threads  one
class StopConfirmation {
public:
    /// epoch  of the stop, returned by Controller::stop()
    StopConfirmation(std::uint64_t epoch, const StopEvidence& evidence);

    /// Registers another stop before the verdict. Only the new stop must be confirmed, but within the time
    /// limit of the first stop, so that repeated requests do not postpone the verdict.
    void repeat(std::uint64_t epoch) { epoch_ = epoch; }

    enum class Verdict {
        Waiting,
        Confirmed,   ///< standstill confirmed by the control program, or no program is running
        EveryRoute,  ///< not confirmed in time: stop through all interfaces
    };
    /// Call about every 20 ms until it returns a value other than Waiting.
    Verdict look(const StopEvidence& evidence);

private:
    bool isConfirmed(const StopEvidence& evidence) const;
    bool isSlower(const StopEvidence& evidence) const;

    std::uint64_t epoch_;
    std::int64_t requestNs_;
    std::int64_t lookNs_;  ///< time of the next comparison of the speeds
    double tcpSpeed_;      ///< speed at the last comparison
    double jointSpeed_;
};

}  // namespace tiller::control
