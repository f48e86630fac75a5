// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QWidget;

namespace tiller {

/// Enlarges a window until everything in it is whole; never shrinks it. Words that wrap need this, because
/// they tell their height only for a width.
void makeRoom(QWidget& window);

}  // namespace tiller
