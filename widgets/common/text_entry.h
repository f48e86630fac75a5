// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QWidget;

namespace tiller {

/// True for a widget with text input: keys must not move the arm while it has the focus.
bool takesText(const QWidget* widget);

}  // namespace tiller
