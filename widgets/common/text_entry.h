// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QWidget;

namespace tiller {

/// True for a widget in which keys write: no key that moves the arm may be meant there.
bool takesText(const QWidget* widget);

}  // namespace tiller
