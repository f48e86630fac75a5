// SPDX-License-Identifier: MIT
#pragma once

// Whether the arm, as rods with round ends, runs into itself or into what stands around it: in one stance, or
// anywhere on a way. Between two stances of a way every joint turns evenly; nothing on it is passed over, because
// each step is only as long as the clearance allows.

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "robot/collision/arm_body.h"
#include "robot/collision/surroundings.h"

namespace tiller::collision {

/// Nearer than this is a contact [m].
inline constexpr double kTouching = 0.0003;

/// The first two things that meet.
struct Contact {
    enum class With { Arm, Obstacle, Border };
    With with = With::Arm;
    int link = 0;   ///< of the arm, as in LinkCapsule; kToolLink for the tool
    int other = 0;  ///< the other link, or a number in Surroundings
    /// Where on the way: 2.25 is a quarter of the way from the third stance to the fourth; 0 in a single stance.
    double at = 0;
    JointPositions q;  ///< there
};

inline constexpr int kToolLink = 7;

class CollisionCheck {
public:
    CollisionCheck(const RobotModel& model, const ToolBody& tool, Surroundings surroundings);
    ~CollisionCheck();
    CollisionCheck(CollisionCheck&&) noexcept;
    CollisionCheck& operator=(CollisionCheck&&) noexcept;

    const Surroundings& surroundings() const;  ///< As given.

    /// Threads  any, several at once. Blocks: never. Real-time: no (some ten microseconds)
    std::optional<Contact> at(const JointPositions& q) const;
    /// The first contact on the way. As at(); a millisecond or two for a way across the cell.
    std::optional<Contact> along(std::span<const JointPositions> way) const;

    /// The rods that are checked: the arm's, then the tool's. In the frame of their link.
    const std::vector<LinkCapsule>& capsules() const;

private:
    struct Impl;
    std::unique_ptr<Impl> d_;
};

}  // namespace tiller::collision
