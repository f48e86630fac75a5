// SPDX-License-Identifier: MIT
#pragma once

// The recorded trail of the arm as joint positions, and the motion back along the trail while a button is
// held. In a narrow space, the trail may be the only path that is known to be free.

#include <cstdint>
#include <deque>
#include <functional>
#include <optional>

#include "robot/station/link/hold_motion.h"
#include "robot/station/link/motion_port.h"

namespace tiller {

class RetracePath {
public:
    /// Returns the speed of the fastest joint between two positions [rad/s].
    using Speed = std::function<double(const JointPositions& from, const JointPositions& to)>;

    /// port   moves the arm
    /// speed  returns the speed along a segment of the trail; called for each segment
    RetracePath(const MotionPort& port, Speed speed);

    /// Adds the arm position, except while the arm moves back. After a jump, the path in between is unknown,
    /// so the trail starts again.
    void record(const JointPositions& q);
    /// Discards the trail. Call when another program has moved the arm or when the connection has changed.
    void clear();
    bool isEmpty() const;
    /// Speed that the motion would have; 0 without a trail.
    double speed() const;
    /// Target of the next segment; empty without a trail.
    std::optional<JointPositions> nextPlace() const;
    int size() const { return static_cast<int>(trail_.size()); }
    /// Positions of the trail. The first position is the oldest, and the final target of the motion.
    const std::deque<JointPositions>& places() const { return trail_; }
    /// Changes with every change of the positions.
    std::uint64_t revision() const { return revision_; }

    /// The motion of the button: a joint jog between the positions of the trail, with the heartbeat timeout,
    /// limits and stops of a jog. It ends at the start of the trail, or before a part where the arm would be
    /// too close to an obstacle. That part and the older trail are discarded. After a stop, the remaining
    /// trail is kept.
    HoldMotion motion();

    /// Positions closer than this to the previous position are not recorded [rad].
    static constexpr double kSpacing = 0.0087;
    static constexpr int kCapacity = 4000;
    /// A larger change between two reported positions is a jump [rad].
    static constexpr double kJump = 0.15;

private:
    Result<control::JogTarget> next();
    Result<void> keepPermitted();
    HoldBounds bounds() const;

    const MotionPort& port_;
    Speed speed_;
    std::deque<JointPositions> trail_;
    JointPositions now_;
    std::uint64_t revision_ = 0;
    HoldMotion::Id going_ = 0;  ///< the current jog; 0: no jog
};

}  // namespace tiller
