// SPDX-License-Identifier: MIT
#pragma once

#include <QString>

namespace tiller {

/// "Shoulder", in the operator's language.
/// joint    0 (base) ... 5 (wrist 3)
/// Threads  any
QString jointName(int joint);

}  // namespace tiller
