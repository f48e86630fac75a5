// SPDX-License-Identifier: MIT
#include "robot/collision/collision_check.h"

#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/capsule.h>
#include <fcl/narrowphase/distance.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "robot/kinematics/arm_kinematics.h"

namespace tiller::collision {
namespace {

using Frames = std::array<Eigen::Isometry3d, 7>;

}  // namespace

struct CollisionCheck::Impl {
    /// A shape of FCL and where it sits on its link.
    struct Body {
        std::shared_ptr<fcl::CollisionGeometryd> shape;
        Eigen::Isometry3d T_link_shape = Eigen::Isometry3d::Identity();
        Capsule rod;  ///< in the link's frame
        int link = 0;
        bool isTool = false;
        double extent = 0;  ///< of its farthest point from the link's origin [m]
    };

    /// Two things that can meet, and how much nearer they can come for each joint that turns.
    struct Pair {
        Contact::With with = Contact::With::Arm;
        std::size_t body = 0;   ///< moves
        std::size_t other = 0;  ///< a body nearer to the base, or a number in Surroundings
        Vector6 radius =
            Vector6::Zero();  ///< of the body about each joint's axis, 0 where it does not matter [m]
    };

    DhParameters dh;
    Surroundings surroundings;
    std::vector<LinkCapsule> capsules;
    std::vector<Body> bodies;
    std::vector<std::pair<std::shared_ptr<fcl::Boxd>, Eigen::Isometry3d>> boxes;
    std::vector<Eigen::Isometry3d> borders;
    std::vector<Pair> pairs;

    static Body bodyOf(const LinkCapsule& part, bool isTool) {
        const Eigen::Vector3d way = part.shape.to - part.shape.from;
        Body body;
        // A sphere is a rod of no length, which FCL has no figure for.
        constexpr double kShortest = 1e-6;
        body.shape = std::make_shared<fcl::Capsuled>(part.shape.radius, std::max(kShortest, way.norm()));
        body.T_link_shape.translation() = (part.shape.from + part.shape.to) / 2;
        if (way.norm() > kShortest) {
            body.T_link_shape.linear() =
                Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), way).toRotationMatrix();
        }
        body.rod = part.shape;
        body.link = part.link;
        body.isTool = isTool;
        body.extent = std::max(part.shape.from.norm(), part.shape.to.norm()) + part.shape.radius;
        return body;
    }

    static double distanceOf(const Body& a, const Eigen::Isometry3d& T_a, const fcl::CollisionGeometryd& b,
                             const Eigen::Isometry3d& T_b) {
        fcl::DistanceRequestd request;
        request.enable_nearest_points = false;
        fcl::DistanceResultd result;
        return fcl::distance(a.shape.get(), T_a, &b, T_b, request, result);
    }

    /// How far any point of the body can be from each joint's axis, for the joints between `fromLink` and it.
    Vector6 radii(const Body& body, int fromLink) const {
        Vector6 result = Vector6::Zero();
        double chain = body.extent;
        for (int joint = body.link; joint > fromLink; --joint) {
            const auto i = static_cast<std::size_t>(joint - 1);
            chain += std::hypot(dh.a[i], dh.d[i]);
            result[joint - 1] = chain;
        }
        return result;
    }

    double distance(const Pair& pair, const JointPositions& q) const {
        const Frames frames = kinematics::linkFrames(dh, q);
        const Body& body = bodies[pair.body];
        const Eigen::Isometry3d& T_base_link = frames[static_cast<std::size_t>(body.link)];
        switch (pair.with) {
            case Contact::With::Arm: {
                const Body& other = bodies[pair.other];
                return distanceOf(body, T_base_link * body.T_link_shape, *other.shape,
                                  frames[static_cast<std::size_t>(other.link)] * other.T_link_shape);
            }
            case Contact::With::Obstacle:
                return distanceOf(body, T_base_link * body.T_link_shape, *boxes[pair.other].first,
                                  boxes[pair.other].second);
            case Contact::With::Border: {
                // Of a rod, one of the ends is nearest to a plane.
                const Eigen::Isometry3d& border = borders[pair.other];
                const Eigen::Vector3d up = border.linear().col(2);
                const double height = std::min(up.dot(T_base_link * body.rod.from - border.translation()),
                                               up.dot(T_base_link * body.rod.to - border.translation()));
                return height - body.rod.radius;
            }
        }
        return 0;
    }

    Contact contactOf(const Pair& pair, double at, const JointPositions& q) const {
        const auto name = [](const Body& body) { return body.isTool ? kToolLink : body.link; };
        return {pair.with, name(bodies[pair.body]),
                pair.with == Contact::With::Arm ? name(bodies[pair.other]) : static_cast<int>(pair.other), at,
                q};
    }
};

CollisionCheck::CollisionCheck(const RobotModel& model, const ToolBody& tool, Surroundings surroundings)
    : d_(std::make_unique<Impl>()) {
    d_->dh = model.dh;
    d_->surroundings = std::move(surroundings);
    d_->capsules = armCapsules(model);
    for (const LinkCapsule& part : d_->capsules) {
        d_->bodies.push_back(Impl::bodyOf(part, false));
    }
    const double length = tool.tcpOffset.position.norm();
    if (tool.radius > 0 && length > 0) {
        // Inside the flange's plane and the TCP, as far as its own roundness lets it.
        const Eigen::Vector3d along = tool.tcpOffset.position / length;
        const double inset = std::min(tool.radius, length / 2);
        d_->capsules.push_back({6, {along * inset, along * (length - inset), tool.radius}, 1, false});
        d_->bodies.push_back(Impl::bodyOf(d_->capsules.back(), true));
    }
    for (const Obstacle& obstacle : d_->surroundings.obstacles) {
        d_->boxes.emplace_back(
            std::make_shared<fcl::Boxd>(obstacle.size.x(), obstacle.size.y(), obstacle.size.z()),
            obstacle.pose.transform());
    }
    for (const Border& border : d_->surroundings.borders) {
        d_->borders.push_back(border.pose.transform());
    }
    for (std::size_t i = 0; i < d_->bodies.size(); ++i) {
        const Impl::Body& body = d_->bodies[i];
        for (std::size_t k = 0; k < d_->bodies.size(); ++k) {
            const Impl::Body& other = d_->bodies[k];
            if (body.link - other.link > d_->capsules[i].neighbours) {
                d_->pairs.push_back({Contact::With::Arm, i, k, d_->radii(body, other.link)});
            }
        }
        if (d_->capsules[i].atFoot) {
            continue;
        }
        for (std::size_t k = 0; k < d_->boxes.size(); ++k) {
            d_->pairs.push_back({Contact::With::Obstacle, i, k, d_->radii(body, 0)});
        }
        for (std::size_t k = 0; k < d_->borders.size(); ++k) {
            d_->pairs.push_back({Contact::With::Border, i, k, d_->radii(body, 0)});
        }
    }
}

CollisionCheck::~CollisionCheck() = default;
CollisionCheck::CollisionCheck(CollisionCheck&&) noexcept = default;
CollisionCheck& CollisionCheck::operator=(CollisionCheck&&) noexcept = default;

const Surroundings& CollisionCheck::surroundings() const {
    return d_->surroundings;
}

const std::vector<LinkCapsule>& CollisionCheck::capsules() const {
    return d_->capsules;
}

std::optional<Contact> CollisionCheck::at(const JointPositions& q) const {
    return along({&q, 1});
}

std::optional<Contact> CollisionCheck::along(std::span<const JointPositions> way) const {
    std::optional<Contact> first;
    if (way.empty()) {
        return first;
    }
    for (const Impl::Pair& pair : d_->pairs) {
        // How much nearer the two may come before they must be looked at again.
        double clearance = d_->distance(pair, way.front());
        if (clearance <= kTouching) {
            return d_->contactOf(pair, 0, way.front());
        }
        for (std::size_t k = 0; k + 1 < way.size(); ++k) {
            if (first && static_cast<double>(k) >= first->at) {
                break;
            }
            const Vector6 turn = way[k + 1].values - way[k].values;
            const double most = pair.radius.dot(turn.cwiseAbs());
            double share = 0;
            while (clearance < most * (1 - share)) {
                share += clearance / most;
                const JointPositions q(way[k].values + share * turn);
                clearance = d_->distance(pair, q);
                if (clearance <= kTouching) {
                    const double at = static_cast<double>(k) + share;
                    if (!first || at < first->at) {
                        first = d_->contactOf(pair, at, q);
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
    return first;
}

}  // namespace tiller::collision
