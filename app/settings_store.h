// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The settings file, in the INI format of QSettings. QSettings itself writes through QSaveFile, which on a full disk
// replaces the settings by an empty file and reports success, and it cannot read, change and write in one step, so that
// two windows lose each other's entries. Here an edit reads the newest file, changes it and replaces it as a whole while
// no other window writes.

#include <QMap>
#include <QString>
#include <QStringList>
#include <QVariant>
#include <memory>

#include "robot/core/result.h"
#include "robot/core/save_guard.h"

namespace tiller::app {

/// Keys are paths, "look/theme"; the list "robots" has the keys "robots/size", "robots/1/host" and so on.
using SettingsMap = QMap<QString, QVariant>;

/// The INI text of QSettings. Values it has no text for are left out.
QByteArray settingsToIni(const SettingsMap& values);
/// Lines that make no sense are skipped.
SettingsMap settingsFromIni(const QByteArray& text);

/// file  an .ini file; empty: the file of the user's settings
QString settingsPath(const QString& file);

/// The settings as they were when this object was made.
class SettingsView {
public:
    /// file  as settingsPath() has it
    explicit SettingsView(const QString& file);

    QVariant value(const QString& key, const QVariant& fallback = {}) const;
    bool contains(const QString& key) const;
    /// The keys directly in this group, without their group.
    QStringList childKeys(const QString& group) const;
    /// Those of the system's settings, which apply where the user has none, are not among them.
    const SettingsMap& values() const { return values_; }

protected:
    Error readError_;  ///< code None when the file was read, or does not exist
    SettingsMap values_;

private:
    SettingsMap fallbacks_;
};

/// Settings that are being changed. No other window writes meanwhile: make it short.
class SettingsEdit : public SettingsView {
public:
    explicit SettingsEdit(const QString& file);

    void setValue(const QString& key, const QVariant& value);
    /// And the keys below it.
    void remove(const QString& key);
    /// Changes in the group what differs between two states of it; what other windows changed stays.
    /// before, after  without the group in their keys
    void merge(const QString& group, const SettingsMap& before, const SettingsMap& after);
    /// Writes the file; does nothing when nothing was changed.
    /// Errors   FileNotWritable, DiskFull; the file is then as it was
    Result<void> commit();

private:
    SettingsEdit(const QString& file, Result<std::unique_ptr<SaveGuard>> guard);

    QString path_;
    Result<std::unique_ptr<SaveGuard>> guard_;
    SettingsMap before_;
};

}  // namespace tiller::app
