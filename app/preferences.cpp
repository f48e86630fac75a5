// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/preferences.h"

#include <algorithm>
#include <cmath>

#include "app/interface_size.h"
#include "app/settings_store.h"

namespace tiller::app {
namespace {

/// Returns the index of the word in the list; 0 if it is not in the list.
template <class Choice, std::size_t N>
Choice choiceOf(const QString& word, const char* const (&words)[N]) {
    for (std::size_t i = 0; i < N; ++i) {
        if (word == QLatin1String(words[i])) {
            return static_cast<Choice>(i);
        }
    }
    return {};
}

constexpr const char* kDensities[] = {"compact", "mouse", "touch"};
constexpr const char* kLengths[] = {"mm", "inch"};
constexpr const char* kRotations[] = {"rpy", "vector"};

/// Returns the current id of a command that was renamed, so that the command keeps the user's shortcut.
QString currentName(const QString& id) {
    return id == QLatin1String("waypoint.action.open")     ? QStringLiteral("project.open")
           : id == QLatin1String("waypoint.action.saveAs") ? QStringLiteral("project.saveAs")
                                                           : id;
}

}  // namespace

bool stopsTheArm(const QKeySequence& keys) {
    // The stop keys act with any modifier. A shortcut that contains a stop key would disable it.
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
    preferences.language = settings.value("look/language").toString();
    const QString density = settings.value("look/density", kDensities[1]).toString();
    preferences.density = choiceOf<Density>(density, kDensities);
    preferences.interfaceSize =
        saneInterfaceSize(settings.value("look/size", kInterfaceSizes.front()).toInt());
    preferences.notation.length = choiceOf<LengthUnit>(settings.value("look/lengths").toString(), kLengths);
    preferences.notation.rotation =
        choiceOf<RotationNotation>(settings.value("look/rotations").toString(), kRotations);
    const double cap = settings.value("motion/speedCap", Preferences::kOrdinaryCap).toDouble();
    if (std::isfinite(cap) && cap > 0) {
        // Only the settings page can raise the speed cap. A settings file cannot.
        preferences.speedCap = std::clamp(cap, Preferences::kLowestCap, Preferences::kOrdinaryCap);
    }
    preferences.monitorOnly = settings.value("motion/monitorOnly", false).toBool();
    bool isNumber = false;
    const int hold = settings.value("motion/longestHold", Preferences::kUsualLongestHold).toInt(&isNumber);
    if (isNumber) {
        preferences.longestHold =
            std::clamp(hold, Preferences::kShortestLongestHold, Preferences::kMaxHoldLimit);
    }
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
    RecordingChoice recording;
    recording.folder = settings.value("recording/folder").toString();
    recording.pattern = settings.value("recording/pattern", recording.pattern).toString();
    recording.fields = settings.value("recording/fields").toStringList();
    recording.every = settings.value("recording/every", recording.every).toInt();
    recording.format = settings.value("recording/format").toString();
    recording.keepFree = settings.value("recording/keepFree", recording.keepFree).toInt();
    preferences.recording = recording.sane();
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
    SettingsMap values{
        {"look/language", preferences.language},
        {"look/density", QLatin1String(kDensities[static_cast<int>(preferences.density)])},
        {"look/size", preferences.interfaceSize},
        {"look/lengths", QLatin1String(kLengths[static_cast<int>(preferences.notation.length)])},
        {"look/rotations", QLatin1String(kRotations[static_cast<int>(preferences.notation.rotation)])},
        {"motion/speedCap", std::min(preferences.speedCap, Preferences::kOrdinaryCap)},
        {"motion/monitorOnly", preferences.monitorOnly},
        {"motion/longestHold", preferences.longestHold},
        {"recording/folder", preferences.recording.folder},
        {"recording/pattern", preferences.recording.pattern},
        {"recording/fields", preferences.recording.fields},
        {"recording/every", preferences.recording.every},
        {"recording/format", preferences.recording.format},
        {"recording/keepFree", preferences.recording.keepFree}};
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
