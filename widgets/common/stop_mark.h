// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace tiller {

/// Property of the STOP button. HoldRules uses it to report STOP as the cause.
inline constexpr char kStopButtonProperty[] = "tillerStopButton";

}  // namespace tiller
