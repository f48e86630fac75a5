// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli_options.h"

#include <algorithm>

#include "app/cli_command.h"

namespace tiller::app {

std::optional<double> numberIn(const QCommandLineParser& parser, const QCommandLineOption& option,
                               double least, double most) {
    bool ok = false;
    const double value = parser.value(option).toDouble(&ok);
    if (ok && value >= least && value <= most) {
        return value;
    }
    wrongArguments(QStringLiteral("--%1 must be a number from %2 to %3, not '%4'")
                       .arg(option.names().first())
                       .arg(least)
                       .arg(most)
                       .arg(parser.value(option)));
    return std::nullopt;
}

std::vector<std::string> namesIn(const QString& list) {
    std::vector<std::string> names;
    for (const QString& name : list.split(',', Qt::SkipEmptyParts)) {
        names.push_back(name.trimmed().toStdString());
    }
    return names;
}

bool isHostName(const QString& text) {
    constexpr qsizetype kMaxLength = 255;
    const auto isAllowed = [](QChar c) {
        // Letters and digits of all scripts, because names may be internationalized.
        return c.isLetterOrNumber() || QStringLiteral(".-_:%").contains(c);
    };
    return !text.isEmpty() && text.size() <= kMaxLength && !text.startsWith(QLatin1Char('-')) &&
           std::all_of(text.begin(), text.end(), isAllowed);
}

}  // namespace tiller::app
