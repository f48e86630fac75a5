// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The arm as seen from outside: an RTDE client of its own, in a process that is not the window's. All times
// are the robot's own, so that a slow machine does not look like a slow stop.

#include <QString>
#include <functional>
#include <memory>
#include <optional>

#include "robot/core/joints.h"
#include "robot/receive/receiver.h"

namespace tiller::test {

/// What became of the arm after the last key was let go.
struct Standstill {
    enum class Verdict {
        Stood,   ///< within the contract
        Late,    ///< it stopped, but later
        GoesOn,  ///< it still moved a second later
        Blind,   ///< no data came: nothing can be said
    };
    Verdict verdict = Verdict::Blind;
    double seconds =
        0;  ///< of the robot's time, from the first package after the release to the last that moved
};

/// Threads  one, besides the receiver's own
class ArmWatch {
public:
    /// host  of the simulated controller
    explicit ArmWatch(const QString& host);

    /// Waits until a package has come.
    bool isConnected();
    /// The newest package says that the arm moves.
    bool moves();
    /// Waits until it has moved for kUnderWay, for at most so much of the robot's time.
    bool untilMoving(double seconds);
    /// Waits until it has not moved for `quiet` seconds of the robot's time, for at most `seconds`.
    bool untilStanding(double seconds, double quiet = kQuiet);
    /// Call it at once after the release. Follows the arm until it has stood for `quiet`.
    /// contract  within which it has to stand [s]
    Standstill standstill(double contract, double quiet = kQuiet);
    /// True when it did not move at all for so much of the robot's time.
    bool stays(double seconds);

    /// Of the newest package.
    Vector6 joints();
    Vector6 tcpPose();
    /// The largest of the joints' commanded speeds [rad/s].
    double speed();

    /// So long without motion counts as standing [s]: longer than anything that only pauses.
    static constexpr double kQuiet = 0.06;
    /// So long with motion is no twitch: a release has something to end [s].
    static constexpr double kUnderWay = 0.05;
    static constexpr double kGoesOnAfter = 1.0;

private:
    /// Looks at every package from now on, until `done` says so or none came for long.
    bool follow(const std::function<bool(const receive::Sample&)>& done);
    bool isMoving(const receive::Sample& sample) const;
    double timeOf(const receive::Sample& sample) const { return sample.at(timestamp_); }
    Vector6 six(const char* field);

    receive::Receiver receiver_;
    receive::Sample sample_;
    std::size_t timestamp_ = 0;
};

}  // namespace tiller::test
