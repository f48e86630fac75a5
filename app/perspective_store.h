// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Stores the user's perspectives and the last arrangement of the panels in the settings. Every layout has a
// checksum, because Qt can crash when reading damaged layouts.

#include <QByteArray>
#include <QString>
#include <QVector>

#include "app/settings_store.h"

namespace tiller::app {

/// Maximum length of a name, and maximum number of perspectives.
constexpr int kMaxPerspectiveName = 40;
constexpr int kMaxPerspectives = 30;

/// A perspective saved by the user.
struct SavedPerspective {
    int number = 0;  ///< 1 or higher; not changed by renaming
    QString name;
    QString tab;        ///< name of the tab in front; empty: unchanged
    QByteArray panels;  ///< result of DockStage::state(); empty if damaged in the file

    bool operator==(const SavedPerspective&) const = default;
};

/// The last arrangement of the panels.
struct LastArrangement {
    enum class Found { Nothing, Usable, Older, Damaged };
    Found found = Found::Nothing;
    QString perspective;   ///< id of the last selected perspective
    bool changed = false;  ///< true if changed since the perspective was selected
    QByteArray panels;     ///< result of DockStage::state()
    int jogWidth = 0;      ///< [px], 0: unknown
};

QVector<SavedPerspective> readPerspectives(const SettingsView& settings);
void writePerspectives(SettingsEdit& settings, const QVector<SavedPerspective>& perspectives);
/// Applies the changes of this window since it read `before` to the current settings, so that windows keep each
/// other's perspectives. New perspectives with the same number or name are both kept; the later one is renamed.
QVector<SavedPerspective> mergePerspectives(const QVector<SavedPerspective>& before,
                                            const QVector<SavedPerspective>& ours,
                                            QVector<SavedPerspective> there);

LastArrangement readArrangement(const SettingsView& settings);
/// The member `found` is ignored.
void writeArrangement(SettingsEdit& settings, const LastArrangement& arrangement);

}  // namespace tiller::app
