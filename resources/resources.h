// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace tiller {

/// Registers the resources under ":/tiller/". Required because they are in a static library. Further calls
/// have no effect.
void initResources();

}  // namespace tiller
