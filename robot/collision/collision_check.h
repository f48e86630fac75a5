// SPDX-License-Identifier: MIT
#pragma once

// How far the arm, as rods with round ends, is from itself and from its surroundings: in one position, and anywhere on
// a path. Between two positions of a path every joint turns evenly; no contact on it is missed, because each step is
// only as long as the clearance allows. The same distances slow a jog down before a contact.

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "robot/collision/arm_body.h"
#include "robot/collision/surroundings.h"

namespace tiller::collision {

/// Nearer than this is a contact [m].
inline constexpr double kTouching = 0.0003;
/// A move from inside the safety distance may come nearer by this much: the joints of an arm at rest tremble [m].
inline constexpr double kSafetyTolerance = 0.0005;

/// Two bodies that meet.
struct Contact {
    enum class With { Arm, Obstacle, Border };
    With with = With::Arm;
    int link = 0;   ///< of the arm, as in LinkCapsule; kToolLink for the tool
    int other = 0;  ///< the other link, or a number in Surroundings
    /// Where on the path: 2.25 is a quarter of the path from the third position to the fourth; 0 in a single position.
    double at = 0;
    JointPositions q;     ///< there
    double distance = 0;  ///< there, below 0 inside each other [m]
};

inline constexpr int kToolLink = 7;

class CollisionCheck {
public:
    /// safetyDistance  that obstruction() and jogs keep [m], 0 or more
    CollisionCheck(const RobotModel& model, const ToolBody& tool, Surroundings surroundings,
                   double safetyDistance = kSafetyDistance);

    const Surroundings& surroundings() const { return surroundings_; }  ///< As given.
    double safetyDistance() const { return safetyDistance_; }           ///< As given [m].

    // All of the following: threads any, several at once; never block.

    /// Real-time: no (some ten microseconds)
    std::optional<Contact> at(const JointPositions& q) const;
    /// The first contact on the path. Real-time: no (a millisecond for a path across the cell)
    std::optional<Contact> along(std::span<const JointPositions> way) const;
    /// The first place on the path that is nearer than the safety distance to something; or, where the path begins
    /// nearer than that, nearer than it is there. What leads out is free. Real-time: as along()
    std::optional<Contact> obstruction(std::span<const JointPositions> way) const;

    /// Whether the two bodies of this contact are nearer than the safety distance in this position.
    bool isInside(const JointPositions& q, const Contact& contact) const;

    /// The rods that are checked: the arm's, then the tool's. In the frame of their link.
    const std::vector<LinkCapsule>& capsules() const { return capsules_; }

    /// Two bodies that can meet, and how much nearer they can come for each joint that turns.
    struct Pair {
        Contact::With with = Contact::With::Arm;
        std::size_t body = 0;   ///< moves: a number in capsules()
        std::size_t other = 0;  ///< a body nearer to the base, or a number in Surroundings
        int link = 0;           ///< as Contact::link
        int otherLink = 0;      ///< as Contact::other
        double margin = 0;      ///< that obstruction() and jogs keep between the two [m]
        /// Of the body about each joint's axis, 0 where it does not matter [m].
        Vector6 radius = Vector6::Zero();
        /// An end of the rod whose distance from the border no joint changes: it is not measured.
        bool fixedFrom = false;
        bool fixedTo = false;
    };
    static constexpr std::size_t kMaxBodies = 16;
    /// The rods in the base frame.
    using Placement = std::array<Capsule, kMaxBodies>;

    const std::vector<Pair>& pairs() const { return pairs_; }  ///< All that can meet.
    /// Real-time: yes (less than a microsecond)
    Placement place(const JointPositions& q) const;
    /// Between the two, below 0 inside each other [m]. Beyond `enough` it may be less than it really is, and then comes
    /// at less cost. Real-time: yes (some ten nanoseconds, a box some hundred)
    double distance(const Pair& pair, const Placement& placement, double enough = 1e9) const;

private:
    struct Box {
        Eigen::Isometry3d T_box_base = Eigen::Isometry3d::Identity();
        Eigen::Vector3d half = Eigen::Vector3d::Zero();
    };
    struct Plane {
        Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
        double offset = 0;  ///< of the plane along its normal [m]
    };

    void addPairs(std::size_t body, bool isTool);
    void dropPairsThatNeverMeet();
    void dropWhatNeverNearsABorder();
    Vector6 radii(const LinkCapsule& body, int fromLink) const;
    /// threshold(pair, its distance at the start): below it the two count as in contact.
    template <class Threshold>
    std::optional<Contact> first(std::span<const JointPositions> way, const Threshold& threshold) const;

    DhParameters dh_;
    Surroundings surroundings_;
    double safetyDistance_ = kSafetyDistance;
    std::vector<LinkCapsule> capsules_;
    std::vector<Box> boxes_;
    std::vector<Plane> planes_;
    std::vector<Pair> pairs_;
};

}  // namespace tiller::collision
