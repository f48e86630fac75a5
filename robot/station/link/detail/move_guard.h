// SPDX-License-Identifier: MIT
#pragma once

// The collision model of the arm and its environment, for checking moves. Updated when the arm, its tool or
// its environment changes.

#include <memory>
#include <span>
#include <vector>

#include "robot/collision/move_check.h"
#include "robot/control/motion_path.h"
#include "robot/station/link/robot_session.h"

namespace tiller {

class MoveGuard {
public:
    void setSurroundings(const collision::CellSurroundings& cell);
    const collision::CellSurroundings& surroundings() const { return cell_; }
    /// Updates the arm and its tool.
    /// Returns  true if check() has changed
    bool follow(const SessionState& state);
    void forget() { check_.reset(); }  ///< Call when no arm is connected.
    /// The current collision model; null if no arm is connected.
    const std::shared_ptr<const collision::CollisionCheck>& check() const { return check_; }

    /// Checks moves in sequence from the current arm position.
    /// Errors  NoSolution with a sentence that names the part of the arm, the object and the position on the
    ///         path, or the object whose position is unknown
    Result<void> permit(const SessionState& state, std::span<const MoveRequest> moves) const;
    /// Checks a path of joint positions from the current arm position.
    Result<void> permit(const SessionState& state, std::span<const JointPositions> way) const;
    /// Checks a path with its blends.
    Result<void> permit(const SessionState& state, const control::MotionPath& path) const;

private:
    struct Leg {
        control::PathEntry::Target target;
        bool linear = false;
        double blend = 0;  ///< [m]
        int point = 0;     ///< number of its path point, from 1
    };
    Result<void> permit(const JointPositions& start, const std::vector<Leg>& legs) const;
    /// Errors  NoSolution while the position of an object is unknown
    Result<void> permitsAny() const;
    static Error refusal(const QString& reason);

    collision::CellSurroundings cell_;
    RobotModel arm_;
    Pose tcpOffset_;
    std::shared_ptr<const collision::CollisionCheck> check_;
    collision::NeverMeeting
        neverMeeting_;  ///< pairs for `arm_`; reused because the cell changes more often than the arm
};

}  // namespace tiller
