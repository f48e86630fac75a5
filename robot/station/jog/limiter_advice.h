// SPDX-License-Identifier: MIT
#pragma once

// Text for the limit that affects the arm, and the jog button that moves the arm away from it.

#include <QString>

#include "robot/station/link/session_state.h"

namespace tiller {

/// The limit and the suggested action. Both are empty if there is no limit.
struct LimiterAdvice {
    QString what;
    QString advice;
};

/// The most relevant limit: a collision, a joint within 15 deg of its range, a speed cap, or a singularity.
/// Threads  any
/// R_base_frame  axes of the jog pad, for the suggested button
LimiterAdvice nearestLimiter(const SessionState& state,
                             const Eigen::Matrix3d& R_base_frame = Eigen::Matrix3d::Identity());

}  // namespace tiller
