// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Stores the user's perspectives and the last arrangement of the panels in the settings. Every layout has a
// checksum, because Qt can crash when it restores damaged layouts.

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
    int number = 0;  ///< 1 or higher; renaming does not change it
    QString name;
    QString tab;        ///< name of the current tab; if empty, the tab does not change
    QByteArray panels;  ///< result of DockStage::state(); empty if damaged in the file

    bool operator==(const SavedPerspective&) const = default;
};

/// The last arrangement of the panels.
struct LastArrangement {
    enum class Found { Nothing, Usable, Older, Damaged };
    Found found = Found::Nothing;
    QString perspective;   ///< ID of the last selected perspective
    bool changed = false;  ///< true if the user changed the arrangement afterwards
    QByteArray panels;     ///< result of DockStage::state()
    int jogWidth = 0;      ///< [px], 0: unknown
};

QVector<SavedPerspective> readPerspectives(const SettingsView& settings);
void writePerspectives(SettingsEdit& settings, const QVector<SavedPerspective>& perspectives);
/// Applies the changes that this window has made since reading `before` to the current settings `there`, so
/// that the perspectives of other windows are kept. If two new perspectives have the same number or name,
/// both are kept and the later one is renamed.
QVector<SavedPerspective> mergePerspectives(const QVector<SavedPerspective>& before,
                                            const QVector<SavedPerspective>& ours,
                                            QVector<SavedPerspective> there);

LastArrangement readArrangement(const SettingsView& settings);
/// Ignores the member `found`.
void writeArrangement(SettingsEdit& settings, const LastArrangement& arrangement);

}  // namespace tiller::app
