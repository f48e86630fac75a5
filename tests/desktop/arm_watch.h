// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Observes the arm with a separate RTDE client, in a process other than that of the window. All times are
// robot times, so that a slow computer does not look like a slow stop.

#include <QString>
#include <functional>
#include <memory>
#include <optional>

#include "robot/core/joints.h"
#include "robot/receive/receiver.h"

namespace tiller::test {

/// Result of observing the arm after the last key was released.
struct Standstill {
    enum class Verdict {
        Stood,   ///< the arm stopped within the time allowed by the jog contract
        Late,    ///< the arm stopped, but too late
        GoesOn,  ///< the arm was still moving a second later
        Blind,   ///< no data were received, so there is no result
    };
    Verdict verdict = Verdict::Blind;
    /// Robot time from the first package after the release to the last package with motion.
    double seconds = 0;
    /// Time in which the program and the display server were ready to run, but other processes used the
    /// processors [s]. The times of both are added.
    double withoutProcessor = 0;
};

/// Threads: one, in addition to that of the receiver.
class ArmWatch {
public:
    /// host  address of the simulated controller
    explicit ArmWatch(const QString& host);

    /// Waits until a package has arrived.
    bool isConnected();
    /// True if the arm moves according to the latest package.
    bool moves();
    /// Waits until the arm has moved for kConnectPending, but at most for this robot time [s].
    bool untilMoving(double seconds);
    /// Waits until the arm has been at standstill for `quiet`, but at most for `seconds` (both are robot
    /// times [s]).
    bool untilStanding(double seconds, double quiet = kQuiet);
    /// Call this immediately after the release. Observes the arm until it has been at standstill for `quiet`,
    /// but at most for kGoesOnAfter.
    /// contract  permitted time until standstill [s]
    /// whileMoving  called for each package with motion
    Standstill standstill(
        double contract, double quiet = kQuiet, const std::function<void()>& whileMoving = [] {});
    /// True if the arm does not move during this robot time [s].
    bool stays(double seconds);

    /// Values in the latest package.
    Vector6 joints();
    Vector6 tcpPose();
    /// The highest commanded joint speed [rad/s].
    double speed();

    /// Time without motion that counts as standstill [s]. Longer than any pause within a motion.
    static constexpr double kQuiet = 0.06;
    /// Minimum duration of a motion before the arm counts as moving [s], so that the release ends an actual
    /// motion.
    static constexpr double kConnectPending = 0.05;
    static constexpr double kGoesOnAfter = 1.0;

private:
    /// Evaluates every package from the time of the call on, until `done` returns true or no package has
    /// arrived for a long time.
    bool follow(const std::function<bool(const receive::Sample&)>& done);
    bool isMoving(const receive::Sample& sample) const;
    double timeOf(const receive::Sample& sample) const { return sample.at(timestamp_); }
    Vector6 six(const char* field);

    receive::Receiver receiver_;
    receive::Sample sample_;
    std::size_t timestamp_ = 0;
};

}  // namespace tiller::test
