// SPDX-License-Identifier: MIT
#pragma once

// TCP pose as a function of the path parameter: straight lines, arcs, rounded corners, and the deceleration
// path of a stop. The orientation is interpolated with the position.

#include <Eigen/Geometry>
#include <cstdint>

namespace tiller::simulator::arm {

/// Converts a rotation to a tool path length, so that pure rotations have a length [m]. Source: eq_radius of
/// the controller's configuration data.
inline constexpr double kEquivalentRadius = 0.25;

/// Position and orientation in the base frame.
struct ToolPoint {
    Eigen::Vector3d p = Eigen::Vector3d::Zero();
    Eigen::Quaterniond R = Eigen::Quaterniond::Identity();

    ToolPoint() = default;
    ToolPoint(const Eigen::Vector3d& position, const Eigen::Quaterniond& orientation)
        : p(position), R(orientation) {}
    explicit ToolPoint(const Eigen::Isometry3d& T) : p(T.translation()), R(T.linear()) { R.normalize(); }
    Eigen::Isometry3d transform() const;
};

/// A point of a path and its derivatives with respect to the path parameter, base axes.
struct ToolPathPoint {
    ToolPoint at;
    Eigen::Vector3d dp = Eigen::Vector3d::Zero();
    Eigen::Vector3d w = Eigen::Vector3d::Zero();
};

class ToolPath {
public:
    static ToolPath line(const ToolPoint& from, const ToolPoint& to);
    /// Arc through `via`, or a line if the three points are collinear.
    static ToolPath arc(const ToolPoint& from, const Eigen::Vector3d& via, const ToolPoint& to,
                        bool orientationFixedToArc);
    /// Deceleration path from the given velocity. The path parameter is the time in seconds, up to
    /// `duration`.
    static ToolPath runOut(const ToolPoint& from, const Eigen::Vector3d& v, const Eigen::Vector3d& w,
                           double duration);
    /// Path from the beginning of the zone of `first` (at distance `radius` before its end) along a circle to
    /// `second`. Requires canRound().
    static ToolPath rounded(const ToolPath& first, const ToolPath& second, double radius);
    static bool canRound(const ToolPath& first, const ToolPath& second);

    double length() const { return length_; }
    ToolPathPoint at(double s) const;
    const ToolPoint& start() const { return from_; }
    ToolPoint finish() const { return at(length_).at; }
    /// TCP distance per unit of the path parameter on a straight path.
    double travel() const { return direction_.norm(); }
    /// Length of the straight part at the end, or of the whole path without a rounded corner.
    double straightEnd() const { return length_ - arcLength_; }
    bool isRounded() const { return kind_ == Kind::Rounded; }

private:
    enum class Kind : std::uint8_t { Line, Arc, Rounded };

    ToolPathPoint atArc(double s) const;
    ToolPathPoint atRounded(double s) const;

    Kind kind_ = Kind::Line;
    double length_ = 0;
    ToolPoint from_;
    Eigen::Vector3d direction_ = Eigen::Vector3d::Zero();  // line: dp/ds
    Eigen::Vector3d turn_ = Eigen::Vector3d::Zero();       // rotation vector per ds, base axes
    // arc
    Eigen::Vector3d centre_ = Eigen::Vector3d::Zero();
    Eigen::Vector3d radial_ = Eigen::Vector3d::Zero();  // centre to start
    Eigen::Vector3d axis_ = Eigen::Vector3d::UnitZ();
    double anglePerLength_ = 0;
    // rounded corner: an arc of this length, then the line
    double arcLength_ = 0;
    double tangent_ = 0;
    Eigen::Quaterniond cornerR_ = Eigen::Quaterniond::Identity();
    Eigen::Vector3d turnBefore_ = Eigen::Vector3d::Zero();
};

}  // namespace tiller::simulator::arm
