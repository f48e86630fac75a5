// SPDX-License-Identifier: MIT
// Forward and inverse kinematics, Jacobians and dynamics of the arm, all calculated by the host's model.

#include "robot/simulator/urscript/builtin_table.h"
#include "robot/simulator/urscript/call.h"
#include "robot/simulator/urscript/value_format.h"

namespace tiller::simulator::urscript {

namespace {

std::optional<JointPositions> jointsAt(const Call& c, std::size_t i) {
    return c.given(i) ? std::optional(c.joints(i)) : std::nullopt;
}
std::optional<Pose> poseAt(const Call& c, std::size_t i) {
    return c.given(i) ? std::optional(c.poseOr6(i)) : std::nullopt;
}
std::optional<JointVelocities> velocitiesAt(const Call& c, std::size_t i) {
    return c.given(i) ? std::optional(JointVelocities(c.six(i))) : std::nullopt;
}

Value matrixOf(const Matrix6& m) {
    MatrixData out;
    out.rows = out.cols = 6;
    out.integer = false;
    for (int r = 0; r < 6; ++r) {
        for (int col = 0; col < 6; ++col) {
            out.numbers.push_back(m(r, col));
        }
    }
    return Value::matrix(std::move(out));
}

template <class T>
const T& valueOf(const Result<T>& outcome) {
    if (!outcome.ok()) {
        fault(outcome.error());
    }
    return *outcome;
}

Status forwardKin(Call& c) {
    c.result = c.host.forwardKinematics(jointsAt(c, 0), poseAt(c, 1));
    return Status::Done;
}

std::optional<JointPositions> inverse(const Call& c) {
    KinematicsHost::InverseRequest request;
    request.pose = c.pose(0);
    if (!request.pose.allFinite()) {
        c.badArgument(0, "a pose of finite numbers");
    }
    request.qNear = jointsAt(c, 1);
    request.maxPositionError = c.number(2);
    request.maxOrientationError = c.number(3);
    request.tcp = poseAt(c, 4);
    return c.host.inverseKinematics(request);
}

Status inverseKin(Call& c) {
    const std::optional<JointPositions> q = inverse(c);
    if (!q) {
        fault("get_inverse_kin: no solution found for " + toStr(c.args[0]));
    }
    c.result = jointList(q->values);
    return Status::Done;
}

Status inverseKinHasSolution(Call& c) {
    c.result = inverse(c).has_value();
    return Status::Done;
}

Status withinSafetyLimits(Call& c) {
    c.result = c.host.isWithinSafetyLimits(c.target(0));
    return Status::Done;
}

Status jacobian(Call& c) {
    c.result = matrixOf(valueOf(c.host.jacobian(jointsAt(c, 0), poseAt(c, 1))));
    return Status::Done;
}
Status jacobianTimeDerivative(Call& c) {
    c.result =
        matrixOf(valueOf(c.host.jacobianTimeDerivative(jointsAt(c, 0), velocitiesAt(c, 1), poseAt(c, 2))));
    return Status::Done;
}
Status massMatrix(Call& c) {
    c.result = matrixOf(valueOf(c.host.massMatrix(jointsAt(c, 0), c.boolean(1))));
    return Status::Done;
}
Status coriolis(Call& c) {
    c.result = jointList(valueOf(c.host.coriolisTorques(jointsAt(c, 0), velocitiesAt(c, 1))).values);
    return Status::Done;
}

constexpr BuiltinRow kKinematicsRows[] = {
    {"get_forward_kin(q?, tcp?)", forwardKin},
    {"get_inverse_kin(x, qnear?, maxPositionError=1e-10, maxOrientationError=1e-10, tcp?)", inverseKin},
    {"get_inverse_kin_has_solution(pose, qnear?, maxPositionError=1e-10, maxOrientationError=1e-10, tcp?)",
     inverseKinHasSolution,
     kPlain,
     {{9}}},
    {"is_within_safety_limits(pose)", withinSafetyLimits},
    {"get_jacobian(q?, tcp?)", jacobian, kPlain, kAfter515},
    {"get_jacobian_time_derivative(q?, qd?, tcp?)", jacobianTimeDerivative, kPlain, kAfter515},
    {"get_mass_matrix(q?, include_rotors_inertia=False)", massMatrix, kPlain, kAfter515},
    {"get_coriolis_and_centrifugal_torques(q?, qd?)", coriolis, kPlain, kAfter515},
};

}  // namespace

std::span<const BuiltinRow> kinematicsBuiltins() {
    return kKinematicsRows;
}

}  // namespace tiller::simulator::urscript
