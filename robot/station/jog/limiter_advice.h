// SPDX-License-Identifier: MIT
#pragma once

// Names what limits the arm now, and the key that leads away from it.

#include <QString>

#include "robot/station/link/session_state.h"

namespace tiller {

/// What limits the arm, and what to do; both empty when nothing does.
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
