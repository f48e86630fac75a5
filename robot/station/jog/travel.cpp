// SPDX-License-Identifier: MIT
#include "robot/station/jog/travel.h"

#include <Eigen/LU>
#include <QString>
#include <cmath>
#include <functional>

#include "robot/kinematics/arm_kinematics.h"

namespace tiller {
namespace {

constexpr int kPadKeys = 12;
/// Minimum remaining travel of a suggested button.
constexpr double kMinTravel = 0.030;      ///< [m]
constexpr double kMinTravelAngle = 0.10;  ///< [rad]

Vector6 twistOf(int key, const Eigen::Matrix3d& R_base_frame) {
    const int axis = key / 2;
    const double sign = key % 2 == 0 ? -1.0 : 1.0;
    Vector6 twist = Vector6::Zero();
    twist.segment<3>(axis < 3 ? 0 : 3) = sign * R_base_frame.col(axis % 3);
    return twist;
}

control::JogReach jogFollowed(const SessionState& state, const Vector6& direction, double farthest) {
    return control::jogReach({state.dh, state.jointLimits, {}, state.check.get()}, state.q, state.tcpOffset,
                             direction, farthest);
}

bool hasTravelLeft(const SessionState& state, const Vector6& direction, int key) {
    const double room = key < kPadKeys / 2 ? kMinTravel : kMinTravelAngle;
    return jogFollowed(state, direction, room).distance >= room;
}

/// The button with the largest gain above `least` and sufficient travel.
/// gain  returns the gain of a joint velocity [1/s]
int bestKey(const SessionState& state, const Eigen::Matrix3d& R_base_frame, double least,
            const std::function<double(const Vector6& qd)>& gain) {
    const Eigen::FullPivLU<Matrix6> solver(kinematics::jacobian(state.dh, state.q, state.tcpOffset));
    if (!solver.isInvertible()) {
        return -1;
    }
    int best = -1;
    for (int key = 0; key < kPadKeys; ++key) {
        const Vector6 twist = twistOf(key, R_base_frame);
        // One metre and one radian have the same weight, so that translations and rotations can be compared.
        const double gained = gain(solver.solve(twist));
        if (gained > least && hasTravelLeft(state, twist, key)) {
            least = gained;
            best = key;
        }
    }
    return best;
}

}  // namespace

control::JogReach travelLeft(const SessionState& state, const Vector6& direction) {
    return jogFollowed(state, direction, direction.tail<3>().isZero() ? kTravelSeen : kTurnSeen);
}

std::optional<NearestBodies> nearestBodies(const SessionState& state, double beyond) {
    std::optional<NearestBodies> nearest;
    if (state.check == nullptr) {
        return nearest;
    }
    const collision::CollisionCheck::Placement here = state.check->place(state.q);
    for (const collision::CollisionCheck::Pair& pair : state.check->pairs()) {
        const double distance = state.check->distance(pair, here, pair.margin + beyond);
        if (distance - pair.margin < beyond) {
            beyond = distance - pair.margin;
            nearest = NearestBodies{pair, distance};
        }
    }
    return nearest;
}

int escapeKey(const SessionState& state, const Eigen::Matrix3d& R_base_frame, int joint) {
    const double away = state.q[joint] > 0 ? -1.0 : 1.0;
    constexpr double kMinValue = 0.05;  // smaller gains are ignored [rad/m]
    return bestKey(state, R_base_frame, kMinValue, [&](const Vector6& qd) { return away * qd[joint]; });
}

int escapeKeyFrom(const SessionState& state, const Eigen::Matrix3d& R_base_frame,
                  const collision::CollisionCheck::Pair& pair) {
    const collision::CollisionCheck& check = *state.check;
    const double here = check.distance(pair, check.place(state.q));
    constexpr double kMinValue = 0.1;  // smaller gains are ignored [m/m]
    return bestKey(state, R_base_frame, kMinValue, [&](const Vector6& qd) {
        constexpr double kMoment = 1e-3;  // duration of the motion whose effect is computed [s]
        const JointPositions next(Vector6(state.q.values + kMoment * qd));
        return (check.distance(pair, check.place(next)) - here) / kMoment;
    });
}

int escapeKeyFrom(const SessionState& state, const Eigen::Matrix3d& R_base_frame, Singularity singularity) {
    const auto measure = [&](const JointPositions& at) {
        const auto near = kinematics::singularityMeasure(state.dh, at);
        return singularity == Singularity::Wrist   ? near.wrist
               : singularity == Singularity::Elbow ? near.elbow
                                                   : near.shoulder;
    };
    constexpr double kJump = 0.5;  // joint change that indicates a different configuration [rad]
    const double here = measure(state.q);
    const Pose start = kinematics::forwardTcp(state.dh, state.q, state.tcpOffset);
    int best = -1;
    double most = 0.01;  // smaller gains are ignored
    for (int key = 0; key < kPadKeys; ++key) {
        const Vector6 twist = twistOf(key, R_base_frame);
        Pose pose = start;
        pose.position += twist.head<3>() * kMinTravel;
        if (key >= kPadKeys / 2) {
            pose.rotation = rotationVector(Eigen::AngleAxisd(kMinTravelAngle, twist.tail<3>()) *
                                           rotationMatrix(start.rotation));
        }
        const auto next = kinematics::inverseNearest(state.dh, pose, state.tcpOffset, state.q);
        if (!next || (next->values - state.q.values).cwiseAbs().maxCoeff() > kJump) {
            continue;
        }
        if (const double gain = measure(*next) - here; gain > most && hasTravelLeft(state, twist, key)) {
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
