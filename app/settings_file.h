// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The settings as one JSON file with a format version, for transfer and backup. This module validates only
// the structure: plausible sizes of keys and values, and supported types. The code that uses a value
// validates it.

#include <QByteArray>
#include <QMap>
#include <QSet>
#include <QString>
#include <QVariant>

#include "robot/core/result.h"

namespace tiller::app {

/// A part of the settings. An import replaces a part completely or not at all.
enum class SettingsPart { Look, Motion, Keys, Devices, Robots, IoNames, Layout, Other };
inline constexpr SettingsPart kSettingsParts[] = {
    SettingsPart::Look,   SettingsPart::Motion,  SettingsPart::Keys,   SettingsPart::Devices,
    SettingsPart::Robots, SettingsPart::IoNames, SettingsPart::Layout, SettingsPart::Other};

/// key  key in QSettings, e.g. "look/density"
SettingsPart partOf(const QString& key);
/// False for values that apply only to this computer: recent files, window position, and the lock of a
/// monitor-only PC.
bool travels(const QString& key);

struct SettingsBundle {
    QString writtenBy;  ///< version of Tiller that wrote the file; may be empty
    /// Values by QSettings key: texts, numbers, booleans, byte arrays and lists of texts.
    QMap<QString, QVariant> values;

    QMap<QString, QVariant> part(SettingsPart which) const;
    /// True if both have equal values in this part. A number stored as text is equal to the same number.
    bool hasSameValues(const SettingsBundle& other, SettingsPart which) const;
};

inline constexpr int kSettingsFormatVersion = 1;

/// Returns the content of the file. Omits values of unsupported types.
QByteArray settingsToJson(const SettingsBundle& bundle);
/// Errors  FileCorrupt with a complete sentence for users; VersionUnsupported for a file from a newer version
/// of Tiller
Result<SettingsBundle> settingsFromJson(const QByteArray& bytes);

/// Errors  FileNotWritable, DiskFull
Result<void> writeSettingsFile(const QString& path, const SettingsBundle& bundle);
/// Errors  FileNotReadable, and those of settingsFromJson()
Result<SettingsBundle> readSettingsFile(const QString& path);

}  // namespace tiller::app
