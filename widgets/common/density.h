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

/// Gives the table's rows the height of the density, now and whenever it changes.
void followDensity(QTableView& table);

}  // namespace tiller
