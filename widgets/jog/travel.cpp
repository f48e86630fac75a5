// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/jog/travel.h"

#include <Eigen/LU>
#include <QString>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "robot/kinematics/arm_kinematics.h"

namespace tiller {
namespace {

using Vector6d = Eigen::Matrix<double, 6, 1>;

constexpr double kStep = 0.010;      ///< [m] along the line
constexpr double kTurnStep = 0.030;  ///< [rad] about the TCP
/// A joint that would have to turn more than this for one step is next to a singularity [rad].
constexpr double kJump = 0.5;

Vector6d twistOf(int key, const Eigen::Matrix3d& R_base_frame) {
    const int axis = key / 2;
    const double sign = key % 2 == 0 ? -1.0 : 1.0;
    Vector6d twist = Vector6d::Zero();
    twist.segment<3>(axis < 3 ? 0 : 3) = sign * R_base_frame.col(axis % 3);
    return twist;
}

Pose moved(const Pose& pose, const Vector6d& direction, double by) {
    Pose next = pose;
    next.position += direction.head<3>() * by;
    const Eigen::Vector3d axis = direction.tail<3>();
    if (axis.norm() > 0.5) {
        next.rotation = rotationVector(Eigen::AngleAxisd(by, axis) * rotationMatrix(pose.rotation));
    }
    return next;
}

/// Heights over the plane of the base of what can touch it first: elbow, wrists, flange, TCP [m].
using Heights = std::array<double, 6>;

Heights heightsOf(const DhParameters& dh, const JointPositions& q, const Pose& tcpOffset) {
    const auto frames = kinematics::linkFrames(dh, q);
    Heights heights{};
    for (std::size_t i = 0; i < 5; ++i) {
        heights.at(i) = frames.at(i + 2).translation().z() - kBasePlane;
    }
    heights[5] = (frames[6] * tcpOffset.position).z() - kBasePlane;
    return heights;
}

/// How much of a step is left until the first of them comes down to the plane; 1 when none does.
double shareAbove(const Heights& before, const Heights& after) {
    double share = 1;
    for (std::size_t i = 0; i < before.size(); ++i) {
        if (before.at(i) >= 0 && after.at(i) < 0) {
            share = std::min(share, before.at(i) / (before.at(i) - after.at(i)));
        }
    }
    return share;
}

}  // namespace

Travel travelLeft(const DhParameters& dh, const JointPositions& q, const Pose& tcpOffset,
                  const Vector6d& direction) {
    const bool turns = direction.tail<3>().norm() > 0.5;
    const double step = turns ? kTurnStep : kStep;
    const double seen = turns ? kTurnSeen : kTravelSeen;
    const Pose start = kinematics::forwardTcp(dh, q, tcpOffset);
    JointPositions at = q;
    Heights heights = heightsOf(dh, q, tcpOffset);
    Travel travel;
    for (double gone = step; gone <= seen; gone += step) {
        // Without the range of the joints: it is looked at here, with the name of the joint.
        const auto next = kinematics::inverseNearest(dh, moved(start, direction, gone), tcpOffset, at,
                                                     4 * kJointPositionLimit);
        if (!next || (next->values - at.values).cwiseAbs().maxCoeff() > kJump) {
            travel.end = Travel::End::Singularity;
            return travel;
        }
        for (int joint = 0; joint < kJointCount; ++joint) {
            if (std::abs((*next)[joint]) > kJointPositionLimit) {
                const double over = std::abs((*next)[joint]) - kJointPositionLimit;
                const double turned = std::abs((*next)[joint] - at[joint]);
                travel.left += turned > 0 ? step * std::max(0.0, 1 - over / turned) : 0;
                travel.end = Travel::End::JointLimit;
                travel.joint = joint;
                return travel;
            }
        }
        const Heights before = std::exchange(heights, heightsOf(dh, *next, tcpOffset));
        if (const double share = shareAbove(before, heights); share < 1) {
            travel.left += share * step;
            travel.end = Travel::End::Floor;
            return travel;
        }
        at = *next;
        travel.left = gone;
    }
    return travel;
}

std::array<Travel, 12> travelPerKey(const DhParameters& dh, const JointPositions& q, const Pose& tcpOffset,
                                    const Eigen::Matrix3d& R_base_frame) {
    std::array<Travel, 12> travel;
    for (int key = 0; key < 12; ++key) {
        travel[static_cast<std::size_t>(key)] = travelLeft(dh, q, tcpOffset, twistOf(key, R_base_frame));
    }
    return travel;
}

int wayOut(const DhParameters& dh, const JointPositions& q, const Pose& tcpOffset,
           const Eigen::Matrix3d& R_base_frame, int joint) {
    const double away = q[joint] > 0 ? -1.0 : 1.0;
    const auto J = kinematics::jacobian(dh, q, tcpOffset).eval();
    const Eigen::FullPivLU<Eigen::Matrix<double, 6, 6>> solver(J);
    if (!solver.isInvertible()) {
        return -1;
    }
    int best = -1;
    double most = 0.05;  // [rad/m] less does not lead anywhere
    for (int key = 0; key < 12; ++key) {
        const Vector6d twist = twistOf(key, R_base_frame);
        // A metre counts as much as a radian: either is a good second of jogging.
        const Vector6d qd = solver.solve(twist);
        const double gain = away * qd[joint];
        if (gain > most && travelLeft(dh, q, tcpOffset, twist).left > (key < 6 ? 0.03 : 0.1)) {
            most = gain;
            best = key;
        }
    }
    return best;
}

int wayOutOf(const DhParameters& dh, const JointPositions& q, const Pose& tcpOffset,
             const Eigen::Matrix3d& R_base_frame, Singularity singularity) {
    const auto measure = [&](const JointPositions& at) {
        const auto near = kinematics::singularityMeasure(dh, at);
        return singularity == Singularity::Wrist   ? near.wrist
               : singularity == Singularity::Elbow ? near.elbow
                                                   : near.shoulder;
    };
    const double here = measure(q);
    const Heights heights = heightsOf(dh, q, tcpOffset);
    const Pose start = kinematics::forwardTcp(dh, q, tcpOffset);
    int best = -1;
    double most = 0.01;  // less does not lead anywhere
    for (int key = 0; key < 12; ++key) {
        const auto next = kinematics::inverseNearest(
            dh, moved(start, twistOf(key, R_base_frame), key < 6 ? 3 * kStep : 3 * kTurnStep), tcpOffset, q);
        if (!next || (next->values - q.values).cwiseAbs().maxCoeff() > kJump ||
            shareAbove(heights, heightsOf(dh, *next, tcpOffset)) < 1) {
            continue;
        }
        if (const double gain = measure(*next) - here; gain > most) {
            most = gain;
            best = key;
        }
    }
    return best;
}

QString travelKeyName(int key) {
    static const char* const kAxes[] = {"X", "Y", "Z", "Rx", "Ry", "Rz"};
    return QLatin1String(kAxes[key / 2]) + (key % 2 == 0 ? QChar(0x2212) : QChar('+'));
}

}  // namespace tiller
