// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The settings as one file, for the next cell and as a copy to go back to: JSON with a version of its format.
// Whoever reads a value afterwards checks it as he checks one of the settings themselves; here it is made sure
// that there are keys and values at all, of a sane size and of kinds that settings have.

#include <QByteArray>
#include <QMap>
#include <QSet>
#include <QString>
#include <QVariant>

#include "robot/core/result.h"

namespace tiller::app {

/// What is replaced as a whole, or not at all.
enum class SettingsPart { Look, Motion, Keys, Devices, Robots, IoNames, Layout, Other };
inline constexpr SettingsPart kSettingsParts[] = {
    SettingsPart::Look,   SettingsPart::Motion,  SettingsPart::Keys,   SettingsPart::Devices,
    SettingsPart::Robots, SettingsPart::IoNames, SettingsPart::Layout, SettingsPart::Other};

/// key  as QSettings has it: "look/density"
SettingsPart partOf(const QString& key);
/// False for what means something on this computer only: the files worked in, the place of the window, the lock of a PC
/// that only monitors.
bool travels(const QString& key);

struct SettingsBundle {
    QString writtenBy;  ///< the version of Tiller; may be empty
    /// By the key of QSettings: texts, numbers, truth values, bytes and lists of texts.
    QMap<QString, QVariant> values;

    QMap<QString, QVariant> part(SettingsPart which) const;
    /// True when both say the same in this part, whether a number is written as a text or not.
    bool saysTheSame(const SettingsBundle& other, SettingsPart which) const;
};

inline constexpr int kSettingsFormatVersion = 1;

/// The file's content. Values of kinds that the format does not know are left out.
QByteArray settingsToJson(const SettingsBundle& bundle);
/// Errors  FileCorrupt with a whole sentence for people; VersionUnsupported for a file of a newer Tiller
Result<SettingsBundle> settingsFromJson(const QByteArray& bytes);

/// Errors  FileNotWritable, DiskFull
Result<void> writeSettingsFile(const QString& path, const SettingsBundle& bundle);
/// Errors  FileNotReadable, and those of settingsFromJson()
Result<SettingsBundle> readSettingsFile(const QString& path);

}  // namespace tiller::app
