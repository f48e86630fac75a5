// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCommandLineParser>
#include <optional>
#include <string>
#include <vector>

namespace tiller::app {

/// What is not a number within the range is complained about and gives nothing.
std::optional<double> numberIn(const QCommandLineParser& parser, const QCommandLineOption& option,
                               double least, double most);

/// "A,B, C" as its names.
std::vector<std::string> namesIn(const QString& list);

/// Whether the text can be an address or a host name: letters, digits and ".-_:%", at most 255 characters, no option.
/// Everything that is made from it, such as a file name, is then harmless.
bool isHostName(const QString& text);

}  // namespace tiller::app
