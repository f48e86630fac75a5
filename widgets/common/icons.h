// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The icons of the application: monochrome SVG files in resources/icons, drawn in a colour of the theme.

#include <QColor>
#include <QIcon>
#include <QString>

namespace tiller {

/// name  file name without ".svg": "play", "pause", "record"
/// ink   colour of the lines
/// Returns  a null icon for an unknown name
QIcon themedIcon(const QString& name, const QColor& ink);
/// Icon in the text colour of the current theme, with a disabled variant. After a change of theme, the icon
/// must be requested again.
QIcon themedIcon(const QString& name);
/// The application icon, in its original colours.
QIcon applicationIcon();

}  // namespace tiller
