// SPDX-License-Identifier: MIT
#include "robot/simulator/arm/motion_generator.h"

#include <algorithm>
#include <cmath>

#include "robot/kinematics/arm_kinematics.h"
#include "robot/simulator/arm/torque_motion.h"

namespace tiller::simulator::arm {

namespace {
constexpr double kSamePlace = 1e-7;  // m or rad
constexpr double kRunOutLeast = 4;   // rad/s2, minimum for braking the previous motion
constexpr double kBranchTolerance = 1e-3;

MotionStart refuse(MotionError error, int joint = -1) {
    MotionStart start;
    start.error = error;
    start.joint = joint;
    return start;
}

bool finiteTarget(const MoveTarget& target) {
    return std::visit([](const auto& t) { return t.allFinite(); }, target);
}

bool positive(double x) {
    return std::isfinite(x) && x > 0;
}

bool notNegative(double x) {
    return std::isfinite(x) && x >= 0;
}
}  // namespace

ToolPoint MotionGenerator::toolPoint(const MoveTarget& target) const {
    if (const auto* pose = std::get_if<Pose>(&target)) {
        return ToolPoint(pose->transform());
    }
    return ToolPoint(geometry_.tcpPose(std::get<JointPositions>(target).values));
}

MotionError MotionGenerator::buildSegment(Segment& segment, Segment::Kind kind, const Vector6& fromQ,
                                          const ToolPoint& fromTool, const MoveTarget& target,
                                          const MoveTarget* via, ArcOrientation orientation, int& joint) {
    segment.kind = kind;
    segment.realTime = false;
    segment.time = 0;
    segment.endFault.reset();
    segment.endFaultJoint = -1;
    segment.inToolSpace = kind != Segment::Kind::Joint;
    if (segment.inToolSpace) {
        const ToolPoint to = toolPoint(target);
        if (kind == Segment::Kind::Circular) {
            segment.path =
                ToolPath::arc(fromTool, toolPoint(*via).p, to, orientation == ArcOrientation::FixedToArc);
        } else {
            segment.path = ToolPath::line(fromTool, to);
        }
        return MotionError::None;
    }
    if (const auto* q = std::get_if<JointPositions>(&target)) {
        for (int j = 0; j < kJointCount; ++j) {
            if (std::abs((*q)[j]) > limits_.position) {
                joint = j;
                return MotionError::JointTargetOutOfRange;
            }
        }
        segment.endQ = q->values;
    } else {
        const auto solution =
            kinematics::inverseNearest(geometry_.model().dh, std::get<Pose>(target), geometry_.tcp(),
                                       JointPositions(fromQ), limits_.position);
        if (!solution) {
            return MotionError::NoInverseKinematics;
        }
        segment.endQ = solution->values;
    }
    segment.from = fromQ;
    const Vector6 way = segment.endQ - fromQ;
    const double leading = way.cwiseAbs().maxCoeff();
    segment.direction = leading > 0 ? Vector6(way / leading) : Vector6::Zero();
    return MotionError::None;
}

MotionStart MotionGenerator::move(Segment::Kind kind, const MoveTarget& target,
                                  const MoveParameters& parameters, const MoveTarget* via,
                                  ArcOrientation orientation) {
    if (const auto error = refusal()) {
        return refuse(*error);
    }
    const MoveParameters& p = parameters;
    if (!finiteTarget(target) || (via != nullptr && !finiteTarget(*via)) || !notNegative(p.t) ||
        !notNegative(p.r) || !positive(p.a) || !positive(p.v)) {
        return refuse(MotionError::InvalidArgument);
    }
    if (ignoring_) {
        return ignored();
    }
    // After a change of the TCP, the paths have no common corner to blend.
    const bool sameTool = !tcpToCome_;
    if (mode_ == Mode::Path && path_.nextWaiting() && sameTool) {
        return refuse(MotionError::Busy);
    }
    if (mode_ == Mode::Path && path_.acceptsNext() && sameTool &&
        progress(activeId_) == MotionProgress::Returned) {
        return queueMove(kind, target, parameters, via, orientation);
    }
    // The arm may be at rest or still moving. A previous motion decelerates while the move starts.
    adoptTcp();
    const double least = kind == Segment::Kind::Joint ? std::max(p.a, kRunOutLeast) : kRunOutLeast;
    const bool runsOut = jointRunOut(least, runOut_);
    const Vector6 fromQ = runsOut ? runOut_.endQ : state_.q;
    const ToolPoint fromTool(geometry_.tcpPose(fromQ));
    Segment& segment = scratch_;
    segment.r = p.r;
    int joint = -1;
    const MotionError error = buildSegment(segment, kind, fromQ, fromTool, target, via, orientation, joint);
    if (error != MotionError::None) {
        return refuse(error, joint);
    }
    supersede();
    path_.drop();
    velocity_.drop();
    const MotionStart start = begin();
    segment.id = activeId_ = start.id;
    const double length =
        segment.inToolSpace ? segment.path.length() : (segment.endQ - segment.from).cwiseAbs().maxCoeff();
    if (length < kSamePlace && !runsOut) {
        mode_ = Mode::Rest;
        finish(start.id, MotionProgress::Returned);
        activeId_ = 0;
        return start;
    }
    PathPlanner::MoveTiming timing;
    timing.a = p.a;
    timing.v = p.v;
    timing.t = kind == Segment::Kind::Joint || kind == Segment::Kind::Linear ? p.t : 0;
    planner_.plan(segment, fromQ, timing);
    if (segment.profile.duration() <= 0 && segment.endFault) {
        raise(*segment.endFault, segment.endFaultJoint);
        return start;
    }
    pathScale_ = programScale_;
    if (runsOut) {
        path_.start(segment, runOut_);
    } else {
        path_.start(segment);
    }
    mode_ = Mode::Path;
    return start;
}

// Plans a move that is blended into the current move, which has reached its blend zone.
MotionStart MotionGenerator::queueMove(Segment::Kind kind, const MoveTarget& target, const MoveParameters& p,
                                       const MoveTarget* via, ArcOrientation orientation) {
    const Segment& before = path_.current();
    Segment& segment = scratch_;
    segment.r = p.r;
    int joint = -1;
    const MotionError error =
        buildSegment(segment, kind, before.endQ, before.endPoint, target, via, orientation, joint);
    if (error != MotionError::None) {
        return refuse(error, joint);
    }
    const MotionStart start = begin();
    segment.id = start.id;
    const ToolPoint to =
        planner_.pointAt(segment, segment.inToolSpace ? segment.path.length()
                                                      : (segment.endQ - segment.from).cwiseAbs().maxCoeff());
    if (p.r > 0 && (to.p - before.endPoint.p).norm() < before.r + p.r) {
        // The blend zones overlap. Skip this waypoint and blend into the next one.
        if (warningCount_ < kMaxWarnings) {
            warnings_[static_cast<std::size_t>(warningCount_++)] = MotionWarning::OverlappingBlends;
        }
        finish(start.id, MotionProgress::Returned);
        return start;
    }
    PathPlanner::MoveTiming timing;
    timing.a = p.a;
    timing.v = p.v;
    timing.t = kind == Segment::Kind::Joint || kind == Segment::Kind::Linear ? p.t : 0;
    double switchTime = std::max(before.profile.zoneTime(), before.time);
    const double zone = before.profile.length() - before.profile.sample(switchTime).s;
    Vector6 startQ = before.endQ;
    const bool rounds = kind == Segment::Kind::Process && before.kind == Segment::Kind::Process &&
                        zone > kSamePlace && ToolPath::canRound(before.path, segment.path);
    if (rounds) {
        const double tangent = std::min(zone, 0.5 * segment.path.length());
        segment.path = ToolPath::rounded(before.path, segment.path, tangent);
        const double entry = before.profile.length() - tangent;
        switchTime = std::max(before.time, before.profile.timeAtLength(entry));
        timing.startSpeed = before.profile.speedAtLength(entry);
        startQ = before.q;
        geometry_.follow(segment.path.start().transform(), startQ, posture_);
    } else {
        timing.blendInTime = before.profile.duration() - switchTime;
        timing.blendInRadius = before.r;
    }
    planner_.plan(segment, startQ, timing);
    if (segment.endFault && segment.profile.duration() <= 0) {
        activeId_ = start.id;
        raise(*segment.endFault, segment.endFaultJoint);
        return start;
    }
    path_.setNext(segment, switchTime);
    goalId_ = start.id;
    return start;
}

MotionStart MotionGenerator::servoJ(const JointPositions& q, double t, double lookahead, double gain) {
    if (const auto error = refusal()) {
        return refuse(*error);
    }
    if (!q.allFinite() || !notNegative(t) || !(lookahead >= 0.03 - 1e-9 && lookahead <= 0.2 + 1e-9) ||
        !(gain >= 100 - 1e-9 && gain <= 2000 + 1e-9)) {
        return refuse(MotionError::InvalidArgument);
    }
    if (ignoring_) {
        return ignored();
    }
    for (int j = 0; j < kJointCount; ++j) {
        if (std::abs(q[j]) > limits_.position) {
            return refuse(MotionError::JointTargetOutOfRange, j);
        }
    }
    const MotionStart start = begin();
    startVelocity(start.id, t);
    velocity_.servoJ(state_, velocityScale(), q.values, t, lookahead, gain);
    return start;
}

MotionStart MotionGenerator::servoC(const Pose& target, double a, double v, double r) {
    if (const auto error = refusal()) {
        return refuse(*error);
    }
    if (!target.allFinite() || !positive(a) || !positive(v) || !notNegative(r)) {
        return refuse(MotionError::InvalidArgument);
    }
    if (ignoring_) {
        return ignored();
    }
    adoptTcp();
    const ToolPoint point(target.transform());
    const MotionStart start = begin();
    startVelocity(start.id, std::nullopt);
    if (!geometry_.isReachable(point.transform())) {
        raise(StopReason::PoseUnreachable, -1);
        return start;
    }
    velocity_.servoC(state_, velocityScale(), point, a, v, r);
    return start;
}

namespace {

/// Replaces an infinite acceleration by the maximum. A program can compute an infinite acceleration by
/// dividing by a time of 0.
double finiteAcceleration(double a) {
    return std::isfinite(a) ? a : kJointAccelerationLimit;
}

}  // namespace

MotionStart MotionGenerator::speedJ(const JointVelocities& qd, double a, std::optional<double> t) {
    a = finiteAcceleration(a);
    if (const auto error = refusal()) {
        return refuse(*error);
    }
    // Acceleration 0 is valid if the speed does not change or a time is given.
    if (!qd.allFinite() || !notNegative(a) || (t && !notNegative(*t)) ||
        (a == 0 && !t && (qd.values - state_.qd).norm() > kBranchTolerance)) {
        return refuse(MotionError::InvalidArgument);
    }
    if (ignoring_) {
        return ignored();
    }
    const MotionStart start = begin();
    startVelocity(start.id, t);
    velocity_.speedJ(state_, velocityScale(), qd.values, a);
    return start;
}

MotionStart MotionGenerator::speedL(const Twist& twist, double a, std::optional<double> t,
                                    std::optional<double> aRot) {
    a = finiteAcceleration(a);
    if (aRot) {
        aRot = finiteAcceleration(*aRot);
    }
    if (const auto error = refusal()) {
        return refuse(*error);
    }
    const Vector6 x = twist.vector();
    const double rotation = aRot.value_or(a);
    if (!x.allFinite() || !notNegative(a) || !notNegative(rotation) || (t && !notNegative(*t)) ||
        ((a == 0 || rotation == 0) && !t && x.norm() > kBranchTolerance)) {
        return refuse(MotionError::InvalidArgument);
    }
    if (ignoring_) {
        return ignored();
    }
    adoptTcp();
    const MotionStart start = begin();
    startVelocity(start.id, t);
    velocity_.speedL(state_, velocityScale(), x, a, rotation);
    return start;
}

MotionStart MotionGenerator::stopJ(double a) {
    if (!positive(a)) {
        return refuse(MotionError::InvalidArgument);
    }
    supersede();
    const MotionStart start = begin();
    startStop(a, start.id, readings_.stopsScaled);
    return start;
}

MotionStart MotionGenerator::stopL(double a, std::optional<double> aRot) {
    const double rotation = aRot.value_or(a);
    if (!positive(a) || !positive(rotation)) {
        return refuse(MotionError::InvalidArgument);
    }
    supersede();
    adoptTcp();
    const MotionStart start = begin();
    geometry_.evaluate(state_.q, posture_);
    const double pace = stopPace(readings_.stopsScaled);
    const Vector6 qd = state_.qd / pace;
    const Vector6 twist = posture_.jacobian * qd;
    const Eigen::Vector3d v = twist.head<3>();
    const Eigen::Vector3d w = twist.tail<3>();
    const double duration =
        std::max({v.norm() / a, w.norm() / rotation,
                  qd.cwiseAbs().maxCoeff() * pace * pace / limits_.plannedAcceleration()});
    Vector6 rates = Vector6::Zero();
    if (v.norm() + w.norm() < 1e-9 || !geometry_.jointRates(posture_, twist, rates) ||
        (rates - qd).norm() > kBranchTolerance) {
        // Stop in joint space if the arm is at rest or the tool velocity does not determine the joint
        // velocities.
        startStop(std::max(a, kRunOutLeast), start.id, readings_.stopsScaled);
        return start;
    }
    path_.drop();
    velocity_.drop();
    Segment& segment = scratch_;
    segment.id = activeId_ = start.id;
    segment.kind = Segment::Kind::Stop;
    segment.inToolSpace = true;
    segment.realTime = pace >= 1;
    segment.r = 0;
    segment.endFault.reset();
    segment.path = ToolPath::runOut(ToolPoint(posture_.T_base_tcp), v, w, 0.5 * duration);
    segment.profile = SpeedProfile::stop(1, duration);
    segment.q = segment.endQ = state_.q;
    pathScale_ = programScale_;
    path_.start(segment);
    mode_ = Mode::Path;
    return start;
}

MotionStart MotionGenerator::directTorque(const JointTorques& torques, const Vector6& viscous,
                                          const Vector6& coulomb) {
    if (const auto error = refusal()) {
        return refuse(*error);
    }
    if (!torques.allFinite() || !viscous.allFinite() || !coulomb.allFinite() || torque_ == nullptr) {
        return refuse(MotionError::InvalidArgument);
    }
    if (ignoring_) {
        return ignored();
    }
    supersede();
    path_.drop();
    velocity_.drop();
    const MotionStart start = begin();
    torque_->command(torques, viscous, coulomb);
    mode_ = Mode::Torque;
    activeId_ = start.id;
    blocking_ = true;
    return start;
}

}  // namespace tiller::simulator::arm
