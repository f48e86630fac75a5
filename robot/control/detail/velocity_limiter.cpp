// SPDX-License-Identifier: MIT
#include "robot/control/detail/velocity_limiter.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "robot/kinematics/arm_kinematics.h"
#include "robot/kinematics/parallel_axes.h"

namespace tiller::control {

namespace {

// During Cartesian jogging single joints may be faster than a joint jog lets them, up to this: the caps on
// the TCP are what the operator feels. Near a singularity this is what slows the arm down.
constexpr double kCartesianJointSpeed = 1.5;  // [rad/s]

// Braking in front of a joint limit. Gentler than what a stop does, so that it can always be kept up with,
// and begun early enough for the time a command takes to reach the arm.
constexpr double kLimitDeceleration = 1.0;  // [rad/s2]
constexpr double kLimitLatency = 0.03;      // [s]
constexpr double kLimitMargin = 0.01;       // [rad] kept free before the end of the range

// Less than this is not worth creeping for: it counts as blocked.
constexpr double kSmallestScale = 0.02;

// Where slowing down begins, and where motion further in ends.
struct SingularityZone {
    double begin;
    double end;
};
constexpr SingularityZone kWristZone{0.17, 0.03};     // |sin q5|: 10 deg, 1.7 deg
constexpr SingularityZone kElbowZone{0.26, 0.05};     // |sin q3|: 15 deg, 3 deg
constexpr SingularityZone kShoulderZone{0.10, 0.02};  // [m] between wrist and the base axis' cylinder

constexpr int kBase = 0;
constexpr int kElbow = 2;
constexpr int kWrist2 = 4;

struct Geometry {
    Matrix6 jacobian;                   // of the TCP, base frame
    Eigen::Matrix<double, 3, 6> elbow;  // of the elbow, linear part only
};

// The TCP's place comes from the robot, so that neither TCP offset nor calibration need to be known.
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

// Damped so little that it only matters in the singularity itself, where it keeps the numbers finite.
Vector6 jointSpeeds(const Matrix6& jacobian, const Vector6& twist) {
    constexpr double kDamping = 1e-3;
    Matrix6 normal = jacobian * jacobian.transpose();
    normal.diagonal().array() += kDamping * kDamping;
    const Vector6 solved = normal.ldlt().solve(twist);
    return jacobian.transpose() * solved;
}

void hold(Limiter& limiter, double scale, LimiterKind kind, int joint = -1, double distance = 0) {
    if (scale < limiter.scale) {
        limiter = {kind, joint, distance, std::max(scale, 0.0)};
    }
}

void holdTo(Limiter& limiter, double speed, double cap, LimiterKind kind, int joint = -1) {
    if (speed > cap) {
        hold(limiter, cap / speed, kind, joint);
    }
}

// The speed from which the arm still comes to rest in time.
double approachSpeed(double distance) {
    if (distance <= 0) {
        return 0;
    }
    const double a = kLimitDeceleration;
    return a * (std::sqrt(kLimitLatency * kLimitLatency + 2 * distance / a) - kLimitLatency);
}

void holdAtSingularity(Limiter& limiter, double here, double ahead, const SingularityZone& zone, int joint) {
    if (ahead < here && here < zone.begin) {
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

ArmLimits ArmLimits::of(const RobotModel& model, const script::RobotConfiguration& told) {
    ArmLimits limits = of(model);
    limits.dh = kinematics::calibrated(model, told.dh);
    for (std::size_t joint = 0; joint < limits.maxSpeed.size(); ++joint) {
        const double least = told.minPosition[joint];
        const double most = told.maxPosition[joint];
        if (std::isfinite(most - least) && most > least) {
            limits.minPosition[joint] = least;
            limits.maxPosition[joint] = most;
        }
        if (const double speed = told.maxSpeed[joint]; std::isfinite(speed) && speed > 0) {
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

Limiter VelocityLimiter::limit(const JogTarget& target, const JointPositions& q, const Pose& tcpPose) const {
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
    const double wanted = limiter.scale;  // what the caps leave; the rest is the arm's own shape
    for (int joint = 0; joint < kJointCount; ++joint) {
        const auto i = static_cast<std::size_t>(joint);
        const double speed = std::abs(qd[joint]);
        holdTo(limiter, speed, std::min(jointCap, arm_.maxSpeed[i]), LimiterKind::JointSpeed, joint);
        constexpr double kNoSpeed = 1e-6;
        if (speed < kNoSpeed) {
            continue;
        }
        const double left = qd[joint] > 0 ? arm_.maxPosition[i] - q[joint] : q[joint] - arm_.minPosition[i];
        const double allowed = approachSpeed(left - kLimitMargin);
        if (speed > allowed) {
            hold(limiter, allowed / speed, LimiterKind::JointLimit, joint, std::max(left, 0.0));
        }
    }
    const double fastest = qd.cwiseAbs().maxCoeff();
    if (cartesian && fastest > 0) {
        // Joint jogs may pass: it is Cartesian motion that a singularity makes wild.
        constexpr double kLookAhead = 0.005;  // [rad] of the fastest joint
        const JointPositions next(Vector6(q.values + qd * (kLookAhead / fastest)));
        const auto here = kinematics::singularityMeasure(arm_.dh, q);
        const auto ahead = kinematics::singularityMeasure(arm_.dh, next);
        holdAtSingularity(limiter, here.wrist, ahead.wrist, kWristZone, kWrist2);
        holdAtSingularity(limiter, here.elbow, ahead.elbow, kElbowZone, kElbow);
        holdAtSingularity(limiter, here.shoulder, ahead.shoulder, kShoulderZone, kBase);
    }
    if (limiter.scale < kSmallestScale * wanted) {
        limiter.scale = 0;
        if (limiter.kind == LimiterKind::JointSpeed) {
            limiter.kind = LimiterKind::Singularity;  // nowhere else would a joint have to be that fast
        }
    }
    return limiter;
}

}  // namespace tiller::control
