// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/preferences.h"

#include "app/interface_size.h"
#include "app/preference_table.h"
#include "app/settings_store.h"

namespace tiller::app {
namespace {

/// Returns the current ID of a renamed command, so that the command keeps the shortcut of the user.
QString currentName(const QString& id) {
    return id == QLatin1String("waypoint.action.open")     ? QStringLiteral("project.open")
           : id == QLatin1String("waypoint.action.saveAs") ? QStringLiteral("project.saveAs")
                                                           : id;
}

}  // namespace

bool stopsTheArm(const QKeySequence& keys) {
    // Reject shortcuts that contain a stop key with any modifier, because they would disable the stop key.
    for (int i = 0; i < keys.count(); ++i) {
        const Qt::Key key = keys[static_cast<uint>(i)].key();
        if (key == Qt::Key_Space || key == Qt::Key_Escape) {
            return true;
        }
    }
    return false;
}

int readInterfaceSize(const QString& file) {
    return saneInterfaceSize(SettingsView(file).value("look/size", kInterfaceSizes.front()).toInt());
}

Preferences readPreferences(const SettingsView& settings) {
    Preferences preferences;
    for (const PreferenceRow& row : preferenceRows()) {
        if (settings.contains(row.key)) {
            row.setValue(preferences, settings.value(row.key));
        }
    }
    preferences.recording = preferences.recording.sane();
    for (const auto& [kind, first] :
         {std::pair{kGamepadKind, kGamepadTuning}, {kSpaceMouseKind, kSpaceMouseTuning}}) {
        const QString group = "devices/" + kind;
        if (!settings.childKeys(group).isEmpty()) {
            const DeviceTuning read{settings.value(group + "/deadZone", first.deadZone).toDouble(),
                                    settings.value(group + "/exponent", first.exponent).toDouble(),
                                    settings.value(group + "/dominantAxis", first.dominantAxis).toBool()};
            preferences.devices[kind] = read.sane();
        }
    }
    const QStringList ids = settings.childKeys("shortcuts");
    for (const QString& id : ids) {
        const QKeySequence keys = QKeySequence::fromString(settings.value("shortcuts/" + id).toString(),
                                                           QKeySequence::PortableText);
        if (!stopsTheArm(keys)) {
            preferences.shortcuts[currentName(id)] = keys;
        }
    }
    return preferences;
}

SettingsMap preferenceValues(const Preferences& preferences) {
    SettingsMap values;
    for (const PreferenceRow& row : preferenceRows()) {
        values.insert(row.key, row.value(preferences));
    }
    for (auto it = preferences.devices.constBegin(); it != preferences.devices.constEnd(); ++it) {
        const QString group = "devices/" + it.key();
        values.insert(group + "/deadZone", it->deadZone);
        values.insert(group + "/exponent", it->exponent);
        values.insert(group + "/dominantAxis", it->dominantAxis);
    }
    for (auto it = preferences.shortcuts.constBegin(); it != preferences.shortcuts.constEnd(); ++it) {
        values.insert("shortcuts/" + it.key(), it->toString(QKeySequence::PortableText));
    }
    return values;
}

}  // namespace tiller::app
