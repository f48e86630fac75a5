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

}  // namespace tiller::app
