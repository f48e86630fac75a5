// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QWidget;

namespace tiller {

/// Enlarges a window until its content fits, and never shrinks it. Needed for word-wrapped texts, whose
/// height depends on the width.
void fitToContents(QWidget& window);

}  // namespace tiller
