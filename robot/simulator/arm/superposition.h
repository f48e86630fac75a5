// SPDX-License-Identifier: MIT
#pragma once

// Motions superposed on the programmed path: a Cartesian offset, and a conveyor that moves the path. The
// program is not affected. The tool moves to the sum of program, offset and conveyor. The arm follows jumps
// of the offset or the conveyor smoothly, without delaying the path. Source: URScript path_offset_*,
// track_conveyor_*.

#include "robot/core/spatial.h"
#include "robot/simulator/arm/arm_geometry.h"
#include "robot/simulator/arm/joint_limits.h"
#include "robot/simulator/arm/motion_types.h"

namespace tiller::simulator::arm {

/// Axes of an offset, with the values used by URScript.
enum class OffsetFrame : std::uint8_t {
    Base = 1,
    Tool = 2,
    Motion = 3,  ///< x along the tangent of the path, y normal to it and to the tool's z
    World = 4,   ///< same as the base, because the mounting is not available here (unconfirmed)
};

class Superposition {
public:
    Superposition(const ArmGeometry& geometry, const JointLimits& limits, double period)
        : geometry_(geometry), limits_(limits), period_(period) {}

    // the offset
    void enableOffset();
    /// offset  position [m] and rotation vector [rad] in the axes of `frame`; clamped to the limits
    void setOffset(const Pose& offset, OffsetFrame frame);
    /// The current offset, in the axes of `frame`.
    Pose offset(OffsetFrame frame) const;
    /// Sets the filter coefficient (0..1): the fraction of the remaining difference that the applied offset
    /// covers per control period.
    void setFilter(double alpha);
    /// Sets the limits of the offset, initially 0.1 m and 0.52 rad.
    /// translation, rotation  [m], [rad]
    void setLimits(double translation, double rotation);

    // the conveyor
    /// perTick  displacement per tick of the encoder [m], base axes
    void trackLinear(const Eigen::Vector3d& perTick);
    /// centre  frame about whose z axis the conveyor rotates by `perTick` [rad] per tick
    /// turnTool  true: the tool rotates with the conveyor; false: it keeps its orientation
    void trackCircular(const Pose& centre, double perTick, bool turnTool);
    /// Sets the encoder count. The value at the start of tracking is the reference.
    void setTravel(double ticks) { travel_ = ticks; }
    bool tracksConveyor() const { return conveyor_ != Conveyor::None; }

    bool active() const { return offsetOn_ || tracksConveyor(); }
    /// Makes the current offset part of the program, which then continues from the arm position.
    void endOffset();
    void endTracking();
    void drop();

    /// Runs one control period: calculates the joint target `state` from the program target `program`.
    /// `frozen`: the program is paused, and neither offset nor conveyor moves.
    /// Returns  the reason if the target cannot be reached; the caller must then command `state`
    std::optional<StopReason> step(const JointTarget& program, bool frozen, JointTarget& state);

private:
    enum class Conveyor : std::uint8_t { None, Linear, Circular };

    void begin();
    void rebase();
    Eigen::Matrix3d axes(OffsetFrame frame) const;
    Eigen::Isometry3d appliedTo(const Eigen::Isometry3d& T) const;
    void settle(const Vector6& rate, const Vector6& goal, JointTarget& state);

    const ArmGeometry& geometry_;
    const JointLimits& limits_;
    double period_;

    bool offsetOn_ = false;
    OffsetFrame frame_ = OffsetFrame::Base;
    Vector6 wanted_ = Vector6::Zero();   // requested offset, in the axes of frame_
    Vector6 applied_ = Vector6::Zero();  // applied offset, in the axes of frame_
    double alpha_ = 1;
    double mostTranslation_ = 0.1;
    double mostRotation_ = 0.52;

    Conveyor conveyor_ = Conveyor::None;
    Eigen::Vector3d perTick_ = Eigen::Vector3d::Zero();
    Eigen::Isometry3d centre_ = Eigen::Isometry3d::Identity();
    double anglePerTick_ = 0;
    bool turnTool_ = false;
    double travel_ = 0;
    double zero_ = 0;     // travel at the start of tracking
    double carried_ = 0;  // travel applied so far, relative to zero_

    bool started_ = false;
    Posture program_;
    Posture posture_;
    Eigen::Matrix3d pathAxes_ = Eigen::Matrix3d::Identity();
    Eigen::Isometry3d goalPose_ = Eigen::Isometry3d::Identity();
    Vector6 goal_ = Vector6::Zero();
    Vector6 rate_ = Vector6::Zero();
    Vector6 slip_ = Vector6::Zero();  // velocity of the arm minus velocity of the goal
};

}  // namespace tiller::simulator::arm
