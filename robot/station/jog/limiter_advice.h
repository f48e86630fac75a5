// SPDX-License-Identifier: MIT
#pragma once

// Names the limit that affects the arm now, and the key that leads away from it.

#include <QString>

#include "robot/station/link/session_state.h"

namespace tiller {

/// The limit and the suggested action; both empty without a limit.
struct LimiterAdvice {
    QString what;
    QString advice;
};

/// The nearest limit worth a word: a joint within 15 deg of its range, or a singularity close by.
/// Threads  any
/// R_base_frame  the axes the keys of the pad move in, for the way out
LimiterAdvice nearestLimiter(const SessionState& state,
                             const Eigen::Matrix3d& R_base_frame = Eigen::Matrix3d::Identity());

}  // namespace tiller
