// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli_options.h"

#include <QStringList>
#include <algorithm>
#include <array>
#include <string_view>

#include "robot/recording/formats/file_formats.h"

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

std::vector<CommandOption> withTableOptions(std::vector<CommandOption> options) {
    const std::vector<CommandOption> table = {
        {"time-column", "NAME",
         "time column of a table that Tiller did not write; none: the table has no time column, see "
         "--table-rate"},
        {"time-unit", "UNIT", "unit of the time column: s, ms, us or ns"},
        {"table-rate", "HZ", "rows per second of a table without a time column", "", {1e-6, 1e9}},
        {"table-separator", "CHAR", "column separator of the table: , ; | tab or space"},
        {"table-decimal", "CHAR", "decimal separator of the table: . or ,"},
        {"no-header", "",
         "the first row of the table is data, and its columns are named column 1, column 2, ..."}};
    for (const CommandOption& option : table) {
        options.push_back(option);
    }
    return options;
}

CommandOperand recordingOperand(const QString& name) {
    return {name, QStringLiteral("recording (%1); the format is detected from the content")
                      .arg(recording::suffixWords(recording::FormatSet::All))};
}

namespace {

/// Returns the character that the option names; '\0' if it is not one of the allowed characters.
char characterOf(const QString& text, const char* allowed) {
    const char found = text == QLatin1String("tab") || text == QLatin1String("\\t") ? '\t'
                       : text == QLatin1String("space")                             ? ' '
                       : text.size() == 1                                           ? text.at(0).toLatin1()
                                                                                    : '\0';
    return std::string_view(allowed).find(found) == std::string_view::npos ? '\0' : found;
}

}  // namespace

Result<recording::TableFormat> tableFormatOf(const CommandArguments& arguments) {
    using recording::TimeUnit;
    recording::TableFormat format;
    const auto wrong = [&arguments](const char* option, const char* values) {
        return Error{ErrorCode::InvalidArgument,
                     QStringLiteral("--%1 must be %2, not '%3'")
                         .arg(QLatin1String(option), QLatin1String(values), arguments.value(option)),
                     {}};
    };
    if (arguments.isSet("time-column")) {
        const QString name = arguments.value("time-column");
        format.timeColumn = name == QLatin1String("none") ? std::string() : name.toStdString();
    }
    if (arguments.isSet("time-unit")) {
        const qsizetype unit = QStringList{"s", "ms", "us", "ns"}.indexOf(arguments.value("time-unit"));
        if (unit < 0) {
            return wrong("time-unit", "s, ms, us or ns");
        }
        format.timeUnit = std::array{TimeUnit::Seconds, TimeUnit::Milliseconds, TimeUnit::Microseconds,
                                     TimeUnit::Nanoseconds}[static_cast<std::size_t>(unit)];
    }
    if (arguments.isSet("table-separator")) {
        format.separator = characterOf(arguments.value("table-separator"), ",;|\t ");
        if (*format.separator == '\0') {
            return wrong("table-separator", "a comma, ;, |, tab or space");
        }
    }
    if (arguments.isSet("table-decimal")) {
        format.decimal = characterOf(arguments.value("table-decimal"), ".,");
        if (*format.decimal == '\0') {
            return wrong("table-decimal", "a point or a comma");
        }
    }
    if (arguments.isSet("no-header")) {
        format.hasHeader = false;
    }
    format.rate = arguments.number("table-rate");
    return format;
}

ExitCode exitCodeOf(const Error& error) {
    return error.code == ErrorCode::InvalidArgument ? kWrongArguments : kFailed;
}

}  // namespace tiller::app
