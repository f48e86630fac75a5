// SPDX-License-Identifier: MIT
#pragma once

// Distances of the arm, modelled as capsules, from itself and from its surroundings, for a single position or
// a whole path. All joints move uniformly between two positions of a path. No collision is missed, because
// the current clearance limits each step. Jogs use the same distances to slow down before a contact.

#include <array>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "robot/collision/arm_body.h"
#include "robot/collision/surroundings.h"

namespace tiller::collision {

/// A smaller distance counts as contact [m].
inline constexpr double kTouching = 0.0003;
/// A move that starts within the safety distance may come closer by this amount, because the measured joint
/// positions of an arm at rest vary [m].
inline constexpr double kSafetyTolerance = 0.0005;

/// Two bodies in contact.
struct Contact {
    enum class With { Arm, Obstacle, Border };
    With with = With::Arm;
    int link = 0;   ///< link of the arm as in LinkCapsule; kToolLink for the tool
    int other = 0;  ///< the other link, or an index into Surroundings
    /// Position on the path. For example, 2.25 is a quarter of the distance from the third position to the
    /// fourth. 0 for a single position.
    double at = 0;
    JointPositions q;     ///< joint positions at the contact
    double distance = 0;  ///< distance between the bodies [m]; negative if they penetrate
};

inline constexpr int kToolLink = 7;

/// Pairs of bodies of an arm and its tool that can never collide. Pass the same object to consecutive checks
/// of the same arm, because computing the pairs takes about 40 ms, much longer than the rest of a check.
/// Threads  one at a time
class NeverMeeting {
private:
    friend class CollisionCheck;
    std::vector<double> key_;  ///< dimensions of the arm and the tool used for the computation
    std::vector<std::pair<std::size_t, std::size_t>> all_;  ///< indices into CollisionCheck::capsules()
};

class CollisionCheck {
public:
    /// safetyDistance  minimum distance that obstruction() and jogs require [m], 0 or more
    /// known           pairs to reuse; recomputed if the arm or the tool differs. If null, the pairs
    ///                 are computed for this check only.
    CollisionCheck(const RobotModel& model, const ToolBody& tool, Surroundings surroundings,
                   double safetyDistance = kSafetyDistance, NeverMeeting* known = nullptr);

    const Surroundings& surroundings() const { return surroundings_; }  ///< As passed to the constructor.
    double safetyDistance() const { return safetyDistance_; }           ///< As passed to the constructor [m].

    // All functions below can be called from several threads at once and never block. A position with a
    // number that is not finite counts as a contact.

    /// The contact at this position, if any.
    /// Real-time: no (about ten microseconds)
    std::optional<Contact> at(const JointPositions& q) const;
    /// The first contact on the path.
    /// Real-time: no (a millisecond for a path across the work cell)
    std::optional<Contact> along(std::span<const JointPositions> way) const;
    /// The first position on the path at which the safety distance is violated. If the path starts within the
    /// safety distance, only positions closer than the start count, so the arm can move away.
    /// Real-time: as for along()
    std::optional<Contact> obstruction(std::span<const JointPositions> way) const;

    /// True if the two bodies of this contact are closer than the safety distance at this position.
    bool isInside(const JointPositions& q, const Contact& contact) const;

    /// The checked capsules in the frames of their links: first the arm, then the tool.
    const std::vector<LinkCapsule>& capsules() const { return capsules_; }

    /// Two bodies that can collide, and the maximum approach per joint rotation.
    struct Pair {
        Contact::With with = Contact::With::Arm;
        std::size_t body = 0;   ///< moving body: index into capsules()
        std::size_t other = 0;  ///< a body closer to the base, or an index into Surroundings
        int link = 0;           ///< see Contact::link
        int otherLink = 0;      ///< see Contact::other
        double margin = 0;      ///< safety distance between the two for obstruction() and jogs [m]
        /// Radius of the body about each joint axis; 0 if the joint has no effect [m].
        Vector6 radius = Vector6::Zero();
        /// True for an end of the capsule whose distance from the border is the same at all positions. Such
        /// ends are not checked.
        bool fixedFrom = false;
        bool fixedTo = false;
    };
    static constexpr std::size_t kMaxBodies = 16;
    /// The capsules in the base frame.
    using Placement = std::array<Capsule, kMaxBodies>;

    const std::vector<Pair>& pairs() const { return pairs_; }  ///< All pairs that can collide.
    /// The capsules at the joint positions `q`.
    /// Real-time: yes (less than a microsecond)
    Placement place(const JointPositions& q) const;
    /// Distance between the bodies of a pair [m]; negative if they penetrate. Beyond `enough` the result may be a
    /// lower bound, which is cheaper to compute.
    /// Real-time: yes (tens of nanoseconds; a few hundred for a box)
    double distance(const Pair& pair, const Placement& placement, double enough = 1e9) const;

private:
    struct Box {
        Eigen::Isometry3d T_box_base = Eigen::Isometry3d::Identity();
        Eigen::Vector3d half = Eigen::Vector3d::Zero();
    };
    struct Plane {
        Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
        double offset = 0;  ///< distance of the plane along its normal [m]
    };

    void addPairs(std::size_t body, bool isTool);
    std::vector<std::pair<std::size_t, std::size_t>> findNeverMeeting() const;
    void dropPairsThatNeverMeet(NeverMeeting* known);
    void dropWhatNeverNearsABorder();
    Vector6 radii(const LinkCapsule& body, int fromLink) const;
    /// threshold(pair, initial distance) returns the distance below which a pair counts as in contact.
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
