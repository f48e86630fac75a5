// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// How the settings keep the perspectives the operator saved, and how the panels stood when the window was
// closed. Every layout carries a checksum: what Qt reads layouts with crashes on some that are damaged.

#include <QByteArray>
#include <QString>
#include <QVector>

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

/// file  as for Settings
QVector<SavedPerspective> readPerspectives(const QString& file);
void writePerspectives(const QString& file, const QVector<SavedPerspective>& perspectives);

LastArrangement readArrangement(const QString& file);
/// The member `found` is of no account.
void writeArrangement(const QString& file, const LastArrangement& arrangement);

}  // namespace tiller::app
