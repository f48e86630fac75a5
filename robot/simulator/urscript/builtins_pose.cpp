// SPDX-License-Identifier: MIT
// Pose algebra. In the comments below, R(p) is the rotation of pose p, and t(p) is its translation.

#include <cmath>

#include "robot/simulator/urscript/builtin_table.h"
#include "robot/simulator/urscript/call.h"

namespace tiller::simulator::urscript {

namespace {

Status poseAdd(Call& c) {
    const Pose a = c.pose(0);
    const Pose b = c.pose(1);
    c.result = Pose(a.position + b.position,
                    rotationVector(rotationMatrix(a.rotation) * rotationMatrix(b.rotation)));
    return Status::Done;
}

Pose difference(const Pose& to, const Pose& from) {
    return {to.position - from.position,
            rotationVector(rotationMatrix(to.rotation) * rotationMatrix(from.rotation).transpose())};
}

Status poseSub(Call& c) {
    c.result = difference(c.pose(0), c.pose(1));
    return Status::Done;
}

Status poseInv(Call& c) {
    c.result = Pose(c.pose(0).transform().inverse());
    return Status::Done;
}

Status poseTrans(Call& c) {
    c.result = Pose(c.pose(0).transform() * c.pose(1).transform());
    return Status::Done;
}

Status pointDist(Call& c) {
    c.result = (c.pose(0).position - c.pose(1).position).norm();
    return Status::Done;
}

Status poseDist(Call& c) {
    const Pose d = difference(c.pose(0), c.pose(1));
    c.result = std::sqrt(d.position.squaredNorm() + d.rotation.squaredNorm());
    return Status::Done;
}

// Interpolates along a straight line and the shortest rotation. alpha outside of 0..1 extrapolates both.
Status interpolatePose(Call& c) {
    const Pose from = c.pose(0);
    const Pose to = c.pose(1);
    const double alpha = c.number(2);
    const Eigen::Matrix3d R_from = rotationMatrix(from.rotation);
    const Eigen::Vector3d turn = rotationVector(R_from.transpose() * rotationMatrix(to.rotation));
    c.result = Pose(from.position + alpha * (to.position - from.position),
                    rotationVector(R_from * rotationMatrix(alpha * turn)));
    return Status::Done;
}

Status rotvec2rpy(Call& c) {
    c.result = Value::floats(rpyFromRotationVector(c.three(0)).data(), 3);
    return Status::Done;
}

Status rpy2rotvec(Call& c) {
    c.result = Value::floats(rotationVectorFromRpy(c.three(0)).data(), 3);
    return Status::Done;
}

// Converts a wrench from frame `from` to frame `to`, including the change of the reference point.
Status wrenchTrans(Call& c) {
    const Pose T_from_to = c.pose(0);
    const std::array<double, 6> w = c.six(1);
    const Eigen::Vector3d force(w[0], w[1], w[2]);
    const Eigen::Vector3d torque(w[3], w[4], w[5]);
    const Eigen::Matrix3d R_to_from = rotationMatrix(T_from_to.rotation).transpose();
    Vector6 out;
    out << R_to_from * force, R_to_from * (torque - T_from_to.position.cross(force));
    c.result = jointList(out);
    return Status::Done;
}

constexpr BuiltinRow kPoseRows[] = {
    {"interpolate_pose(p_from, p_to, alpha)", interpolatePose},
    {"point_dist(p_from, p_to)", pointDist},
    {"pose_dist(p_from, p_to)", poseDist},
    {"pose_add(p_1, p_2)", poseAdd},
    {"pose_sub(p_to, p_from)", poseSub},
    {"pose_inv(p_from)", poseInv},
    {"pose_trans(p_from, p_from_to)", poseTrans},
    {"rotvec2rpy(rotation_vector)", rotvec2rpy},
    {"rpy2rotvec(rpy_vector)", rpy2rotvec},
    {"wrench_trans(T_from_to, w_from)", wrenchTrans, kPlain, kAfter33},
};

}  // namespace

std::span<const BuiltinRow> poseBuiltins() {
    return kPoseRows;
}

}  // namespace tiller::simulator::urscript
