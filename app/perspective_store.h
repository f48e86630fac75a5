// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// How the settings keep the perspectives the operator saved, and how the panels stood when the window was
// closed. Every layout carries a checksum: what Qt reads layouts with crashes on some that are damaged.

#include <QByteArray>
#include <QString>
#include <QVector>

#include "app/settings_store.h"

namespace tiller::app {

/// Characters of a name, and how many perspectives of one's own there can be.
constexpr int kLongestPerspectiveName = 40;
constexpr int kMostPerspectives = 30;

/// A perspective the operator saved.
struct SavedPerspective {
    int number = 0;  ///< stays when the name changes; from 1
    QString name;
    QString tab;        ///< that is in front, by name; empty: whichever was
    QByteArray panels;  ///< DockStage::state(); empty when the file has it damaged

    bool operator==(const SavedPerspective&) const = default;
};

/// How the panels stood last.
struct LastArrangement {
    enum class Found { Nothing, Usable, Older, Damaged };
    Found found = Found::Nothing;
    QString perspective;   ///< id of the one chosen last
    bool changed = false;  ///< and changed since
    QByteArray panels;     ///< DockStage::state()
    int jogWidth = 0;      ///< [px], 0: not known
};

QVector<SavedPerspective> readPerspectives(const SettingsView& settings);
void writePerspectives(SettingsEdit& settings, const QVector<SavedPerspective>& perspectives);
/// Applies what this window has changed since it read `before` to what the settings hold now, so that windows keep each
/// other's perspectives. Two new ones of the same number or name both stay, the later one renamed.
QVector<SavedPerspective> mergePerspectives(const QVector<SavedPerspective>& before,
                                            const QVector<SavedPerspective>& ours,
                                            QVector<SavedPerspective> there);

LastArrangement readArrangement(const SettingsView& settings);
/// The member `found` is of no account.
void writeArrangement(SettingsEdit& settings, const LastArrangement& arrangement);

}  // namespace tiller::app
