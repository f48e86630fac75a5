// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Order of windows on the screen.

#include <QList>
#include <QRegion>
#include <QWindow>

namespace tiller {

enum class Stacking {
    Done,
    NoneVisible,  ///< none of the reference windows is on the screen, e.g. because they are minimised
    Unsupported,  ///< not available on this platform
};

/// Keeps a window that the window manager does not manage, e.g. a tooltip, above all reference windows. Some window
/// managers, e.g. metacity, raise such a window above all others at any time, so the parts of it that belong to
/// another program are returned instead of changing the order.
/// covered  receives the parts of `unmanaged` that windows of other programs cover or would cover if they were not
///          below it [px, device-independent, relative to `unmanaged`]
Stacking keepAbove(const QList<QWindow*>& references, const QWindow& unmanaged, QRegion& covered);

}  // namespace tiller
