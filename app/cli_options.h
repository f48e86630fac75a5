// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCommandLineParser>
#include <optional>
#include <string>
#include <vector>

namespace tiller::app {

/// Prints an error and returns nothing if the text is not a number within the range.
std::optional<double> numberIn(const QCommandLineParser& parser, const QCommandLineOption& option,
                               double least, double most);

/// Splits "A,B, C" into names.
std::vector<std::string> namesIn(const QString& list);

/// Whether the text can be an address or a host name: letters, digits and ".-_:%", at most 255 characters, not an
/// option. Text derived from it, such as a file name, is then safe.
bool isHostName(const QString& text);

}  // namespace tiller::app
