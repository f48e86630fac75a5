// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli_options.h"

#include <QStringList>
#include <algorithm>

namespace tiller::app {

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
