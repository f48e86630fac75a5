// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace tiller {

/// Makes ":/tiller/..." available; needed because the files live in a static library. Cheap to call again.
void initResources();

}  // namespace tiller
