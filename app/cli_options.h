// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <string>
#include <vector>

#include "app/cli_command.h"

namespace tiller::app {

/// Values of --port-offset.
inline constexpr NumberRange kPortOffsets{-29000, 35000, true};

/// Splits "A,B, C" into names.
std::vector<std::string> namesIn(const QString& list);

/// True if the text can be an address or a host name: letters, digits and ".-_:%", at most 255 characters,
/// and no command line option. Text derived from it, such as a file name, is then safe.
bool isHostName(const QString& text);

}  // namespace tiller::app
