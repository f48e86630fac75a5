// SPDX-License-Identifier: MIT
#include "robot/kinematics/speed_bounds.h"

#include <algorithm>
#include <limits>

#include "robot/kinematics/arm_kinematics.h"

namespace tiller::kinematics {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

Eigen::Vector3d elbowPosition(const DhParameters& dh, const JointPositions& q) {
    return linkFrames(dh, q)[2].translation();
}

Eigen::Vector3d elbowVelocity(const DhParameters& dh, const JointPositions& q, const Vector6& qd) {
    const auto frames = linkFrames(dh, q);
    const Eigen::Vector3d elbow = frames[2].translation();
    Eigen::Vector3d v = Eigen::Vector3d::Zero();
    for (int joint = 0; joint < 2; ++joint) {
        const Eigen::Isometry3d& axis = frames[static_cast<std::size_t>(joint)];
        v += axis.linear().col(2).cross(elbow - axis.translation()) * qd[joint];
    }
    return v;
}

}  // namespace

double jointSpeedBound(const DhParameters& dh, const JointPositions& from, const JointPositions& to,
                       const Pose& tcpOffset, double cap) {
    const Vector6 way = to.values - from.values;
    const double largest = way.cwiseAbs().maxCoeff();
    if (largest < 1e-9) {
        return kInfinite;
    }
    // Speeds of the points while the joint that turns most turns at 1 rad/s.
    const Vector6 qd = way / largest;
    double fastest = 0;
    constexpr int kSamples = 64;
    for (int i = 0; i <= kSamples; ++i) {
        const JointPositions q(Vector6(from.values + way * (static_cast<double>(i) / kSamples)));
        fastest = std::max(fastest, (jacobian(dh, q, tcpOffset).topRows<3>() * qd).norm());
        fastest = std::max(fastest, elbowVelocity(dh, q, qd).norm());
    }
    return fastest < 1e-9 ? kInfinite : cap / fastest;
}

double lineSpeedBound(const DhParameters& dh, const JointPositions& from, const Pose& to,
                      const Pose& tcpOffset, double cap, double rotationCap) {
    const Pose start = forwardTcp(dh, from, tcpOffset);
    const Eigen::Vector3d line = to.position - start.position;
    const double length = line.norm();
    const Eigen::Matrix3d R_start = rotationMatrix(start.rotation);
    const Eigen::Vector3d turn = rotationVector(R_start.transpose() * rotationMatrix(to.rotation));
    // What an arm at rest measures of its own place trembles by some hundredths of a millimetre.
    constexpr double kOnTheSpot = 1e-4;  // [m]
    if (length < kOnTheSpot) {
        // A turn on the spot: the controller counts its angle as a path of this radius.
        return turn.norm() > 1e-6 ? rotationCap * kTurnRadius : kInfinite;
    }
    double bound = cap;
    if (turn.norm() > 1e-6) {
        bound = std::min(bound, rotationCap * length / turn.norm());
    }
    constexpr int kSamples = 48;
    JointPositions q = from;
    Eigen::Vector3d elbow = elbowPosition(dh, q);
    for (int i = 1; i <= kSamples; ++i) {
        const double part = static_cast<double>(i) / kSamples;
        const Pose pose(start.position + line * part,
                        rotationVector(R_start * rotationMatrix(Eigen::Vector3d(turn * part))));
        const auto next = inverseNearest(dh, pose, tcpOffset, q);
        if (!next) {
            break;
        }
        const Eigen::Vector3d nextElbow = elbowPosition(dh, *next);
        const double elbowPerTcp = (nextElbow - elbow).norm() / (length / kSamples);
        if (elbowPerTcp > 1.0) {
            bound = std::min(bound, cap / elbowPerTcp);
        }
        q = *next;
        elbow = nextElbow;
    }
    return bound;
}

}  // namespace tiller::kinematics
