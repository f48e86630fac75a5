// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace tiller {

/// Property of the STOP button, so that the rules of a hold can name it as the cause.
inline constexpr char kStopButtonProperty[] = "tillerStopButton";

}  // namespace tiller
