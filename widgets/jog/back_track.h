// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The way the arm came, as joint positions, and the motion that goes back along it while a key is held: the
// one way out of a tight place that is known to be free.

#include <deque>
#include <functional>
#include <optional>

#include "widgets/common/hold_guard.h"
#include "widgets/jog/jog_port.h"

namespace tiller {

class BackTrack {
public:
    /// port    what moves the arm
    /// moveTo  the bounded joint move to a place of the trail
    BackTrack(const JogPort& port, std::function<MoveRequest(const JointPositions&)> moveTo);

    /// Where the arm is now. While the arm goes back nothing is added.
    void record(const JointPositions& q);
    /// The arm was moved by somebody else, or the connection is another one: the trail says nothing any more.
    void clear();
    bool isEmpty() const;
    int size() const { return static_cast<int>(trail_.size()); }

    /// For the key. It ends at the beginning of the trail; a stop of any kind ends it where it is, and what
    /// is left of the trail stays.
    HoldMotion motion();

    /// Places nearer than this to the one before are not kept [rad].
    static constexpr double kSpacing = 0.0087;
    static constexpr int kCapacity = 400;

private:
    Result<HoldMotion::Id> next();

    const JogPort& port_;
    std::function<MoveRequest(const JointPositions&)> moveTo_;
    std::deque<JointPositions> trail_;
    JointPositions now_;
    HoldMotion::Id leg_ = 0;  ///< the move under way; 0: none
};

}  // namespace tiller
