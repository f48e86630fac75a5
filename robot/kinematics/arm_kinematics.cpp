// SPDX-License-Identifier: MIT
#include "robot/kinematics/arm_kinematics.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace tiller::kinematics {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kTwoPi = 2.0 * std::numbers::pi;

Eigen::Isometry3d link(double a, double d, double alpha, double theta) {
    const double ct = std::cos(theta);
    const double st = std::sin(theta);
    const double ca = std::cos(alpha);
    const double sa = std::sin(alpha);
    Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
    T.linear() << ct, -st * ca, st * sa,  //
        st, ct * ca, -ct * sa,            //
        0, sa, ca;
    T.translation() << a * ct, a * st, d;
    return T;
}

/// Wraps an angle into (-pi, pi].
double wrapped(double angle) {
    const double result = angle - kTwoPi * std::floor((angle + kPi) / kTwoPi);
    return result <= -kPi ? result + kTwoPi : result;
}

Matrix6 jacobianAt(const std::array<Eigen::Isometry3d, 7>& frames, const Eigen::Vector3d& point) {
    Matrix6 J;
    for (int i = 0; i < kJointCount; ++i) {
        const Eigen::Isometry3d& frame = frames[static_cast<std::size_t>(i)];
        const Eigen::Vector3d axis = frame.linear().col(2);
        J.block<3, 1>(0, i) = axis.cross(point - frame.translation());
        J.block<3, 1>(3, i) = axis;
    }
    return J;
}

/// The twist in the base frame that moves `actual` to `target` in unit time.
Vector6 difference(const Eigen::Isometry3d& target, const Eigen::Isometry3d& actual) {
    Vector6 result;
    result << target.translation() - actual.translation(),
        rotationVector(target.linear() * actual.linear().transpose());
    return result;
}

constexpr double kConverged = 1e-13;
constexpr double kAccepted = 1e-9;
constexpr int kMaxRefinements = 12;

/// Newton steps on the actual kinematic chain, damped to remain finite at a singularity. The closed form
/// assumes exact right angles, so usually one step removes the error of 1e-10 caused by the controller's
/// rounded pi/2.
/// Returns  false if the pose is not reachable
bool refine(const DhParameters& dh, const Eigen::Isometry3d& target, JointPositions& q) {
    constexpr double kDamping = 1e-14;
    double best = std::numeric_limits<double>::infinity();
    JointPositions candidate = q;
    for (int i = 0; i <= kMaxRefinements; ++i) {
        const auto frames = linkFrames(dh, candidate);
        const Vector6 error = difference(target, frames[6]);
        const double size = error.cwiseAbs().maxCoeff();
        if (size < best) {
            best = size;
            q = candidate;
        }
        if (size < kConverged || size > 10 * best) {
            break;
        }
        const Matrix6 J = jacobianAt(frames, frames[6].translation());
        Matrix6 JJt = J * J.transpose();
        JJt.diagonal().array() += kDamping;
        candidate.values += J.transpose() * JJt.ldlt().solve(error);
    }
    return best < kAccepted;
}

/// For a free wrist 3: the smallest rotation of axis 5 about axis 2 for which upper arm and forearm reach
/// from the shoulder to the end of the forearm [rad]. 0 if the point is already reachable, or cannot be
/// reached at all.
/// T_1_4  transform with the current axis 5; axis 2 is z of frame 1
double turnIntoReach(const Eigen::Isometry3d& T_1_4, double d5, double a2, double a3) {
    const Eigen::Vector2d axis5 = T_1_4.linear().col(2).head<2>();
    const Eigen::Vector2d wrist = T_1_4.translation().head<2>() + d5 * axis5;
    const double away = wrist.norm();
    const double longest2 = (a2 + a3) * (a2 + a3);
    const double shortest2 = (a2 - a3) * (a2 - a3);
    // Angle between the wrist and axis 5 at which the distance to be reached is sqrt(length2) [rad]. The
    // distance increases with the angle.
    const auto between = [&](double length2) {
        return std::acos(std::clamp((away * away + d5 * d5 - length2) / (2 * d5 * away), -1.0, 1.0));
    };
    const double now = std::atan2(wrist.x() * axis5.y() - wrist.y() * axis5.x(), wrist.dot(axis5));
    const double wanted = std::clamp(std::abs(now), between(shortest2), between(longest2));
    return std::copysign(wanted, now) - now;
}

/// Refines and wraps a closed-form candidate, and adds it unless it is a duplicate.
void keep(const DhParameters& dh, const Eigen::Isometry3d& target, JointPositions q, InverseSolutions& into) {
    for (int i = 0; i < kJointCount; ++i) {
        q[i] -= dh.theta[static_cast<std::size_t>(i)];
    }
    if (!q.allFinite() || !refine(dh, target, q)) {
        return;
    }
    for (int i = 0; i < kJointCount; ++i) {
        q[i] = wrapped(q[i]);
    }
    for (const JointPositions& known : into.span()) {
        double distance = 0;
        for (int i = 0; i < kJointCount; ++i) {
            distance = std::max(distance, std::abs(wrapped(q[i] - known[i])));
        }
        if (distance < 1e-6) {
            return;
        }
    }
    into.q[static_cast<std::size_t>(into.count++)] = q;
}

}  // namespace

Eigen::Isometry3d linkTransform(const DhParameters& dh, int joint, double q) {
    const auto i = static_cast<std::size_t>(joint);
    const Eigen::Isometry3d T = link(dh.a[i], dh.d[i], dh.alpha[i], q + dh.theta[i]);
    return dh.beta[i] == 0 ? T : T * Eigen::AngleAxisd(dh.beta[i], Eigen::Vector3d::UnitY());
}

std::array<Eigen::Isometry3d, 7> linkFrames(const DhParameters& dh, const JointPositions& q) {
    std::array<Eigen::Isometry3d, 7> frames;
    frames[0].setIdentity();
    for (int joint = 0; joint < kJointCount; ++joint) {
        const auto i = static_cast<std::size_t>(joint);
        frames[i + 1] = frames[i] * linkTransform(dh, joint, q[joint]);
    }
    return frames;
}

Eigen::Isometry3d forward(const DhParameters& dh, const JointPositions& q) {
    return linkFrames(dh, q)[6];
}

Pose forwardTcp(const DhParameters& dh, const JointPositions& q, const Pose& tcpOffset) {
    return Pose(forward(dh, q) * tcpOffset.transform());
}

Matrix6 jacobian(const DhParameters& dh, const JointPositions& q, const Pose& tcpOffset) {
    const auto frames = linkFrames(dh, q);
    return jacobianAt(frames, frames[6] * tcpOffset.position);
}

InverseSolutions inverse(const DhParameters& dh, const Eigen::Isometry3d& T_base_flange,
                         double wrist3AtSingularity) {
    // Tolerance for poses on the boundary of the workspace, which rounding can move outside.
    constexpr double kEdge = 1e-8;
    constexpr double kWristSingular = 1e-8;

    InverseSolutions result;
    if (!T_base_flange.matrix().allFinite()) {
        return result;
    }
    const double d1 = dh.d[0];
    const double a2 = dh.a[1];
    const double a3 = dh.a[2];
    const double d4 = dh.d[3];
    const double d5 = dh.d[4];
    const double d6 = dh.d[5];
    const Eigen::Matrix3d R = T_base_flange.linear();
    const Eigen::Vector3d p05 = T_base_flange.translation() - d6 * R.col(2);

    // In the top view, the distance of the wrist centre from the plane of the arm is d4.
    const double radius2 = p05.x() * p05.x() + p05.y() * p05.y();
    const double alongArm2 = radius2 - d4 * d4;
    if (alongArm2 < -kEdge) {
        return result;
    }
    const double alongArm = std::sqrt(std::max(alongArm2, 0.0));
    const double heading = std::atan2(p05.y(), p05.x()) + kPi / 2;

    for (const double shoulderSide : {1.0, -1.0}) {
        const double theta1 = heading + shoulderSide * std::atan2(alongArm, d4);
        const double s1 = std::sin(theta1);
        const double c1 = std::cos(theta1);
        // Components of axis 6 and of the flange's x and y axes along axis 2: cos theta5, and sin theta5
        // multiplied by cos theta6 and by -sin theta6.
        const double cos5 = R(0, 2) * s1 - R(1, 2) * c1;
        const double alongX = R(0, 0) * s1 - R(1, 0) * c1;
        const double alongY = -R(0, 1) * s1 + R(1, 1) * c1;
        const double sin5 = std::hypot(alongX, alongY);

        for (const double wristSide : {1.0, -1.0}) {
            double theta5 = wristSide * std::atan2(sin5, cos5);
            double theta6 = std::atan2(wristSide * alongY, wristSide * alongX);
            if (sin5 < kWristSingular) {
                theta5 = cos5 > 0 ? 0 : kPi;
                theta6 = wrist3AtSingularity + dh.theta[5];
            }
            const Eigen::Isometry3d T_1_6 = link(0, d1, kPi / 2, theta1).inverse() * T_base_flange;
            const auto T_1_4With = [&](double wrist3) -> Eigen::Isometry3d {
                return T_1_6 * (link(0, d5, -kPi / 2, theta5) * link(0, d6, 0, wrist3)).inverse();
            };
            if (sin5 < kWristSingular) {
                // At the singularity, wrist 3 rotates axis 5 about axis 2. The sign depends on theta5.
                const double turn = turnIntoReach(T_1_4With(theta6), d5, a2, a3);
                theta6 += cos5 > 0 ? -turn : turn;
            }
            const Eigen::Isometry3d T_1_4 = T_1_4With(theta6);
            const Eigen::Vector3d p13 = T_1_4 * Eigen::Vector3d(0, -d4, 0);

            const double reach2 = p13.x() * p13.x() + p13.y() * p13.y();
            // 1 - cos and 1 + cos of theta3, which remain accurate where cos alone is not.
            const double fromStretched = ((a2 + a3) * (a2 + a3) - reach2) / (2 * a2 * a3);
            const double fromFolded = (reach2 - (a2 - a3) * (a2 - a3)) / (2 * a2 * a3);
            if (fromStretched < -kEdge || fromFolded < -kEdge) {
                continue;
            }
            const double bend =
                2 * std::atan2(std::sqrt(std::max(fromStretched, 0.0)), std::sqrt(std::max(fromFolded, 0.0)));
            for (const double theta3 : {bend, -bend}) {
                const double theta2 = std::atan2(p13.y(), p13.x()) -
                                      std::atan2(a3 * std::sin(theta3), a2 + a3 * std::cos(theta3));
                const Eigen::Isometry3d T_3_4 =
                    (link(a2, 0, 0, theta2) * link(a3, 0, 0, theta3)).inverse() * T_1_4;
                const double theta4 = std::atan2(T_3_4(1, 0), T_3_4(0, 0));
                keep(dh, T_base_flange, {theta1, theta2, theta3, theta4, theta5, theta6}, result);
            }
        }
    }
    return result;
}

std::optional<JointPositions> inverseNearest(const DhParameters& dh, const Pose& tcpPose,
                                             const Pose& tcpOffset, const JointPositions& qNear,
                                             double jointLimit) {
    const Eigen::Isometry3d T_base_flange =
        tcpPose.transform() * tcpOffset.transform().inverse(Eigen::Isometry);
    const InverseSolutions solutions = inverse(dh, T_base_flange, qNear[5]);

    std::optional<JointPositions> nearest;
    double nearestDistance = std::numeric_limits<double>::infinity();
    for (const JointPositions& solution : solutions.span()) {
        JointPositions turned;
        double distance = 0;
        for (int i = 0; i < kJointCount; ++i) {
            // Each joint may be shifted by full turns independently.
            double best = std::numeric_limits<double>::infinity();
            for (const double turn : {-kTwoPi, 0.0, kTwoPi}) {
                const double q = solution[i] + turn;
                if (std::abs(q) <= jointLimit && std::abs(q - qNear[i]) < best) {
                    best = std::abs(q - qNear[i]);
                    turned[i] = q;
                }
            }
            distance += best * best;
        }
        if (distance < nearestDistance) {
            nearestDistance = distance;
            nearest = turned;
        }
    }
    return nearest;
}

SingularityMeasure singularityMeasure(const DhParameters& dh, const JointPositions& q) {
    const double q2 = q[1] + dh.theta[1];
    const double q23 = q2 + q[2] + dh.theta[2];
    const double q234 = q23 + q[3] + dh.theta[3];
    SingularityMeasure measure;
    measure.wrist = std::abs(std::sin(q[4] + dh.theta[4]));
    measure.elbow = std::abs(std::sin(q[2] + dh.theta[2]));
    measure.shoulder = std::abs(dh.a[1] * std::cos(q2) + dh.a[2] * std::cos(q23) + dh.d[4] * std::sin(q234));
    return measure;
}

}  // namespace tiller::kinematics
