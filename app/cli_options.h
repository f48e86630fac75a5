// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCommandLineParser>
#include <optional>
#include <string>
#include <vector>

namespace tiller::app {

/// Returns the number. If the text is not a number in the range, prints an error and returns an empty
/// optional.
std::optional<double> numberIn(const QCommandLineParser& parser, const QCommandLineOption& option,
                               double least, double most);

/// Splits "A,B, C" into names.
std::vector<std::string> namesIn(const QString& list);

/// True if the text can be an address or a host name: letters, digits and ".-_:%", at most 255 characters,
/// and no command line option. Text derived from it, such as a file name, is then safe.
bool isHostName(const QString& text);

}  // namespace tiller::app
