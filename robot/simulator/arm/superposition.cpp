// SPDX-License-Identifier: MIT
#include "robot/simulator/arm/superposition.h"

#include <algorithm>
#include <cmath>

namespace tiller::simulator::arm {

namespace {
constexpr double kCatchUpRate = 15;            // 1/s
constexpr double kCatchUpSpeed = 0.6;          // rad/s above the goal's speed
constexpr double kCatchUpAcceleration = 10;    // rad/s2
constexpr double kCaughtUp = 1e-4;             // rad/s and rad
constexpr double kStandstillTolerance = 1e-4;  // m/s: below this speed a path has no tangent

Eigen::Isometry3d toTransform(const Vector6& v) {
    Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
    T.linear() = quaternionFromVector(v.tail<3>()).toRotationMatrix();
    T.translation() = v.head<3>();
    return T;
}

Vector6 turned(const Eigen::Matrix3d& R, const Vector6& v) {
    Vector6 out;
    out << R * v.head<3>(), R * v.tail<3>();
    return out;
}
}  // namespace

void Superposition::begin() {
    if (!active()) {
        started_ = false;
    }
}

void Superposition::enableOffset() {
    if (!offsetOn_) {
        begin();
        wanted_.setZero();
        applied_.setZero();
        offsetOn_ = true;
    }
}

void Superposition::setOffset(const Pose& offset, OffsetFrame frame) {
    if (frame != frame_) {
        applied_ = turned(axes(frame).transpose() * axes(frame_), applied_);
        frame_ = frame;
    }
    wanted_ << offset.position, offset.rotation;
    const double way = wanted_.head<3>().norm();
    const double angle = wanted_.tail<3>().norm();
    wanted_.head<3>() *= way > mostTranslation_ ? mostTranslation_ / way : 1.0;
    wanted_.tail<3>() *= angle > mostRotation_ ? mostRotation_ / angle : 1.0;
}

Pose Superposition::offset(OffsetFrame frame) const {
    Pose pose;
    if (offsetOn_) {
        const Vector6 v = turned(axes(frame).transpose() * axes(frame_), applied_);
        pose.position = v.head<3>();
        pose.rotation = v.tail<3>();
    }
    return pose;
}

void Superposition::setFilter(double alpha) {
    alpha_ = std::clamp(alpha, 0.0, 1.0);
}

void Superposition::setLimits(double translation, double rotation) {
    mostTranslation_ = std::max(0.0, translation);
    mostRotation_ = std::max(0.0, rotation);
}

void Superposition::trackLinear(const Eigen::Vector3d& perTick) {
    begin();
    conveyor_ = Conveyor::Linear;
    perTick_ = perTick;
    zero_ = travel_;
    carried_ = 0;
}

void Superposition::trackCircular(const Pose& centre, double perTick, bool turnTool) {
    begin();
    conveyor_ = Conveyor::Circular;
    centre_ = centre.transform();
    anglePerTick_ = perTick;
    turnTool_ = turnTool;
    zero_ = travel_;
    carried_ = 0;
}

void Superposition::rebase() {
    applied_.setZero();
    wanted_.setZero();
    zero_ = travel_;
    carried_ = 0;
    started_ = false;
}

void Superposition::endOffset() {
    offsetOn_ = false;
    rebase();
}

void Superposition::endTracking() {
    conveyor_ = Conveyor::None;
    rebase();
}

void Superposition::drop() {
    offsetOn_ = false;
    conveyor_ = Conveyor::None;
    started_ = false;
}

Eigen::Matrix3d Superposition::axes(OffsetFrame frame) const {
    switch (frame) {
        case OffsetFrame::Tool:
            return started_ ? Eigen::Matrix3d(program_.T_base_tcp.linear()) : Eigen::Matrix3d::Identity();
        case OffsetFrame::Motion:
            return pathAxes_;
        case OffsetFrame::Base:
        case OffsetFrame::World:
            break;
    }
    return Eigen::Matrix3d::Identity();
}

Eigen::Isometry3d Superposition::appliedTo(const Eigen::Isometry3d& T) const {
    Eigen::Isometry3d out = T;
    if (offsetOn_) {
        const Eigen::Isometry3d offset = toTransform(turned(axes(frame_), applied_));
        out.translation() += offset.translation();
        out.linear() = offset.linear() * out.linear();
    }
    if (conveyor_ == Conveyor::Linear) {
        out.translation() += perTick_ * carried_;
    } else if (conveyor_ == Conveyor::Circular) {
        const Eigen::Isometry3d turn(Eigen::AngleAxisd(anglePerTick_ * carried_, Eigen::Vector3d::UnitZ()));
        const Eigen::Isometry3d carried = centre_ * turn * centre_.inverse() * out;
        out.translation() = carried.translation();
        if (turnTool_) {
            out.linear() = carried.linear();
        }
    }
    return out;
}

std::optional<StopReason> Superposition::step(const JointTarget& program, bool frozen, JointTarget& state) {
    geometry_.evaluate(program.q, program_);
    const Eigen::Vector3d along = (program_.jacobian * program.qd).head<3>();
    if (along.norm() > kStandstillTolerance) {
        const Eigen::Vector3d x = along.normalized();
        const Eigen::Vector3d y = x.cross(program_.T_base_tcp.linear().col(2));
        if (y.norm() > 1e-3) {
            pathAxes_.col(0) = x;
            pathAxes_.col(1) = y.normalized();
            pathAxes_.col(2) = x.cross(pathAxes_.col(1));
        }
    }
    if (!started_) {
        started_ = true;
        goal_ = state.q;
        goalPose_ = geometry_.tcpPose(state.q);
        rate_ = state.qd;
        slip_.setZero();
    }
    if (!frozen) {
        applied_ += alpha_ * (wanted_ - applied_);
        carried_ = travel_ - zero_;
    }
    const Eigen::Isometry3d pose = appliedTo(program_.T_base_tcp);
    Vector6 goal = goal_;
    Vector6 rate = Vector6::Zero();
    // At rest, the goal velocity must be exactly zero, because it is compared with zero to detect standstill.
    if (!(pose.matrix() - goalPose_.matrix()).isZero(1e-12) || !program.qd.isZero(0)) {
        // The offset is applied in joint space. The goal may jump, but the arm must approach it smoothly.
        if (!geometry_.follow(pose, goal, posture_)) {
            return StopReason::PoseUnreachable;
        }
        rate = (goal - goal_) / period_;
    }
    goal_ = goal;
    goalPose_ = pose;
    settle(rate, goal, state);
    int joint = -1;
    if (limits_.rangeFactor(state.q, state.qd, period_, joint) < 0.5) {
        return StopReason::JointPositionLimit;
    }
    return std::nullopt;
}

// Moves to the goal if the arm can reach it in this period without a jump, and otherwise towards the goal.
void Superposition::settle(const Vector6& given, const Vector6& goal, JointTarget& state) {
    const double possible = limits_.acceleration * period_;
    // If the goal has jumped, `given` is not a velocity. Keep the previous rate.
    Vector6 rate = given;
    if (given.cwiseAbs().maxCoeff() > 2 * limits_.speed.maxCoeff()) {
        rate = rate_;
    }
    const Vector6 change = rate - rate_;
    if (change.cwiseAbs().maxCoeff() > possible) {
        slip_ -= change;
    }
    rate_ = rate;
    const Vector6 error = goal - state.q - 0.5 * (state.qd + rate) * period_;
    if (slip_.cwiseAbs().maxCoeff() < kCaughtUp && error.cwiseAbs().maxCoeff() < kCaughtUp &&
        (rate - state.qd).cwiseAbs().maxCoeff() <= possible * 1.001 && limits_.speedFactor(rate) >= 1) {
        state = {goal, rate};
        slip_.setZero();
        return;
    }
    const double step = kCatchUpAcceleration * period_;
    for (int j = 0; j < kJointCount; ++j) {
        const double size = std::abs(error[j]);
        const double most =
            std::min({kCatchUpRate * size, kCatchUpSpeed, std::sqrt(kCatchUpAcceleration * size)});
        const double wanted = error[j] < 0 ? -most : most;
        slip_[j] += std::clamp(wanted - slip_[j], -step, step);
    }
    Vector6 next = rate + slip_;
    next *= limits_.speedFactor(next);
    limits_.cutToAcceleration(state.qd, next, period_);
    slip_ = next - rate;
    state.q += 0.5 * (state.qd + next) * period_;
    state.qd = next;
}

}  // namespace tiller::simulator::arm
