// SPDX-License-Identifier: MIT
#pragma once

// Texts that explain why the arm cannot reach a waypoint: a short label and a sentence.

#include <QString>

#include "robot/project/reachability.h"

namespace tiller {

/// Short label: "✓", "✕ reach", "✕ joint", "✕ frame", "✕ line" or "✕ model".
QString reachText(const project::Reach& reach);
/// Why the waypoint is unreachable, with the suggested action; empty if it is reachable.
QString reachAdvice(const project::Reach& reach);

}  // namespace tiller
