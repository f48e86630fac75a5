// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The table of the values on the settings page. It defines how the settings file is read, validated and
// written, which fields the page creates, and which values the manual lists.

#include <QString>
#include <QVariant>
#include <functional>
#include <vector>

#include "app/preferences.h"

namespace tiller::app {

struct PreferenceRow {
    enum class Editor {
        Custom,  ///< the page contains specific code for this value
        Choice,  ///< a list with `titles`
        Number,  ///< an integer from `min` to `max`
        Flag,    ///< a check box
    };

    QString key;         ///< key in the settings file
    const char* manual;  ///< text in the settings list of the manual
    Editor editor = Editor::Custom;
    bool isLocal = false;                 ///< true if the value is not transferred to another computer
    std::vector<const char*> words = {};  ///< names of the choices in the settings file
    int min = 0;
    int max = 0;
    int step = 1;

    // Texts in the translation context of SettingsPage. Not used by Editor::Custom.
    const char* label = "";                ///< in front of the field
    const char* name = "";                 ///< accessible name, or text of the check box
    std::vector<const char*> titles = {};  ///< displayed names of the choices
    const char* unit = "";
    const char* toolTip = "";
    const char* note = "";  ///< below the field
    int noteNumber = 0;     ///< replaces %1 in the note

    /// The value in the format of the settings file.
    std::function<QVariant(const Preferences&)> value = {};
    /// Replaces an invalid value by a valid value.
    std::function<void(Preferences&, const QVariant&)> setValue = {};
};

/// All values in the order of the page, except those of devices and shortcuts.
const std::vector<PreferenceRow>& preferenceRows();

}  // namespace tiller::app
