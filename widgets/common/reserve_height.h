// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Keeps the total height of a widget and an element next to it constant when the element is shown or hidden.
// Otherwise, a panel at its minimum size would grow and move the pressed button away from the pointer.

#include <QWidget>
#include <algorithm>

namespace tiller {

/// Reduces the minimum height of the widget by this value [px]. 0 restores the normal minimum height.
inline void reserveHeight(QWidget& widget, int height) {
    widget.setMinimumHeight(height == 0 ? 0 : std::max(1, widget.minimumSizeHint().height() - height));
}

}  // namespace tiller
