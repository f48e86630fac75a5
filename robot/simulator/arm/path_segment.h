// SPDX-License-Identifier: MIT
#pragma once

// One planned move: its geometry, its speed profile, and the beginning of its blend zone.

#include <array>
#include <optional>

#include "robot/core/joints.h"
#include "robot/simulator/arm/arm_geometry.h"
#include "robot/simulator/arm/joint_limits.h"
#include "robot/simulator/arm/motion_types.h"
#include "robot/simulator/arm/speed_profile.h"
#include "robot/simulator/arm/tool_path.h"

namespace tiller::simulator::arm {

struct Segment {
    enum class Kind : std::uint8_t { Joint, Linear, Process, Circular, Stop };

    MotionId id = 0;
    Kind kind = Kind::Joint;
    bool inToolSpace = false;
    bool realTime = false;  ///< not slowed by the speed slider, not frozen by a pause
    double r = 0;           ///< requested blend radius [m]; 0: ends at rest

    Vector6 from = Vector6::Zero();       ///< joint space: q = from + direction * s
    Vector6 direction = Vector6::Zero();  ///< largest component is 1: s is the angle of the leading axis
    ToolPath path;                        ///< tool space
    SpeedProfile profile;

    Vector6 endQ = Vector6::Zero();
    ToolPoint endPoint;
    std::optional<StopReason> endFault;  ///< set if the path cannot be followed to its requested end
    int endFaultJoint = -1;

    double time = 0;              ///< elapsed time [s], in the time base of this segment
    Vector6 q = Vector6::Zero();  ///< joint positions at `time`

    bool finished() const { return time >= profile.duration() - 1e-12; }
    double zoneLength() const { return profile.length() - profile.sample(profile.zoneTime()).s; }
};

/// Plans the speed profile of a segment within the joint limits. A tool path is sampled first. The motion is
/// slowed down where joint speeds would be too high. If the path cannot be followed at some point, it ends
/// there with the reason in `endFault`.
class PathPlanner {
public:
    PathPlanner(const ArmGeometry& geometry, const JointLimits& limits)
        : geometry_(geometry), limits_(limits) {}

    struct MoveTiming {
        double a = 1;
        double v = 1;
        double t = 0;
        double startSpeed = 0;
        double blendInTime = 0;
        double blendInRadius = 0;  ///< [m] TCP distance covered while blending in
    };

    /// Plans the profile of a segment that contains kind, r and geometry. For a tool path, the function
    /// determines endQ.
    void plan(Segment& segment, const Vector6& startQ, const MoveTiming& timing);

    /// Length of path within `radius` [m] of its end or start, as a path parameter; at most half the path.
    double lengthWithin(const Segment& segment, double radius, bool fromEnd) const;

    ToolPoint pointAt(const Segment& segment, double s) const;

private:
    static constexpr int kMaxSamples = SpeedProfile::kMaxPhases - 20;

    int sampleToolPath(Segment& segment, const Vector6& startQ);
    void limitSpeeds(Segment& segment, int count, double a);
    ProfileRequest profileRequest(const Segment& segment, const MoveTiming& timing) const;

    const ArmGeometry& geometry_;
    const JointLimits& limits_;
    std::array<double, kMaxSamples> s_{};
    std::array<double, kMaxSamples> v_{};
    std::array<double, kMaxSamples> a_{};
    std::array<Vector6, kMaxSamples> q_{};
    Posture posture_;
};

}  // namespace tiller::simulator::arm
