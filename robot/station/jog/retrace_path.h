// SPDX-License-Identifier: MIT
#pragma once

// The past path of the arm as joint positions, and the motion back along it while a key is held: the only
// path out of a narrow space that is known to be free.

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
    /// speed  on the way back, queried for each segment
    RetracePath(const MotionPort& port, Speed speed);

    /// Adds the position of the arm, except while it moves back. After a jump the path in between is unknown,
    /// so the trail is restarted.
    void record(const JointPositions& q);
    /// The arm was moved by another program, or the connection has changed: the trail is invalid.
    void clear();
    bool isEmpty() const;
    /// The speed of a press now; 0 if no trail is left.
    double speed() const;
    /// Target of the next segment; nothing if no trail is left.
    std::optional<JointPositions> nextPlace() const;
    int size() const { return static_cast<int>(trail_.size()); }
    /// Positions of the trail, the oldest first, which is the final target.
    const std::deque<JointPositions>& places() const { return trail_; }
    /// Changes whenever the positions change.
    std::uint64_t revision() const { return revision_; }

    /// The motion for the key: a joint jog between the positions of the trail, with the heartbeat timeout,
    /// limits and stops of a jog. It ends at the start of the trail; a stop ends it earlier, and the rest of
    /// the trail is kept.
    HoldMotion motion();

    /// Positions closer than this to the previous one are not recorded [rad].
    static constexpr double kSpacing = 0.0087;
    static constexpr int kCapacity = 4000;
    /// A larger change between two reported positions is a jump [rad].
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
