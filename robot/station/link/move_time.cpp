// SPDX-License-Identifier: MIT
#include "robot/station/link/move_time.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "robot/core/robot_model.h"
#include "robot/kinematics/arm_kinematics.h"
#include "robot/kinematics/speed_bounds.h"
#include "robot/station/text/format.h"
#include "robot/station/text/notation.h"

namespace tiller {
namespace {

constexpr double kMinFraction = 0.02;  // minimum of the speed slider
/// Below this speed, the motion is treated as a pure rotation of the TCP [m/s].
constexpr double kMinShownSpeed = 0.0005;
constexpr double kMinMotion = 1e-4;  // [rad], or [m] for a line; exceeds the position noise at rest

struct LineDistance {
    double distance = 0;  ///< translation of the TCP [m]
    double turn = 0;      ///< [rad]
    double length = 0;    ///< path length to which the commanded speed refers [m]
};

LineDistance lineDistance(const Pose& from, const Pose& to) {
    return {(to.position - from.position).norm(),
            rotationVector(rotationMatrix(from.rotation).transpose() * rotationMatrix(to.rotation)).norm(),
            kinematics::lineLength(from, to)};
}

/// Maximum commanded line speed at which TCP and elbow stay below `cap` [m/s].
double lineBound(const SessionState& state, const Pose& to, double cap) {
    if (!std::isfinite(cap)) {
        return std::numeric_limits<double>::infinity();
    }
    // Use the calculated TCP instead of the reported TCP, so that distance and speed bound refer to the same
    // line.
    const DhParameters& dh = state.dh;
    const LineDistance way = lineDistance(kinematics::forwardTcp(dh, state.q, state.tcpOffset), to);
    const double tcp = kinematics::lineSpeedBound(dh, state.q, to, state.tcpOffset, cap,
                                                  std::numeric_limits<double>::infinity())
                           .speed;
    return way.distance > 0 ? tcp * way.length / way.distance : std::numeric_limits<double>::infinity();
}

}  // namespace

double moveSeconds(const MoveRequest& request, const SessionState& state) {
    double distance = 0;
    if (request.kind == MoveRequest::Kind::MoveJ) {
        distance = (request.q.values - state.q.values).cwiseAbs().maxCoeff();
    } else {
        distance = kinematics::lineLength(state.tcpPose, request.pose);
    }
    return kinematics::moveDuration(distance, request.speed, request.acceleration) /
           std::max(state.speedFraction, kMinFraction);
}

QString moveSpeedText(const MoveRequest& request, const SessionState& state) {
    const double fraction = std::max(state.speedFraction, kMinFraction);
    double tcp = 0;   // [m/s]
    double turn = 0;  // [rad/s]
    if (request.kind == MoveRequest::Kind::MoveJ) {
        if ((request.q.values - state.q.values).cwiseAbs().maxCoeff() < kMinMotion) {
            return {};
        }
        // The bound is proportional to the cap. With a cap of 1 m/s, it is the joint travel per metre.
        const kinematics::SpeedBound bound =
            kinematics::jointSpeedBound(state.dh, state.q, request.q, state.tcpOffset, 1.0);
        tcp = request.speed / bound.speed;
        turn = request.speed;
    } else {
        const LineDistance way = lineDistance(state.tcpPose, request.pose);
        if (way.length < kMinMotion) {
            return {};
        }
        tcp = request.speed * way.distance / way.length;
        turn = request.speed * way.turn / way.length;
    }
    return tcp < kMinShownSpeed ? format::degreesPerSecond(turn * fraction) : format::speed(tcp * fraction);
}

MoveRequest slowedTo(const HeldSpeed& speed, MoveRequest request, const SessionState& state) {
    if (request.kind == MoveRequest::Kind::MoveJ) {
        request.speed = std::min(
            {request.speed, speed.joint,
             kinematics::jointSpeedBound(state.dh, state.q, request.q, state.tcpOffset, speed.tcp).speed});
        return request;
    }
    // The commanded speed of a line refers to the longer of distance and rotation. The factors convert the
    // limits of TCP speed and rotation speed to the commanded speed.
    const LineDistance way = lineDistance(state.tcpPose, request.pose);
    if (way.distance > kMinMotion) {
        request.speed = std::min({request.speed, speed.tcp * way.length / way.distance,
                                  lineBound(state, request.pose, speed.tcp)});
    }
    if (way.turn > kMinMotion) {
        request.speed = std::min(request.speed, speed.rotation * way.length / way.turn);
    }
    return request;
}

}  // namespace tiller
