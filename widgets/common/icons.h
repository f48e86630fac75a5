// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The application's icons: one-colour SVG drawings of our own in resources/icons, tinted to the theme.

#include <QColor>
#include <QIcon>
#include <QString>

namespace tiller {

/// name  of the file without ".svg": "play", "pause", "record"
/// ink   colour of the lines
/// Returns  a null icon for a name that does not exist
QIcon themedIcon(const QString& name, const QColor& ink);
/// In the text colour of the current theme, with a disabled variant. Ask again after a theme change.
QIcon themedIcon(const QString& name);
/// The application's own icon, in its own colours.
QIcon applicationIcon();

}  // namespace tiller
