// SPDX-License-Identifier: MIT
#pragma once

#include <QString>

namespace tiller {

/// Name of a joint in the operator's language, e.g. "Shoulder".
/// joint    0 (base) ... 5 (wrist 3)
/// Threads  any
QString jointName(int joint);

}  // namespace tiller
