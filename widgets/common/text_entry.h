// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QWidget;

namespace tiller {

/// True for a widget with text input: keys must not move the arm while it has the focus.
bool takesText(const QWidget* widget);

/// Marks a field whose text was refused and is not its value.
void markRefused(QWidget& field, bool refused);
bool isMarkedRefused(const QWidget& field);

}  // namespace tiller
