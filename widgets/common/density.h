// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Size of buttons, fields and table rows, for the style sheet and the tables. After a change, all widgets
// receive QEvent::StyleChange, as after a change of theme.

class QApplication;
class QTableView;

namespace tiller {

enum class Density {
    Compact,  ///< for a mouse; shows more content on the screen
    Mouse,
    Touch,  ///< for fingers: 48 px buttons, 44 px rows
};

/// The current density. Initially Mouse.
/// Threads  GUI
Density currentDensity();
/// Sets the sizes for the whole application. Call applyTheme() afterwards.
/// Threads  GUI
void applyDensity(QApplication& application, Density density);

/// Row height of tables [px].
int rowHeight(Density density);
/// Height of buttons outside the jog column [px].
int keyHeight(Density density);

/// Minimum size of small touch targets (tabs, joint buttons, buttons in title bars) [px]. Returns 0 for
/// mouse-sized controls, i.e. if the density is not Touch or the window is too small.
int touchHeight();
/// Sets whether the window is large enough for touch targets. Initially true. With Touch density, a change
/// updates the layout of the application.
/// Threads  GUI
void setRoomForTouch(QApplication& application, bool room);
/// Minimum window height for touch targets [px].
inline constexpr int kRoomForTouch = 980;

/// Keeps the row height of the table up to date when the density changes.
void followDensity(QTableView& table);

}  // namespace tiller
