// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The style sheet of the standard widgets. Custom widgets paint themselves (see theme.h).

#include <QString>

namespace tiller {

struct Theme;

/// Supported dynamic properties: QPushButton[primary="true"], QPushButton[danger="true"],
/// QToolButton[quiet="true"], QLabel[role="secondary"|"caption"|"strong"|"warning"|"alarm"].
QString styleSheet(const Theme& theme);

}  // namespace tiller
