// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Order of windows on the screen.

#include <QList>
#include <QWindow>

namespace tiller {

enum class Stacking {
    Done,
    NoneVisible,  ///< none of the reference windows is on the screen, e.g. because they are minimised
    Unsupported,  ///< not available on this platform
};

/// Places a window that the window manager does not manage, e.g. a tooltip, directly above the topmost
/// reference window. Windows of other programs that are in front of the reference windows stay in front.
Stacking stackDirectlyAbove(const QList<QWindow*>& references, const QWindow& unmanaged);

}  // namespace tiller
