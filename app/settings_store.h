// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The settings file in the INI format of QSettings. QSettings itself is not used for writing: on a full disk,
// it replaces the settings by an empty file and reports success, because it writes through QSaveFile. It also
// cannot read, change and write atomically, so that two windows would lose each other's entries. SettingsEdit
// reads the current file, changes it and replaces it atomically, while other windows cannot write.

#include <QMap>
#include <QString>
#include <QStringList>
#include <QVariant>
#include <memory>

#include "robot/core/result.h"
#include "robot/core/save_guard.h"

namespace tiller::app {

/// Keys are paths, e.g. "look/theme". The list "robots" has the keys "robots/size", "robots/1/host" and so
/// on.
using SettingsMap = QMap<QString, QVariant>;

/// Returns the settings in the INI format of QSettings. Values without a text format are omitted.
QByteArray settingsToIni(const SettingsMap& values);
/// Reads the INI format of QSettings. Invalid lines are skipped.
SettingsMap settingsFromIni(const QByteArray& text);

/// file  path of an .ini file; if empty, the user's settings file
QString settingsPath(const QString& file);

/// The settings at the time of construction.
class SettingsView {
public:
    /// file  as in settingsPath()
    explicit SettingsView(const QString& file);

    QVariant value(const QString& key, const QVariant& fallback = {}) const;
    bool contains(const QString& key) const;
    /// Returns the keys directly in this group, without the group name.
    QStringList childKeys(const QString& group) const;
    /// All values of the file. Does not include system-wide settings, which apply if the user has no value.
    const SettingsMap& values() const { return values_; }

protected:
    Error readError_;  ///< ErrorCode::None if the file was read or does not exist
    SettingsMap values_;

private:
    SettingsMap fallbacks_;
};

/// An edit of the settings. During the lifetime of the object, other windows cannot write, so keep it short.
class SettingsEdit : public SettingsView {
public:
    explicit SettingsEdit(const QString& file);

    void setValue(const QString& key, const QVariant& value);
    /// Removes a key and all keys in the group of this name.
    void remove(const QString& key);
    /// Applies the difference between two states of a group, and keeps the changes of other windows.
    /// before, after  keys without the group
    void merge(const QString& group, const SettingsMap& before, const SettingsMap& after);
    /// Writes the file if there are changes.
    /// Errors   FileNotWritable, DiskFull; the file then remains unchanged
    Result<void> commit();

private:
    SettingsEdit(const QString& file, Result<std::unique_ptr<SaveGuard>> guard);

    QString path_;
    Result<std::unique_ptr<SaveGuard>> guard_;
    SettingsMap before_;
};

}  // namespace tiller::app
