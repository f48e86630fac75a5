// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QWidget;

namespace tiller {

/// True for a widget with text input. While it has the focus, keys must not move the arm.
bool takesText(const QWidget* widget);

/// Marks a field whose text was rejected, so that the text is not the value of the field.
void markRefused(QWidget& field, bool refused);
bool isMarkedRefused(const QWidget& field);

}  // namespace tiller
