// SPDX-License-Identifier: MIT
#include "robot/collision/collision_check.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "robot/kinematics/arm_kinematics.h"

namespace tiller::collision {
namespace {

using Eigen::Vector3d;

/// Distance between two segments [m].
double segmentDistance(const Capsule& a, const Capsule& b) {
    constexpr double kPoint2 = 1e-18;  // a shorter segment is treated as a point (squared length) [m2]
    const Vector3d u = a.to - a.from;
    const Vector3d v = b.to - b.from;
    const Vector3d r = a.from - b.from;
    const double uu = u.squaredNorm();
    const double vv = v.squaredNorm();
    const double vr = v.dot(r);
    double s = 0;
    double t = 0;
    if (uu <= kPoint2) {
        t = vv <= kPoint2 ? 0 : std::clamp(vr / vv, 0.0, 1.0);
    } else {
        const double ur = u.dot(r);
        if (vv <= kPoint2) {
            s = std::clamp(-ur / uu, 0.0, 1.0);
        } else {
            const double uv = u.dot(v);
            const double parallel = uu * vv - uv * uv;
            s = parallel > 1e-12 * uu * vv ? std::clamp((uv * vr - ur * vv) / parallel, 0.0, 1.0) : 0;
            t = (uv * s + vr) / vv;
            if (t < 0 || t > 1) {
                t = std::clamp(t, 0.0, 1.0);
                s = std::clamp((uv * t - ur) / uu, 0.0, 1.0);
            }
        }
    }
    return (r + s * u - t * v).norm();
}

/// Distance of a point from a box, negative inside [m]. A convex function of the point.
double boxDistance(const Vector3d& point, const Vector3d& half) {
    const Vector3d outside = point.cwiseAbs() - half;
    const double inside = outside.maxCoeff();
    return inside > 0 ? outside.cwiseMax(0).norm() : inside;
}

/// Distance of a segment from a box [m].
double boxDistance(const Vector3d& from, const Vector3d& to, const Vector3d& half) {
    // Golden-section search finds the minimum of a convex function.
    constexpr double kGolden = 0.6180339887498949;
    constexpr int kSections = 48;  // remaining interval below one nanometre
    const Vector3d along = to - from;
    double low = 0;
    double high = 1;
    double a = high - kGolden * (high - low);
    double b = low + kGolden * (high - low);
    double atA = boxDistance(from + a * along, half);
    double atB = boxDistance(from + b * along, half);
    for (int i = 0; i < kSections; ++i) {
        if (atA < atB) {
            high = b;
            b = a;
            atB = atA;
            a = high - kGolden * (high - low);
            atA = boxDistance(from + a * along, half);
        } else {
            low = a;
            a = b;
            atA = atB;
            b = low + kGolden * (high - low);
            atB = boxDistance(from + b * along, half);
        }
    }
    return std::min({atA, atB, boxDistance(from, half), boxDistance(to, half)});
}

double halfLength(const Capsule& rod) {
    return (rod.to - rod.from).norm() / 2;
}

}  // namespace

CollisionCheck::CollisionCheck(const RobotModel& model, const ToolBody& tool, Surroundings surroundings,
                               double safetyDistance, NeverMeeting* known)
    : dh_(model.dh)
    , surroundings_(std::move(surroundings))
    , safetyDistance_(safetyDistance)
    , capsules_(armCapsules(model)) {
    const std::size_t armBodies = capsules_.size();
    const double length = tool.tcpOffset.position.norm();
    if (tool.radius > 0 && length > 0) {
        // The capsule is between the plane of the flange and the TCP. Its segment is shortened by the length
        // of the hemispherical ends, if possible.
        const Vector3d along = tool.tcpOffset.position / length;
        const double inset = std::min(tool.radius, length / 2);
        capsules_.push_back({6, {along * inset, along * (length - inset), tool.radius}, 1, false});
    }
    Q_ASSERT(capsules_.size() <= kMaxBodies);
    for (const Obstacle& obstacle : surroundings_.obstacles) {
        boxes_.push_back({obstacle.pose.transform().inverse(Eigen::Isometry), obstacle.size / 2});
    }
    for (const Border& border : surroundings_.borders) {
        const Eigen::Isometry3d T = border.pose.transform();
        planes_.push_back({T.linear().col(2), T.linear().col(2).dot(T.translation())});
    }
    for (std::size_t i = 0; i < capsules_.size(); ++i) {
        addPairs(i, i >= armBodies);
    }
    dropPairsThatNeverMeet(known);
    dropWhatNeverNearsABorder();
}

void CollisionCheck::addPairs(std::size_t body, bool isTool) {
    const LinkCapsule& part = capsules_[body];
    Pair pair;
    pair.body = body;
    pair.link = isTool ? kToolLink : part.link;
    pair.margin = safetyDistance_;
    for (std::size_t k = 0; k < capsules_.size(); ++k) {
        const int link = capsules_[k].link;
        if (part.link - link > part.neighbours) {
            pair.other = k;
            pair.otherLink = link;
            pair.radius = radii(part, link);
            pairs_.push_back(pair);
        }
    }
    if (part.atFoot) {
        return;
    }
    pair.radius = radii(part, 0);
    pair.with = Contact::With::Obstacle;
    for (std::size_t k = 0; k < boxes_.size(); ++k) {
        pair.other = k;
        pair.otherLink = static_cast<int>(k);
        pairs_.push_back(pair);
    }
    pair.with = Contact::With::Border;
    for (std::size_t k = 0; k < planes_.size(); ++k) {
        pair.other = k;
        pair.otherLink = static_cast<int>(k);
        pairs_.push_back(pair);
    }
}

/// Two bodies with two joints between them never come closer than a certain minimum distance. If there is no
/// contact at this distance, the pair is not checked, regardless of the safety distance.
std::vector<std::pair<std::size_t, std::size_t>> CollisionCheck::findNeverMeeting() const {
    constexpr int kSteps = 36;              // steps per turn
    constexpr double kNeverNearer = 0.002;  // tolerance for minima between two steps [m]
    constexpr int kJointsBetween = 2;
    std::vector<std::pair<std::size_t, std::size_t>> found;
    for (int base = 0; base + kJointsBetween <= kJointCount; ++base) {
        std::vector<std::pair<Pair, double>> judged;  // pairs with their minimum distance [m]
        for (const Pair& pair : pairs_) {
            if (pair.with == Contact::With::Arm && pair.otherLink == base &&
                std::min(pair.link, 6) - base == kJointsBetween) {
                judged.emplace_back(pair, 1e9);
            }
        }
        for (int n = 0; n < kSteps * kSteps; ++n) {
            constexpr double kStep = 2 * std::numbers::pi / kSteps;
            JointPositions q;
            q[base] = kStep * (n / kSteps);
            q[base + 1] = kStep * (n % kSteps);
            const Placement placement = place(q);
            for (auto& [pair, least] : judged) {
                if (least > kNeverNearer) {
                    least = std::min(least, distance(pair, placement, least));
                }
            }
        }
        for (const auto& [pair, least] : judged) {
            if (least > kNeverNearer) {
                found.emplace_back(pair.body, pair.other);
            }
        }
    }
    return found;
}

void CollisionCheck::dropPairsThatNeverMeet(NeverMeeting* known) {
    NeverMeeting own;
    NeverMeeting& memo = known != nullptr ? *known : own;
    std::vector<double> key;
    for (std::size_t i = 0; i < dh_.a.size(); ++i) {
        key.insert(key.end(), {dh_.a[i], dh_.d[i], dh_.alpha[i], dh_.theta[i], dh_.beta[i]});
    }
    for (const LinkCapsule& part : capsules_) {
        key.insert(key.end(), {double(part.link), double(part.neighbours), part.shape.radius,
                               part.shape.from.x(), part.shape.from.y(), part.shape.from.z(),
                               part.shape.to.x(), part.shape.to.y(), part.shape.to.z()});
    }
    if (memo.key_ != key) {
        memo.all_ = findNeverMeeting();
        memo.key_ = std::move(key);
    }
    std::erase_if(pairs_, [&memo](const Pair& pair) {
        return pair.with == Contact::With::Arm &&
               std::find(memo.all_.begin(), memo.all_.end(), std::pair(pair.body, pair.other)) !=
                   memo.all_.end();
    });
}

/// If the arm is mounted upright, the distance of the shoulder from a horizontal border is the same for all
/// joint positions. Such pairs are not checked, even if their distance is below the safety distance.
void CollisionCheck::dropWhatNeverNearsABorder() {
    constexpr int kSteps = 4;  // steps per turn; the height is a sine function of each joint position
    constexpr double kSameHeight = 0.002;  // tolerance: a calibrated axis is not horizontal [m]
    constexpr int kLastFixedLink = 2;      // joint 3 changes the height
    std::array<Placement, kSteps * kSteps> placements;
    for (std::size_t n = 0; n < placements.size(); ++n) {
        constexpr double kStep = 2 * std::numbers::pi / kSteps;
        JointPositions q;
        q[0] = kStep * static_cast<double>(n / kSteps);
        q[1] = kStep * static_cast<double>(n % kSteps);
        placements[n] = place(q);
    }
    const auto isFixed = [&](const Pair& pair, Vector3d Capsule::*end) {
        const Vector3d& normal = planes_[pair.other].normal;
        double low = 1e9;
        double high = -1e9;
        for (const Placement& placement : placements) {
            const double height = normal.dot(placement[pair.body].*end);
            low = std::min(low, height);
            high = std::max(high, height);
        }
        return high - low < kSameHeight;
    };
    std::erase_if(pairs_, [&](Pair& pair) {
        if (pair.with != Contact::With::Border || capsules_[pair.body].link > kLastFixedLink) {
            return false;
        }
        pair.fixedFrom = isFixed(pair, &Capsule::from);
        pair.fixedTo = isFixed(pair, &Capsule::to);
        return pair.fixedFrom && pair.fixedTo;
    });
}

/// Upper bound of the distance of any point of the body from each joint axis, for the joints between
/// `fromLink` and the body.
Vector6 CollisionCheck::radii(const LinkCapsule& body, int fromLink) const {
    Vector6 result = Vector6::Zero();
    double chain = std::max(body.shape.from.norm(), body.shape.to.norm()) + body.shape.radius;
    for (int joint = body.link; joint > fromLink; --joint) {
        const auto i = static_cast<std::size_t>(joint - 1);
        chain += std::hypot(dh_.a[i], dh_.d[i]);
        result[joint - 1] = chain;
    }
    return result;
}

CollisionCheck::Placement CollisionCheck::place(const JointPositions& q) const {
    const auto frames = kinematics::linkFrames(dh_, q);
    Placement placed;
    for (std::size_t i = 0; i < capsules_.size(); ++i) {
        const LinkCapsule& part = capsules_[i];
        const Eigen::Isometry3d& frame = frames[static_cast<std::size_t>(part.link)];
        placed[i] = {frame * part.shape.from, frame * part.shape.to, part.shape.radius};
    }
    return placed;
}

double CollisionCheck::distance(const Pair& pair, const Placement& placement, double enough) const {
    const Capsule& rod = placement[pair.body];
    switch (pair.with) {
        case Contact::With::Arm: {
            const Capsule& other = placement[pair.other];
            const double radii = rod.radius + other.radius;
            const double least = (rod.from + rod.to - other.from - other.to).norm() / 2 - halfLength(rod) -
                                 halfLength(other) - radii;
            return least > enough ? least : segmentDistance(rod, other) - radii;
        }
        case Contact::With::Obstacle: {
            const Box& box = boxes_[pair.other];
            const Vector3d from = box.T_box_base * rod.from;
            const Vector3d to = box.T_box_base * rod.to;
            const double least = boxDistance((from + to) / 2, box.half) - halfLength(rod) - rod.radius;
            return least > enough ? least : boxDistance(from, to, box.half) - rod.radius;
        }
        case Contact::With::Border: {
            // The point of a capsule nearest to a plane is at one of its ends.
            const Plane& plane = planes_[pair.other];
            const double from = plane.normal.dot(rod.from);
            const double to = plane.normal.dot(rod.to);
            const double nearest = pair.fixedFrom ? to : pair.fixedTo ? from : std::min(from, to);
            return nearest - plane.offset - rod.radius;
        }
    }
    return 0;
}

template <class Threshold>
std::optional<Contact> CollisionCheck::first(std::span<const JointPositions> way,
                                             const Threshold& threshold) const {
    std::optional<Contact> found;
    if (way.empty()) {
        return found;
    }
    const auto contactOf = [](const Pair& pair, double at, const JointPositions& q, double distance) {
        return Contact{pair.with, pair.link, pair.otherLink, at, q, distance};
    };
    const Placement start = place(way.front());
    for (const Pair& pair : pairs_) {
        double here = distance(pair, start);
        const double least = threshold(pair, here);
        // The remaining clearance limits the next step.
        double clearance = here - least;
        if (!(clearance > kTouching)) {  // also true if a number is not finite
            return contactOf(pair, 0, way.front(), here);
        }
        for (std::size_t k = 0; k + 1 < way.size(); ++k) {
            if (found && static_cast<double>(k) >= found->at) {
                break;
            }
            const Vector6 turn = way[k + 1].values - way[k].values;
            if (!turn.allFinite()) {
                found = contactOf(pair, static_cast<double>(k + 1), way[k + 1], here);
                break;
            }
            const double most = pair.radius.dot(turn.cwiseAbs());
            double share = 0;
            while (clearance < most * (1 - share)) {
                share += clearance / most;
                const JointPositions q(way[k].values + share * turn);
                here = distance(pair, place(q));
                clearance = here - least;
                if (clearance <= kTouching) {
                    const double at = static_cast<double>(k) + share;
                    if (!found || at < found->at) {
                        found = contactOf(pair, at, q, here);
                    }
                    break;
                }
            }
            if (clearance <= kTouching) {
                break;
            }
            clearance -= most * (1 - share);
        }
    }
    return found;
}

bool CollisionCheck::isInside(const JointPositions& q, const Contact& contact) const {
    const Placement placement = place(q);
    return std::any_of(pairs_.begin(), pairs_.end(), [&](const Pair& pair) {
        return pair.with == contact.with && pair.link == contact.link && pair.otherLink == contact.other &&
               distance(pair, placement, pair.margin) < pair.margin;
    });
}

std::optional<Contact> CollisionCheck::at(const JointPositions& q) const {
    return along({&q, 1});
}

std::optional<Contact> CollisionCheck::along(std::span<const JointPositions> way) const {
    return first(way, [](const Pair&, double) { return 0.0; });
}

std::optional<Contact> CollisionCheck::obstruction(std::span<const JointPositions> way) const {
    return first(way, [](const Pair& pair, double start) {
        return std::min(pair.margin, start - kSafetyTolerance) - kTouching;
    });
}

}  // namespace tiller::collision
