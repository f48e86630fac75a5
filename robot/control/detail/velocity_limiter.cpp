// SPDX-License-Identifier: MIT
#include "robot/control/detail/velocity_limiter.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "robot/kinematics/arm_kinematics.h"
#include "robot/kinematics/parallel_axes.h"

namespace tiller::control {

namespace {

// Joint speed limit for Cartesian jogging, which slows the arm down near a singularity. It is higher than for
// joint jogging, because the TCP limits also apply.
constexpr double kCartesianJointSpeed = 1.5;  // [rad/s]

// Deceleration before a joint limit. It is lower than for a stop, so that it is always achieved, and leaves a
// reserve for the command delay.
constexpr double kLimitDeceleration = 1.0;  // [rad/s2]
constexpr double kLimitLatency = 0.03;      // [s]
constexpr double kLimitMargin = 0.01;       // [rad], distance kept from the limit

// Deceleration before a collision, as a fraction of the deceleration of a stop.
constexpr double kClearDeceleration = 0.5;
// Maximum intrusion into the safety distance at the end of a jog [m]. A smaller value would prevent sliding
// along a wall.
constexpr double kClearBand = 0.0003;
constexpr double kDeepInside = 0.0006;
// An approach below this fraction of the body's maximum speed counts as sliding. Deep within the safety
// distance, only rounding errors count as sliding.
constexpr double kSliding = 2e-3;
constexpr double kSlidingDeepInside = 1e-4;

// Motion with a smaller scale is blocked.
constexpr double kSmallestScale = 0.02;

// Singularity measures at which slowing down begins and at which motion towards the singularity ends.
struct SingularityZone {
    double begin;
    double end;
};
constexpr SingularityZone kWristZone{0.17, 0.03};  // |sin q5|: 10 deg, 1.7 deg
constexpr SingularityZone kElbowZone{0.26, 0.05};  // |sin q3|: 15 deg, 3 deg
constexpr SingularityZone kShoulderZone{0.10,
                                        0.02};  // [m], from the wrist to the cylinder around the base axis

/// Below this fraction of SingularityZone::end, linear motion is blocked even away from the singularity. The
/// joint speeds would have to change faster than a robot can follow, which would cause a protective stop.
constexpr double kDeepPart = 1.0 / 3;

constexpr int kBase = 0;
constexpr int kElbow = 2;
constexpr int kWrist2 = 4;

struct Geometry {
    Matrix6 jacobian;                   // Jacobian of the TCP in the base frame
    Eigen::Matrix<double, 3, 6> elbow;  // Jacobian of the elbow in the base frame, linear part only
};

// The robot reports the TCP position, so TCP offset and calibration are not needed.
Geometry geometryAt(const DhParameters& dh, const JointPositions& q, const Eigen::Vector3d& tcp) {
    const auto frames = kinematics::linkFrames(dh, q);
    const Eigen::Vector3d elbow = frames[2].translation();
    Geometry g;
    g.elbow.setZero();
    for (int joint = 0; joint < kJointCount; ++joint) {
        const auto& frame = frames[static_cast<std::size_t>(joint)];
        const Eigen::Vector3d axis = frame.linear().col(2);
        g.jacobian.block<3, 1>(0, joint) = axis.cross(tcp - frame.translation());
        g.jacobian.block<3, 1>(3, joint) = axis;
        if (joint < kElbow) {
            g.elbow.col(joint) = axis.cross(elbow - frame.translation());
        }
    }
    return g;
}

// The damping has an effect only at the singularity, where it keeps the values finite.
Vector6 jointSpeeds(const Matrix6& jacobian, const Vector6& twist) {
    constexpr double kDamping = 1e-4;
    Matrix6 normal = jacobian * jacobian.transpose();
    normal.diagonal().array() += kDamping * kDamping;
    const Vector6 solved = normal.ldlt().solve(twist);
    return jacobian.transpose() * solved;
}

void hold(Limiter& limiter, double scale, LimiterKind kind, int joint = -1, double distance = 0) {
    if (scale < limiter.scale) {
        limiter = {};
        limiter.kind = kind;
        limiter.joint = joint;
        limiter.distance = distance;
        limiter.scale = std::max(scale, 0.0);
    }
}

void holdTo(Limiter& limiter, double speed, double cap, LimiterKind kind, int joint = -1) {
    if (speed > cap) {
        hold(limiter, cap / speed, kind, joint);
    }
}

// Speed from which the arm can stop within the distance.
double approachSpeed(double distance, double deceleration) {
    if (distance <= 0) {
        return 0;
    }
    return deceleration *
           (std::sqrt(kLimitLatency * kLimitLatency + 2 * distance / deceleration) - kLimitLatency);
}

LimiterKind limiterKind(collision::Contact::With with) {
    switch (with) {
        case collision::Contact::With::Arm:
            return LimiterKind::SelfCollision;
        case collision::Contact::With::Obstacle:
            return LimiterKind::Obstacle;
        case collision::Contact::With::Border:
            break;
    }
    return LimiterKind::Border;
}

void holdAtSingularity(Limiter& limiter, double here, double ahead, const SingularityZone& zone, int joint) {
    if (here < zone.end * kDeepPart) {
        hold(limiter, 0, LimiterKind::Singularity, joint);
    } else if (ahead < here && here < zone.begin) {
        hold(limiter, (here - zone.end) / (zone.begin - zone.end), LimiterKind::Singularity, joint);
    }
}

}  // namespace

ArmLimits ArmLimits::of(const RobotModel& model) {
    ArmLimits limits;
    limits.dh = model.dh;
    limits.minPosition.fill(-kJointPositionLimit);
    limits.maxPosition.fill(kJointPositionLimit);
    limits.maxSpeed = model.maxJointSpeed;
    limits.maxTorque = model.maxTorque;
    return limits;
}

ArmLimits ArmLimits::of(const RobotModel& model, const script::RobotConfiguration& reported) {
    ArmLimits limits = of(model);
    limits.dh = kinematics::calibrated(model, reported.dh);
    for (std::size_t joint = 0; joint < limits.maxSpeed.size(); ++joint) {
        const double least = reported.minPosition[joint];
        const double most = reported.maxPosition[joint];
        if (std::isfinite(most - least) && most > least) {
            limits.minPosition[joint] = least;
            limits.maxPosition[joint] = most;
        }
        if (const double speed = reported.maxSpeed[joint]; std::isfinite(speed) && speed > 0) {
            limits.maxSpeed[joint] = speed;
        }
    }
    return limits;
}

Twist twistInBase(const JogTarget& target, const Pose& tcpPose) {
    switch (target.frame) {
        case JogFrame::Tool: {
            const Eigen::Matrix3d R = rotationMatrix(tcpPose.rotation);
            return {R * target.twist.linear, R * target.twist.angular};
        }
        case JogFrame::Custom: {
            const Eigen::Matrix3d R = rotationMatrix(target.T_base_frame.rotation);
            return {R * target.twist.linear, R * target.twist.angular};
        }
        case JogFrame::Base:
            break;
    }
    return target.twist;
}

/// The requested motion at a scale of 1.
struct VelocityLimiter::Motion {
    const JogTarget& target;
    const JointPositions& q;
    const Matrix6& jacobian;
    const Vector6& qd;
    const Vector6& twist;
    const Pose& tcpPose;

    bool isCartesian() const { return target.kind == JogTarget::Kind::Cartesian; }

    /// Joint positions after this time at constant TCP velocity. A straight TCP line is curved in joint
    /// space.
    JointPositions after(const DhParameters& dh, double seconds) const {
        Vector6 bend = Vector6::Zero();
        if (isCartesian()) {
            constexpr double kInterval = 1e-3;  // [s]
            const Eigen::Isometry3d T_base_flange = kinematics::forward(dh, q);
            const JointPositions next(Vector6(q.values + kInterval * qd));
            const Eigen::Vector3d tcp =
                kinematics::forward(dh, next) * (T_base_flange.inverse(Eigen::Isometry) * tcpPose.position);
            bend = (jointSpeeds(geometryAt(dh, next, tcp).jacobian, twist) - qd) / kInterval;
        }
        return JointPositions(Vector6(q.values + seconds * qd + seconds * seconds / 2 * bend));
    }
};

/// Duration of the normal deceleration of a jog [s].
double VelocityLimiter::brakingTime(bool cartesian, const Twist& twist, const Vector6& qd) const {
    const double joints = kClearDeceleration * limits_.jointDeceleration;
    if (!cartesian) {
        return qd.cwiseAbs().maxCoeff() / joints;
    }
    return std::max(twist.linear.norm() / (kClearDeceleration * limits_.jogDeceleration),
                    twist.angular.norm() / joints);
}

// Makes the arm stop at the safety distance from all objects. The approach speed to each object is calculated
// from the distances after a very short motion (kMoment) and at the expected stop position, because the
// nearest object at that position may differ from the current one.
void VelocityLimiter::keepClear(Limiter& limiter, const Motion& motion, const Situation& situation) const {
    using collision::CollisionCheck;
    const CollisionCheck& check = *situation.check;
    const Vector6& qd = motion.qd;
    const Vector6& qdNow = situation.qd.values;
    constexpr double kMoment = 2e-5;  // [rad], over all joints
    constexpr double kStandstill = 1e-9;
    const double sum = qd.cwiseAbs().sum();
    if (sum < kStandstill) {
        return;
    }
    const double moment = kMoment / sum;
    const double momentNow = kMoment / std::max(qdNow.cwiseAbs().sum(), kStandstill);
    const Vector6 twistNow = motion.jacobian * qdNow;
    const double brake =
        brakingTime(motion.isCartesian(), {motion.twist.head<3>(), motion.twist.tail<3>()}, qd);
    const double brakeNow =
        brakingTime(motion.isCartesian(), {twistNow.head<3>(), twistNow.tail<3>()}, qdNow);
    const double toRest = limiter.scale * (kLimitLatency + limiter.scale * brake / 2);
    const double toRestNow = kLimitLatency + brakeNow / 2;

    const CollisionCheck::Placement here = check.place(motion.q);
    bool isPlaced = false;
    CollisionCheck::Placement next;
    CollisionCheck::Placement nextNow;
    CollisionCheck::Placement atRest;
    for (const CollisionCheck::Pair& pair : check.pairs()) {
        const bool isCell = pair.with != collision::Contact::With::Arm;
        if (motion.target.contactForce > 0 && isCell && pair.link >= kJointCount) {
            continue;  // intended contact
        }
        const double fastest = pair.radius.dot(qd.cwiseAbs());
        const double fastestNow = pair.radius.dot(qdNow.cwiseAbs());
        const double farthest = pair.margin + std::max(fastest * toRest, fastestNow * toRestNow);
        const double distance = check.distance(pair, here, farthest);
        if (distance > farthest) {
            continue;
        }
        if (!isPlaced) {
            isPlaced = true;
            next = check.place(JointPositions(Vector6(motion.q.values + moment * qd)));
            nextNow = check.place(JointPositions(Vector6(motion.q.values + momentNow * qdNow)));
            atRest = check.place(motion.after(arm_.dh, toRest));
        }
        const double left = distance - pair.margin + kClearBand;
        const double sliding = left > kClearBand - kDeepInside ? kSliding : kSlidingDeepInside;
        const auto hold = [&](double approach) {
            if (approach <= sliding * fastest) {
                return;
            }
            const double allowed = approachSpeed(left, approach / std::max(brake, kLimitLatency));
            if (approach * limiter.scale > allowed) {
                limiter.kind = limiterKind(pair.with);
                limiter.joint = -1;
                limiter.link = pair.link;
                limiter.other = pair.otherLink;
                limiter.distance = distance;
                limiter.scale = allowed / approach;
            }
        };
        hold((distance - check.distance(pair, next)) / moment);
        constexpr double kBends = 0.0005;  // possible deviation from the expected stop position [m]
        const double rest = check.distance(pair, atRest);
        if (rest < pair.margin - kBends) {
            hold((distance - rest - kBends) / toRest);
        }
        const double approachNow = (distance - check.distance(pair, nextNow)) / momentNow;
        limiter.brake = limiter.brake ||
                        (approachNow > kSliding * fastestNow &&
                         approachNow > approachSpeed(left, approachNow / std::max(brakeNow, kLimitLatency)));
    }
}

Limiter VelocityLimiter::limit(const JogTarget& target, const JointPositions& q, const Pose& tcpPose,
                               const Situation& situation) const {
    const bool cartesian = target.kind == JogTarget::Kind::Cartesian;
    const Geometry g = geometryAt(arm_.dh, q, tcpPose.position);
    Vector6 twist;
    Vector6 qd;
    if (cartesian) {
        twist = twistInBase(target, tcpPose).vector();
        qd = jointSpeeds(g.jacobian, twist);
    } else {
        qd = target.qd.values;
        twist = g.jacobian * qd;
    }

    Limiter limiter;
    const bool isKnown = q.values.allFinite() && tcpPose.position.allFinite() &&
                         tcpPose.rotation.allFinite() && situation.qd.values.allFinite() &&
                         twist.allFinite() && qd.allFinite();
    if (!isKnown) {
        // Comparisons with non-finite values would not detect any limit.
        limiter.scale = 0;
        return limiter;
    }
    const double tcpSpeed = twist.head<3>().norm();
    const double elbowSpeed = (g.elbow * qd).norm();
    holdTo(limiter, tcpSpeed, limits_.tcpSpeed, LimiterKind::TcpSpeed);
    holdTo(limiter, elbowSpeed, limits_.tcpSpeed, LimiterKind::ElbowSpeed);
    holdTo(limiter, std::max(tcpSpeed, elbowSpeed), target.speedCap, LimiterKind::JogSpeed);
    if (cartesian) {
        holdTo(limiter, twist.tail<3>().norm(), limits_.tcpRotationSpeed, LimiterKind::RotationSpeed);
    }
    const double jointCap = cartesian ? kCartesianJointSpeed : limits_.jointSpeed;
    for (int joint = 0; joint < kJointCount && !cartesian; ++joint) {
        holdTo(limiter, std::abs(qd[joint]), jointCap, LimiterKind::JointSpeed, joint);
    }
    const double wanted = limiter.scale;  // the part allowed by the caps; the kinematics may reduce it more
    for (int joint = 0; joint < kJointCount; ++joint) {
        const auto i = static_cast<std::size_t>(joint);
        const double speed = std::abs(qd[joint]);
        holdTo(limiter, speed, std::min(jointCap, arm_.maxSpeed[i]), LimiterKind::JointSpeed, joint);
        constexpr double kNoSpeed = 1e-6;
        if (speed < kNoSpeed) {
            continue;
        }
        const double left = qd[joint] > 0 ? arm_.maxPosition[i] - q[joint] : q[joint] - arm_.minPosition[i];
        const double allowed = approachSpeed(left - kLimitMargin, kLimitDeceleration);
        if (speed > allowed) {
            hold(limiter, allowed / speed, LimiterKind::JointLimit, joint, std::max(left, 0.0));
        }
    }
    const double fastest = qd.cwiseAbs().maxCoeff();
    if (cartesian && fastest > 0) {
        // Joint jogs are not limited, because only Cartesian motion causes high joint speeds at a
        // singularity.
        const auto here = kinematics::singularityMeasure(arm_.dh, q);
        // A path may first approach the singularity and then lead away from it, or vice versa.
        for (const double lookAhead : {1e-5, 0.005}) {  // [rad], fastest joint
            const JointPositions next(Vector6(q.values + qd * (lookAhead / fastest)));
            const auto ahead = kinematics::singularityMeasure(arm_.dh, next);
            holdAtSingularity(limiter, here.wrist, ahead.wrist, kWristZone, kWrist2);
            holdAtSingularity(limiter, here.elbow, ahead.elbow, kElbowZone, kElbow);
            holdAtSingularity(limiter, here.shoulder, ahead.shoulder, kShoulderZone, kBase);
        }
    }
    if (situation.check != nullptr) {
        keepClear(limiter, {target, q, g.jacobian, qd, twist, tcpPose}, situation);
    }
    if (limiter.scale < kSmallestScale * wanted) {
        limiter.scale = 0;
        if (limiter.kind == LimiterKind::JointSpeed) {
            limiter.kind = LimiterKind::Singularity;  // only a singularity requires such a joint speed
        }
    }
    return limiter;
}

}  // namespace tiller::control
