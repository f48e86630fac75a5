// SPDX-License-Identifier: MIT
#pragma once

// Names the limit that currently affects the arm, and the key that leads away from it.

#include <QString>

#include "robot/station/link/session_state.h"

namespace tiller {

/// The limit and the suggested action; both empty if there is none.
struct LimiterAdvice {
    QString what;
    QString advice;
};

/// The nearest relevant limit: a joint within 15 deg of its range, or a nearby singularity.
/// Threads  any
/// R_base_frame  axes of the keys of the pad, for the suggested key
LimiterAdvice nearestLimiter(const SessionState& state,
                             const Eigen::Matrix3d& R_base_frame = Eigen::Matrix3d::Identity());

}  // namespace tiller
