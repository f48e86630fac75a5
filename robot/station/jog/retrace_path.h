// SPDX-License-Identifier: MIT
#pragma once

// The past path of the arm as joint positions, and the motion back along it while a key is held: the only way out
// of a narrow space that is known to be free.

#include <cstdint>
#include <deque>
#include <functional>
#include <optional>

#include "robot/station/link/hold_motion.h"
#include "robot/station/link/motion_port.h"

namespace tiller {

class RetracePath {
public:
    /// Speed of the fastest joint between two positions [rad/s].
    using Speed = std::function<double(const JointPositions& from, const JointPositions& to)>;

    /// port   moves the arm
    /// speed  on the way back, queried at each turn
    RetracePath(const MotionPort& port, Speed speed);

    /// Adds the position of the arm, except while it goes back. After a jump the path between is unknown: the trail
    /// is restarted.
    void record(const JointPositions& q);
    /// The arm was moved by another program, or the connection has changed: the trail is invalid.
    void clear();
    bool isEmpty() const;
    /// The speed of a press now; 0 if there is nothing to undo.
    double speed() const;
    /// Target of the next turn; nothing if there is nothing to undo.
    std::optional<JointPositions> nextPlace() const;
    int size() const { return static_cast<int>(trail_.size()); }
    /// Positions of the trail, the oldest first, which is the final target.
    const std::deque<JointPositions>& places() const { return trail_; }
    /// Changes whenever the positions change.
    std::uint64_t revision() const { return revision_; }

    /// For the key: a joint jog between the positions of the trail, with the time to live, the limits and the stops
    /// of a jog. It ends at the start of the trail; any stop ends it at its position, and the rest of the trail is
    /// kept.
    HoldMotion motion();

    /// Places nearer than this to the one before are not kept [rad].
    static constexpr double kSpacing = 0.0087;
    static constexpr int kCapacity = 4000;
    /// Further between two pictures of the arm than it can go [rad].
    static constexpr double kJump = 0.15;

private:
    Result<control::JogTarget> next();
    Result<void> permits() const;
    HoldBounds bounds() const;

    const MotionPort& port_;
    Speed speed_;
    std::deque<JointPositions> trail_;
    JointPositions now_;
    std::uint64_t revision_ = 0;
    HoldMotion::Id going_ = 0;  ///< the current jog; 0: none
};

}  // namespace tiller
