// SPDX-License-Identifier: MIT
#include "robot/kinematics/speed_bounds.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "robot/kinematics/arm_kinematics.h"

namespace tiller::kinematics {
namespace {

constexpr int kJointSamples = 64;  ///< along a joint move
constexpr int kLineSamples = 48;   ///< along a line

Eigen::Vector3d elbowPosition(const DhParameters& dh, const JointPositions& q) {
    return linkFrames(dh, q)[2].translation();
}

/// Velocity of a point that is moved by the first `joints` joints.
Eigen::Vector3d velocityOf(const Eigen::Vector3d& point, const std::array<Eigen::Isometry3d, 7>& frames,
                           int joints, const Vector6& qd) {
    Eigen::Vector3d v = Eigen::Vector3d::Zero();
    for (int joint = 0; joint < joints; ++joint) {
        const Eigen::Isometry3d& axis = frames[static_cast<std::size_t>(joint)];
        v += axis.linear().col(2).cross(point - axis.translation()) * qd[joint];
    }
    return v;
}

}  // namespace

SpeedBound jointSpeedBound(const DhParameters& dh, const JointPositions& from, const JointPositions& to,
                           const Pose& tcpOffset, double cap) {
    const Vector6 way = to.values - from.values;
    const double largest = way.cwiseAbs().maxCoeff();
    if (largest < 1e-9) {
        return {};
    }
    // Speeds of the points if the joint with the largest rotation moves at 1 rad/s.
    const Vector6 qd = way / largest;
    double tcp = 0;
    double elbow = 0;
    // If only one joint moves, both points move on circles around its axis at constant speed.
    const bool isSingleJoint = (way.array() != 0).count() == 1;
    const int last = isSingleJoint ? 0 : kJointSamples;
    for (int i = 0; i <= last; ++i) {
        const JointPositions q(Vector6(from.values + way * (static_cast<double>(i) / kJointSamples)));
        const auto frames = linkFrames(dh, q);
        tcp = std::max(tcp, velocityOf(frames[6] * tcpOffset.position, frames, kJointCount, qd).norm());
        elbow = std::max(elbow, velocityOf(frames[2].translation(), frames, 2, qd).norm());
    }
    const double fastest = std::max(tcp, elbow);
    if (fastest < 1e-9) {
        return {};
    }
    return {cap / fastest, tcp < elbow ? SpeedLimit::Elbow : SpeedLimit::Tcp};
}

SpeedBound lineSpeedBound(const DhParameters& dh, const JointPositions& from, const Pose& to,
                          const Pose& tcpOffset, double cap, double rotationCap) {
    const Pose start = forwardTcp(dh, from, tcpOffset);
    const Eigen::Vector3d line = to.position - start.position;
    const double length = line.norm();
    const Eigen::Matrix3d R_start = rotationMatrix(start.rotation);
    const Eigen::Vector3d turn = rotationVector(R_start.transpose() * rotationMatrix(to.rotation));
    // The measured position of an arm at rest varies by less than 0.1 mm.
    constexpr double kOnTheSpot = 1e-4;  // [m]
    constexpr double kNoTurn = 1e-6;     // [rad]
    const bool onTheSpot = length < kOnTheSpot;
    if (onTheSpot && turn.norm() < kNoTurn) {
        return {};
    }
    // The controller treats a pure rotation as a path with this radius.
    const double counted = onTheSpot ? turn.norm() * kTurnRadius : length;
    SpeedBound bound = onTheSpot ? SpeedBound{rotationCap * kTurnRadius, SpeedLimit::Rotation}
                                 : SpeedBound{cap, SpeedLimit::Tcp};
    const auto holdTo = [&bound](double speed, SpeedLimit by) {
        if (speed < bound.speed) {
            bound = {speed, by};
        }
    };
    if (!onTheSpot && turn.norm() > kNoTurn) {
        holdTo(rotationCap * length / turn.norm(), SpeedLimit::Rotation);
    }
    JointPositions q = from;
    Eigen::Vector3d elbow = elbowPosition(dh, q);
    for (int i = 1; i <= kLineSamples; ++i) {
        const double part = static_cast<double>(i) / kLineSamples;
        const Pose pose(start.position + line * part,
                        rotationVector(R_start * rotationMatrix(Eigen::Vector3d(turn * part))));
        const auto next = inverseNearest(dh, pose, tcpOffset, q);
        if (!next) {
            break;
        }
        const Eigen::Vector3d nextElbow = elbowPosition(dh, *next);
        const double elbowPerTcp = (nextElbow - elbow).norm() / (counted / kLineSamples);
        if (elbowPerTcp > 0) {
            holdTo(cap / elbowPerTcp, SpeedLimit::Elbow);
        }
        q = *next;
        elbow = nextElbow;
    }
    return bound;
}

double lineLength(const Pose& from, const Pose& to) {
    const Eigen::Vector3d turn =
        rotationVector(rotationMatrix(from.rotation).transpose() * rotationMatrix(to.rotation));
    return std::max((to.position - from.position).norm(), turn.norm() * kTurnRadius);
}

double moveDuration(double distance, double speed, double acceleration) {
    if (!(distance > 0 && speed > 0 && acceleration > 0)) {
        return 0;
    }
    const double ramp = speed * speed / acceleration;  // duration of acceleration and deceleration together
    return distance < ramp ? 2 * std::sqrt(distance / acceleration) : distance / speed + speed / acceleration;
}

}  // namespace tiller::kinematics
