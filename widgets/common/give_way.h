// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What is shown or hidden beside a widget must not change how much room both need: a panel that is as small as it can
// be would grow, and the key that was pressed go from under the pointer.

#include <QWidget>
#include <algorithm>

namespace tiller {

/// From now on the widget needs that much less height than it says itself [px]; 0: what it says.
inline void giveWay(QWidget& widget, int height) {
    widget.setMinimumHeight(height == 0 ? 0 : std::max(1, widget.minimumSizeHint().height() - height));
}

}  // namespace tiller
