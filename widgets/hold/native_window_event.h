// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Events of the display server that end a hold, read before Qt evaluates them. On X11, Qt reports a lost
// input focus only after 100 ms, in case the focus returns. Other platforms report a lost focus immediately.

#include <QByteArray>
#include <QWindow>

namespace tiller {

struct NativeWindowEvent {
    enum class Kind {
        Other,
        FocusLost,  ///< a window of Tiller lost the focus; not reported for a grab, after which the focus returns
        Hidden,  ///< the window is no longer on the screen: minimised, or on another desktop
    };
    Kind kind = Kind::Other;
    WId window = 0;
};

/// type, message  as for QAbstractNativeEventFilter; types of other platforms return Kind::Other
NativeWindowEvent nativeWindowEvent(const QByteArray& type, const void* message);

}  // namespace tiller
