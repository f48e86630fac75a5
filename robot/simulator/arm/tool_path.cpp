// SPDX-License-Identifier: MIT
#include "robot/simulator/arm/tool_path.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "robot/core/angles.h"
#include "robot/simulator/arm/arm_geometry.h"

namespace tiller::simulator::arm {

namespace {
constexpr double kTiny = 1e-9;

// Rotation vector from A to B in base axes: R_B = exp(vector) * R_A.
Eigen::Vector3d turnBetween(const Eigen::Quaterniond& A, const Eigen::Quaterniond& B) {
    return vectorFromQuaternion(B * A.conjugate());
}
}  // namespace

Eigen::Isometry3d ToolPoint::transform() const {
    Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
    T.linear() = R.toRotationMatrix();
    T.translation() = p;
    return T;
}

ToolPath ToolPath::line(const ToolPoint& from, const ToolPoint& to) {
    ToolPath path;
    path.from_ = from;
    const Eigen::Vector3d move = to.p - from.p;
    const Eigen::Vector3d turn = turnBetween(from.R, to.R);
    path.length_ = std::max(move.norm(), kEquivalentRadius * turn.norm());
    if (path.length_ > kTiny) {
        path.direction_ = move / path.length_;
        path.turn_ = turn / path.length_;
    } else {
        path.length_ = 0;
    }
    return path;
}

ToolPath ToolPath::arc(const ToolPoint& from, const Eigen::Vector3d& via, const ToolPoint& to,
                       bool orientationFixedToArc) {
    const Eigen::Vector3d a = via - from.p;
    const Eigen::Vector3d b = to.p - from.p;
    const Eigen::Vector3d normal = a.cross(b);
    const double area = normal.norm();
    if (area < 1e-9 * std::max(1.0, a.norm() * b.norm()) || area < 1e-10) {
        return line(from, to);
    }
    ToolPath path;
    path.kind_ = Kind::Arc;
    path.from_ = from;
    path.axis_ = normal / area;
    const Eigen::Vector3d offset =
        (b.squaredNorm() * normal.cross(a) + a.squaredNorm() * b.cross(normal)) / (2 * area * area);
    path.centre_ = from.p + offset;
    path.radial_ = -offset;
    const double radius = offset.norm();
    const Eigen::Vector3d end = to.p - path.centre_;
    double angle = std::atan2(path.axis_.dot(path.radial_.cross(end)), path.radial_.dot(end));
    // `via` is on the arc. With the normal chosen above, the angle is always positive.
    if (angle <= 0) {
        angle += 2 * std::numbers::pi;
    }
    const Eigen::Vector3d turn =
        orientationFixedToArc ? Eigen::Vector3d(path.axis_ * angle) : turnBetween(from.R, to.R);
    path.length_ = radius * angle;
    if (!orientationFixedToArc) {
        path.length_ = std::max(path.length_, kEquivalentRadius * turn.norm());
    }
    path.turn_ = turn / path.length_;
    path.anglePerLength_ = angle / path.length_;
    return path;
}

ToolPath ToolPath::runOut(const ToolPoint& from, const Eigen::Vector3d& v, const Eigen::Vector3d& w,
                          double duration) {
    ToolPath path;
    path.from_ = from;
    path.direction_ = v;
    path.turn_ = w;
    path.length_ = duration;
    return path;
}

bool ToolPath::canRound(const ToolPath& first, const ToolPath& second) {
    if (first.kind_ == Kind::Arc || second.kind_ != Kind::Line || first.length_ <= kTiny ||
        second.length_ <= kTiny) {
        return false;
    }
    // If rotating the tool takes longer than moving it, no rounded corner is possible.
    if (first.travel() < 1 - 1e-6 || second.travel() < 1 - 1e-6) {
        return false;
    }
    return first.direction_.dot(second.direction_) > std::cos(toRadians(175.0));
}

ToolPath ToolPath::rounded(const ToolPath& first, const ToolPath& second, double radius) {
    const double tangent = std::min(radius, 0.5 * second.length_);
    const ToolPoint entry = first.at(first.length_ - tangent).at;
    const double turning = std::acos(std::clamp(first.direction_.dot(second.direction_), -1.0, 1.0));
    ToolPath path;
    path.kind_ = Kind::Rounded;
    path.from_ = entry;
    path.direction_ = second.direction_;
    path.turn_ = second.turn_;
    path.turnBefore_ = first.turn_;
    path.tangent_ = tangent;
    path.cornerR_ = second.from_.R;
    if (turning > 1e-6) {
        const double arcRadius = tangent / std::tan(0.5 * turning);
        path.arcLength_ = arcRadius * turning;
        path.axis_ = first.direction_.cross(second.direction_).normalized();
        path.radial_ = -path.axis_.cross(first.direction_) * arcRadius;
        path.centre_ = entry.p - path.radial_;
        path.anglePerLength_ = 1 / arcRadius;
    } else {
        path.arcLength_ = 2 * tangent;
        path.axis_ = Eigen::Vector3d::Zero();
    }
    path.length_ = path.arcLength_ + second.length_ - tangent;
    return path;
}

ToolPathPoint ToolPath::at(double s) const {
    if (kind_ == Kind::Arc) {
        return atArc(s);
    }
    if (kind_ == Kind::Rounded) {
        return atRounded(s);
    }
    ToolPathPoint point;
    point.at.p = from_.p + direction_ * s;
    point.at.R = quaternionFromVector(turn_ * s) * from_.R;
    point.dp = direction_;
    point.w = turn_;
    return point;
}

ToolPathPoint ToolPath::atArc(double s) const {
    ToolPathPoint point;
    const Eigen::Vector3d r = Eigen::AngleAxisd(anglePerLength_ * s, axis_) * radial_;
    point.at.p = centre_ + r;
    point.at.R = quaternionFromVector(turn_ * s) * from_.R;
    point.dp = anglePerLength_ * axis_.cross(r);
    point.w = turn_;
    return point;
}

ToolPathPoint ToolPath::atRounded(double s) const {
    ToolPathPoint point;
    const Eigen::Vector3d corner = centre_;
    if (s >= arcLength_) {
        const double beyond = s - arcLength_ + tangent_;
        const Eigen::Vector3d exit =
            axis_.isZero(0)
                ? Eigen::Vector3d(from_.p + direction_ * arcLength_)
                : Eigen::Vector3d(corner + Eigen::AngleAxisd(anglePerLength_ * arcLength_, axis_) * radial_);
        point.at.p = exit + direction_ * (s - arcLength_);
        point.at.R = quaternionFromVector(turn_ * beyond) * cornerR_;
        point.dp = direction_;
        point.w = turn_;
        return point;
    }
    if (axis_.isZero(0)) {
        point.at.p = from_.p + direction_ * s;
        point.dp = direction_;
    } else {
        const Eigen::Vector3d r = Eigen::AngleAxisd(anglePerLength_ * s, axis_) * radial_;
        point.at.p = corner + r;
        point.dp = anglePerLength_ * axis_.cross(r);
    }
    // The rotation of the first line fades out while the rotation of the second line fades in. At both ends,
    // the rotation rates match those of the lines.
    const double u = s / arcLength_;
    const double rate = arcLength_ / tangent_;
    const double before = 1 - 3 * u * u + 2 * u * u * u - rate * (u - 2 * u * u + u * u * u);
    const double beforeRate = -6 * u + 6 * u * u - rate * (1 - 4 * u + 3 * u * u);
    const double after = 3 * u * u - 2 * u * u * u + rate * (u * u * u - u * u);
    const double afterRate = 6 * u - 6 * u * u + rate * (3 * u * u - 2 * u);
    const Eigen::Quaterniond A = quaternionFromVector(-turnBefore_ * (tangent_ * before));
    const Eigen::Quaterniond B = quaternionFromVector(turn_ * (tangent_ * after));
    point.at.R = A * B * cornerR_;
    point.w = -turnBefore_ * (tangent_ * beforeRate / arcLength_) +
              A * Eigen::Vector3d(turn_ * (tangent_ * afterRate / arcLength_));
    return point;
}

}  // namespace tiller::simulator::arm
