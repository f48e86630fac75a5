// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <string>
#include <vector>

#include "app/cli_command.h"

namespace tiller::app {

/// Range of --port-offset.
inline constexpr NumberRange kPortOffsets{-29000, 35000, true};

/// Splits a list such as "A,B, C".
std::vector<std::string> namesIn(const QString& list);

/// True if the text can be an address or a host name: letters, digits and ".-_:%", at most 255 characters,
/// and not an option. Such a text is safe to use, e.g. in a file name.
bool isHostName(const QString& text);

}  // namespace tiller::app
