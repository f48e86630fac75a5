// SPDX-License-Identifier: MIT
#pragma once

// The way the arm came, as joint positions, and the motion that goes back along it while a key is held: the
// one way out of a tight place that is known to be free.

#include <cstdint>
#include <deque>
#include <functional>
#include <optional>

#include "robot/station/link/hold_motion.h"
#include "robot/station/link/motion_port.h"

namespace tiller {

class RetracePath {
public:
    /// Of the joint that turns fastest, on the way from one place to another [rad/s].
    using Speed = std::function<double(const JointPositions& from, const JointPositions& to)>;

    /// port   what moves the arm
    /// speed  on the way back, asked at each turn
    RetracePath(const MotionPort& port, Speed speed);

    /// Where the arm is now. While the arm goes back nothing is added. A jump means that the way between is
    /// not known: then the trail begins anew.
    void record(const JointPositions& q);
    /// The arm was moved by somebody else, or the connection is another one: the trail says nothing any more.
    void clear();
    bool isEmpty() const;
    /// The speed with which a press would go back now; 0 where there is nothing to undo.
    double speed() const;
    /// What the next turn heads for; nothing where there is nothing to undo.
    std::optional<JointPositions> nextPlace() const;
    int size() const { return static_cast<int>(trail_.size()); }
    /// Its places, the oldest first: where a press leads to last.
    const std::deque<JointPositions>& places() const { return trail_; }
    /// Another number whenever the places are others.
    std::uint64_t revision() const { return revision_; }

    /// For the key: a joint jog from place to place of the trail, so that it has the life time, the limits
    /// and the stops of a jog. It ends at the beginning of the trail; a stop of any kind ends it where it is,
    /// and what is left of the trail stays.
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
    HoldMotion::Id going_ = 0;  ///< the jog under way; 0: none
};

}  // namespace tiller
