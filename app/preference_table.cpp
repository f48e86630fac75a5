// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/preference_table.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "app/interface_size.h"

namespace tiller::app {
namespace {

using Editor = PreferenceRow::Editor;

/// A row for an enumeration whose values are the indices of the words. An unknown word is replaced by the
/// first word.
template <class Access>
PreferenceRow choiceRow(PreferenceRow row, Access access) {
    row.editor = Editor::Choice;
    row.value = [words = row.words, access](const Preferences& preferences) {
        return QVariant(QString::fromLatin1(words[static_cast<std::size_t>(access(preferences))]));
    };
    row.setValue = [words = row.words, access](Preferences& preferences, const QVariant& value) {
        const auto found = std::find(words.begin(), words.end(), value.toString());
        auto& field = access(preferences);
        field = static_cast<std::remove_reference_t<decltype(field)>>(
            found == words.end() ? 0 : found - words.begin());
    };
    return row;
}

/// Creates a row for a value that QVariant converts. readPreferences() validates the values for recordings
/// together.
template <class Access>
PreferenceRow plainRow(PreferenceRow row, Access access) {
    row.value = [access](const Preferences& preferences) { return QVariant(access(preferences)); };
    row.setValue = [access](Preferences& preferences, const QVariant& value) {
        auto& field = access(preferences);
        field = value.value<std::remove_reference_t<decltype(field)>>();
    };
    return row;
}

PreferenceRow languageRow() {
    return plainRow(
        {.key = "look/language", .manual = "language"},
        [](auto& preferences) -> auto& { return preferences.language; });
}

PreferenceRow sizeRow() {
    PreferenceRow row{.key = "look/size", .manual = "interface size"};
    row.value = [](const Preferences& preferences) { return QVariant(preferences.interfaceSize); };
    row.setValue = [](Preferences& preferences, const QVariant& value) {
        preferences.interfaceSize = saneInterfaceSize(value.toInt());
    };
    return row;
}

PreferenceRow densityRow() {
    return choiceRow(
        {.key = "look/density",
         .manual = "size of controls",
         .words = {"compact", "mouse", "touch"},
         .label = QT_TRANSLATE_NOOP("tiller::app::SettingsPage", "Control size"),
         .name = QT_TRANSLATE_NOOP("tiller::app::SettingsPage", "Control size"),
         .titles = {QT_TRANSLATE_NOOP("tiller::app::SettingsPage", "Compact"),
                    QT_TRANSLATE_NOOP("tiller::app::SettingsPage", "Mouse"),
                    QT_TRANSLATE_NOOP("tiller::app::SettingsPage", "Touch")},
         .note = QT_TRANSLATE_NOOP(
             "tiller::app::SettingsPage",
             "Touch: large enough for fingers. In windows less than %1 px high, joint buttons, tabs "
             "and title bars remain smaller."),
         .noteNumber = kRoomForTouch},
        [](auto& preferences) -> auto& { return preferences.density; });
}

PreferenceRow lengthsRow() {
    return choiceRow(
        {.key = "look/lengths",
         .manual = "length unit",
         .words = {"mm", "inch"},
         .label = QT_TRANSLATE_NOOP("tiller::app::SettingsPage", "Length unit"),
         .name = QT_TRANSLATE_NOOP("tiller::app::SettingsPage", "Length unit"),
         .titles = {QT_TRANSLATE_NOOP("tiller::app::SettingsPage", "Millimetres"),
                    QT_TRANSLATE_NOOP("tiller::app::SettingsPage", "Inches")}},
        [](auto& preferences) -> auto& { return preferences.notation.length; });
}

PreferenceRow rotationsRow() {
    return choiceRow(
        {.key = "look/rotations",
         .manual = "orientation format",
         .words = {"rpy", "vector"},
         .label = QT_TRANSLATE_NOOP("tiller::app::SettingsPage", "Orientation format"),
         .name = QT_TRANSLATE_NOOP("tiller::app::SettingsPage", "Orientation format"),
         .titles = {QT_TRANSLATE_NOOP("tiller::app::SettingsPage", "Roll, pitch, yaw in degrees"),
                    QT_TRANSLATE_NOOP("tiller::app::SettingsPage",
                                      "Rotation vector in radians, as in scripts")},
         .note = QT_TRANSLATE_NOOP("tiller::app::SettingsPage",
                                   "Units for displaying and entering lengths, TCP speeds and orientations. "
                                   "The units in plots and files do not change.")},
        [](auto& preferences) -> auto& { return preferences.notation.rotation; });
}

PreferenceRow monitorOnlyRow() {
    return plainRow(
        {.key = "motion/monitorOnly",
         .manual = "monitor only",
         .editor = Editor::Flag,
         .isLocal = true,
         .label = QT_TRANSLATE_NOOP("tiller::app::SettingsPage", "Robot"),
         .name = QT_TRANSLATE_NOOP("tiller::app::SettingsPage", "Monitor only"),
         .note =
             QT_TRANSLATE_NOOP("tiller::app::SettingsPage",
                               "For PCs that only monitor: this window does not take control, set outputs or "
                               "start programs. STOP still works.")},
        [](auto& preferences) -> auto& { return preferences.monitorOnly; });
}

PreferenceRow speedCapRow() {
    PreferenceRow row{.key = "motion/speedCap", .manual = "speed cap"};
    // Limit the saved value. Only the settings page can raise the speed cap, and only until the application
    // ends.
    row.value = [](const Preferences& preferences) {
        return QVariant(std::min(preferences.speedCap, Preferences::kOrdinaryCap));
    };
    row.setValue = [](Preferences& preferences, const QVariant& value) {
        const double cap = value.toDouble();
        if (std::isfinite(cap) && cap > 0) {
            preferences.speedCap = std::clamp(cap, Preferences::kLowestCap, Preferences::kOrdinaryCap);
        }
    };
    return row;
}

PreferenceRow longestHoldRow() {
    PreferenceRow row{
        .key = "motion/longestHold",
        .manual = "maximum hold time",
        .editor = Editor::Number,
        .min = Preferences::kShortestLongestHold,
        .max = Preferences::kMaxHoldLimit,
        .step = 5,
        .label = QT_TRANSLATE_NOOP("tiller::app::SettingsPage", "Maximum hold time"),
        .name = QT_TRANSLATE_NOOP("tiller::app::SettingsPage", "Maximum hold time"),
        .unit = QT_TRANSLATE_NOOP("tiller::app::SettingsPage", " s"),
        .toolTip = QT_TRANSLATE_NOOP(
            "tiller::app::SettingsPage",
            "After this time, a jog stops and its button must be pressed again. Freedrive has a limit of "
            "five minutes. A move to a position has a limit of its duration plus 5 s.")};
    row.value = [](const Preferences& preferences) { return QVariant(preferences.longestHold); };
    row.setValue = [min = row.min, max = row.max](Preferences& preferences, const QVariant& value) {
        bool isNumber = false;
        const int hold = value.toInt(&isNumber);
        if (isNumber) {
            preferences.longestHold = std::clamp(hold, min, max);
        }
    };
    return row;
}

template <class Access>
PreferenceRow recordingRow(const QString& key, const char* manual, Access access) {
    return plainRow(
        {.key = "recording/" + key, .manual = manual}, [access](auto& preferences) -> auto& {
            return access(preferences.recording);
        });
}

}  // namespace

const std::vector<PreferenceRow>& preferenceRows() {
    static const std::vector<PreferenceRow> kRows = {
        languageRow(),
        sizeRow(),
        densityRow(),
        lengthsRow(),
        rotationsRow(),
        monitorOnlyRow(),
        speedCapRow(),
        longestHoldRow(),
        recordingRow(
            "folder", "folder", [](auto& recording) -> auto& { return recording.folder; }),
        recordingRow(
            "pattern", "file name pattern", [](auto& recording) -> auto& { return recording.pattern; }),
        recordingRow(
            "fields", "signals", [](auto& recording) -> auto& { return recording.fields; }),
        recordingRow(
            "every", "packets per row", [](auto& recording) -> auto& { return recording.every; }),
        recordingRow(
            "format", "format", [](auto& recording) -> auto& { return recording.format; }),
        recordingRow(
            "keepFree", "disk space to keep free",
            [](auto& recording) -> auto& { return recording.keepFree; }),
        recordingRow(
            "metadata", "metadata", [](auto& recording) -> auto& { return recording.metadata; }),
        recordingRow(
            "asksMetadata", "metadata before each recording",
            [](auto& recording) -> auto& { return recording.asksMetadata; }),
        recordingRow(
            "trigger", "trigger", [](auto& recording) -> auto& { return recording.trigger; }),
        recordingRow(
            "before", "time before", [](auto& recording) -> auto& { return recording.before; }),
        recordingRow(
            "after", "after the trigger", [](auto& recording) -> auto& { return recording.after; }),
        recordingRow(
            "fileMinutes", "duration", [](auto& recording) -> auto& { return recording.fileMinutes; }),
        recordingRow(
            "fileSize", "size of a file", [](auto& recording) -> auto& { return recording.fileSize; }),
    };
    return kRows;
}

}  // namespace tiller::app
