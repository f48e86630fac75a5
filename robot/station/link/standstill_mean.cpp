// SPDX-License-Identifier: MIT
#include "robot/station/link/standstill_mean.h"

#include "robot/kinematics/arm_kinematics.h"

namespace tiller {

StandstillMean::Outcome StandstillMean::add(const SessionState& state) {
    if (state.sequence == sequence_) {
        return Outcome::Collecting;
    }
    sequence_ = state.sequence;
    if (state.moving || state.motionActive) {
        return Outcome::Moved;
    }
    const Eigen::Matrix3d R = kinematics::forward(state.dh, state.q).linear();
    const Wrench felt =
        state.rawWrenchKnown
            ? state.rawWrench
            : kinematics::feltAtFlange(state.tcpForce, R, state.tcpOffset.position, state.payloadMass,
                                       state.payloadCentre, -Eigen::Vector3d::UnitZ());
    if (!felt.vector().allFinite() || !state.tcpForce.vector().allFinite()) {
        return Outcome::NoForce;
    }
    felt_ = felt_ + felt;
    left_ = left_ + state.tcpForce;
    if (++count_ < kSamples) {
        return Outcome::Collecting;
    }
    reading_ = {R, felt_ * (1.0 / count_)};
    remaining_ = left_ * (1.0 / count_);
    payloadMass_ = state.payloadMass;
    return Outcome::Done;
}

}  // namespace tiller
