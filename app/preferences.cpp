// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/preferences.h"

#include <algorithm>
#include <cmath>

#include <QSettings>

#include "app/interface_size.h"
#include "app/settings.h"

namespace tiller::app {
namespace {

/// The index of the word in the list; the first one where it is none of them.
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

/// Commands that had another name in earlier versions keep the key chosen for them.
QString currentName(const QString& id) {
    return id == QLatin1String("waypoint.action.open")     ? QStringLiteral("project.open")
           : id == QLatin1String("waypoint.action.saveAs") ? QStringLiteral("project.saveAs")
                                                           : id;
}

}  // namespace

bool stopsTheArm(const QKeySequence& keys) {
    // The stop keys stop with any modifier, and a shortcut that begins with them or ends in them would take
    // them away.
    for (int i = 0; i < keys.count(); ++i) {
        const Qt::Key key = keys[static_cast<uint>(i)].key();
        if (key == Qt::Key_Space || key == Qt::Key_Escape) {
            return true;
        }
    }
    return false;
}

int readInterfaceSize(const QString& file) {
    return saneInterfaceSize(openSettings(file).value("look/size", kInterfaceSizes.front()).toInt());
}

Preferences readPreferences(const QString& file) {
    Preferences preferences;
    QSettings settings = openSettings(file);
    preferences.language = settings.value("look/language").toString();
    const QString density = settings.value("look/density", kDensities[1]).toString();
    preferences.density = choiceOf<Density>(density, kDensities);
    preferences.interfaceSize = readInterfaceSize(file);
    preferences.notation.length = choiceOf<LengthUnit>(settings.value("look/lengths").toString(), kLengths);
    preferences.notation.rotation =
        choiceOf<RotationNotation>(settings.value("look/rotations").toString(), kRotations);
    const double cap = settings.value("motion/speedCap", Preferences::kOrdinaryCap).toDouble();
    if (std::isfinite(cap) && cap > 0) {
        // A file cannot raise it: only a hand on the settings page can.
        preferences.speedCap = std::clamp(cap, Preferences::kLowestCap, Preferences::kOrdinaryCap);
    }
    preferences.monitorOnly = settings.value("motion/monitorOnly", false).toBool();
    bool isNumber = false;
    const int hold = settings.value("motion/longestHold", Preferences::kUsualLongestHold).toInt(&isNumber);
    if (isNumber) {
        preferences.longestHold =
            std::clamp(hold, Preferences::kShortestLongestHold, Preferences::kLongestLongestHold);
    }
    for (const auto& [kind, first] :
         {std::pair{kGamepadKind, kGamepadTuning}, {kSpaceMouseKind, kSpaceMouseTuning}}) {
        settings.beginGroup("devices/" + kind);
        if (!settings.childKeys().isEmpty()) {
            const DeviceTuning read{settings.value("deadZone", first.deadZone).toDouble(),
                                    settings.value("exponent", first.exponent).toDouble(),
                                    settings.value("dominantAxis", first.dominantAxis).toBool()};
            preferences.devices[kind] = read.sane();
        }
        settings.endGroup();
    }
    RecordingChoice recording;
    recording.folder = settings.value("recording/folder").toString();
    recording.pattern = settings.value("recording/pattern", recording.pattern).toString();
    recording.fields = settings.value("recording/fields").toStringList();
    recording.every = settings.value("recording/every", recording.every).toInt();
    recording.format = formatByName(settings.value("recording/format").toString());
    recording.keepFree = settings.value("recording/keepFree", recording.keepFree).toInt();
    preferences.recording = recording.sane();
    settings.beginGroup("shortcuts");
    const QStringList ids = settings.childKeys();
    for (const QString& id : ids) {
        const QKeySequence keys =
            QKeySequence::fromString(settings.value(id).toString(), QKeySequence::PortableText);
        if (!stopsTheArm(keys)) {
            preferences.shortcuts[currentName(id)] = keys;
        }
    }
    return preferences;
}

void writePreferences(const QString& file, const Preferences& preferences) {
    QSettings settings = openSettings(file);
    settings.setValue("look/language", preferences.language);
    settings.setValue("look/density", kDensities[static_cast<int>(preferences.density)]);
    settings.setValue("look/size", preferences.interfaceSize);
    settings.setValue("look/lengths", kLengths[static_cast<int>(preferences.notation.length)]);
    settings.setValue("look/rotations", kRotations[static_cast<int>(preferences.notation.rotation)]);
    settings.setValue("motion/speedCap", std::min(preferences.speedCap, Preferences::kOrdinaryCap));
    settings.setValue("motion/monitorOnly", preferences.monitorOnly);
    settings.setValue("motion/longestHold", preferences.longestHold);
    for (auto it = preferences.devices.constBegin(); it != preferences.devices.constEnd(); ++it) {
        settings.beginGroup("devices/" + it.key());
        settings.setValue("deadZone", it->deadZone);
        settings.setValue("exponent", it->exponent);
        settings.setValue("dominantAxis", it->dominantAxis);
        settings.endGroup();
    }
    settings.setValue("recording/folder", preferences.recording.folder);
    settings.setValue("recording/pattern", preferences.recording.pattern);
    settings.setValue("recording/fields", preferences.recording.fields);
    settings.setValue("recording/every", preferences.recording.every);
    settings.setValue("recording/format", formatName(preferences.recording.format));
    settings.setValue("recording/keepFree", preferences.recording.keepFree);
    settings.remove("shortcuts");
    settings.beginGroup("shortcuts");
    for (auto it = preferences.shortcuts.constBegin(); it != preferences.shortcuts.constEnd(); ++it) {
        settings.setValue(it.key(), it->toString(QKeySequence::PortableText));
    }
}

}  // namespace tiller::app
