// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QEvent;
class QWidget;

namespace tiller {

/// True for a widget with text input. While it has the focus, keys must not move the arm.
bool takesText(const QWidget* widget);

/// For a field that edits a value of the project. If the event is the shortcut for undo or redo, and the
/// field has no typed text to undo or redo, ignores the event, so that the shortcut applies to the project.
/// Returns  true if the event was ignored
bool leavesUndoToProject(QEvent& event, bool canUndo, bool canRedo);

/// Sets whether the field is marked as refused, i.e. its text is invalid and was not applied.
void markRefused(QWidget& field, bool refused);
bool isMarkedRefused(const QWidget& field);

}  // namespace tiller
