// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// How large what is clicked or touched is. The style sheet takes the heights of keys and fields from here,
// tables those of their rows. A change reaches every widget as QEvent::StyleChange, as a change of theme
// does.

class QApplication;
class QTableView;

namespace tiller {

enum class Density {
    Compact,  ///< a mouse, and much to see at once
    Mouse,
    Touch,  ///< a finger: 48 px keys, 44 px rows
};

/// The one set last; Mouse before that.
/// Threads  GUI
Density currentDensity();
/// Sizes of the whole application. Call it before applyTheme(), or anew after it.
/// Threads  GUI
void applyDensity(QApplication& application, Density density);

/// Of a table [px].
int rowHeight(Density density);
/// Of keys outside the jog column [px].
int keyHeight(Density density);

/// The least height of what a finger touches and what is small for a mouse: tabs, joint keys, the keys in title
/// bars [px]. 0 where they keep the size that they have for a mouse, which is everywhere but in Touch, and there
/// too in a window that has no room for more.
int touchHeight();
/// Whether the window has room for that; true until told otherwise. Lays the application out anew when it changes
/// in Touch.
/// Threads  GUI
void setRoomForTouch(QApplication& application, bool room);
/// A window of this height has it [px].
inline constexpr int kRoomForTouch = 980;

/// Gives the table's rows the height of the density, now and whenever it changes.
void followDensity(QTableView& table);

}  // namespace tiller
