// SPDX-License-Identifier: MIT
#include "robot/simulator/equipment/device_table.h"

#include <QStringList>
#include <algorithm>
#include <cmath>
#include <utility>

#include "robot/core/ascii.h"
#include "robot/core/file_reading.h"
#include "robot/simulator/urscript/constants.h"

namespace tiller::simulator {

namespace {

constexpr qint64 kMaxTable = 1 << 20;     ///< [bytes]
constexpr double kMaxDeviceDelay = 3600;  ///< [s]

Error corrupt(const QString& why) {
    return {ErrorCode::FileCorrupt, why, {}};
}

/// Splits the text at separators, except within quotes or brackets or after a backslash.
QStringList splitOutside(const QString& text, QChar separator) {
    QStringList parts{QString()};
    bool isQuoted = false;
    int depth = 0;
    for (qsizetype i = 0; i < text.size(); ++i) {
        const QChar c = text[i];
        if (c == QLatin1Char('\\') && i + 1 < text.size()) {
            parts.back() += c;
            parts.back() += text[++i];
            continue;
        }
        if (c == separator && !isQuoted && depth == 0) {
            parts.append(QString());
            continue;
        }
        isQuoted = isQuoted != (c == QLatin1Char('"'));
        depth += c == QLatin1Char('[') || c == QLatin1Char('(') ? 1 : 0;
        depth -= depth > 0 && (c == QLatin1Char(']') || c == QLatin1Char(')')) ? 1 : 0;
        parts.back() += c;
    }
    return parts;
}

/// Replaces \n, \r, \t, \| and \\ in the text. Appends a newline, unless the text ends with \c.
std::string lineOf(QString text) {
    const bool isWhole = !text.endsWith(QLatin1String("\\c"));
    if (!isWhole) {
        text.chop(2);
    }
    QString out;
    for (qsizetype i = 0; i < text.size(); ++i) {
        if (text[i] != QLatin1Char('\\') || i + 1 == text.size()) {
            out += text[i];
            continue;
        }
        const QChar c = text[++i];
        out += c == QLatin1Char('n')   ? QLatin1Char('\n')
               : c == QLatin1Char('r') ? QLatin1Char('\r')
               : c == QLatin1Char('t') ? QLatin1Char('\t')
                                       : c;
    }
    return out.toStdString() + (isWhole ? "\n" : "");
}

bool isSeparator(char c) {
    return c == ' ' || c == ',' || c == ';' || c == '=' || c == ':' || c == '\t';
}

/// Numbers are compared by value: 1 and 1.0 are the same argument.
bool isSame(const urscript::Value& wanted, const urscript::Value& given) {
    return wanted.isNumber() && given.isNumber() ? wanted.number() == given.number() : wanted.equals(given);
}

}  // namespace

Result<DeviceTable> DeviceTable::read(const QString& file) {
    const Result<QByteArray> content = readWholeFile(file, kMaxTable);
    if (!content) {
        return content.error();
    }
    return parse(file, QString::fromUtf8(*content));
}

Result<DeviceTable> DeviceTable::parse(const QString& shown, const QString& text) {
    DeviceTable table;
    bool hasProtocol = false;
    const QStringList lines = text.split('\n');
    for (qsizetype i = 0; i < lines.size(); ++i) {
        const QString line = lines[i].trimmed();
        const QString word = line.section(' ', 0, 0), rest = line.section(' ', 1).trimmed();
        Result<void> outcome;
        if (line.isEmpty() || line.startsWith('#')) {
            continue;
        }
        if (word == QLatin1String("protocol") && !line.contains('|')) {
            hasProtocol = rest == QLatin1String("xml-rpc") || rest == QLatin1String("lines");
            table.protocol_ = rest == QLatin1String("lines") ? Protocol::Lines : Protocol::XmlRpc;
            if (!hasProtocol) {
                outcome =
                    corrupt(QStringLiteral("the protocol must be xml-rpc or lines, not '%1'").arg(rest));
            }
        } else if (word == QLatin1String("address") && !line.contains('|')) {
            table.host_ = rest.section(':', 0, -2).trimmed();
            table.port_ = rest.section(':', -1).toInt();
            if (table.host_.isEmpty() || table.port_ <= 0 || table.port_ > 65535) {
                outcome = corrupt(
                    QStringLiteral("the address must have the form 192.168.1.20:4242, not '%1'").arg(rest));
            }
        } else if (!hasProtocol) {
            outcome =
                corrupt(QStringLiteral("'protocol xml-rpc' or 'protocol lines' must come before the rows"));
        } else {
            outcome = table.addRow(line);
        }
        if (!outcome) {
            return corrupt(
                QStringLiteral("%1, line %2: %3").arg(shown).arg(i + 1).arg(outcome.error().context));
        }
    }
    if (table.port_ == 0) {
        return corrupt(QStringLiteral("%1: the address is missing").arg(shown));
    }
    return table;
}

Result<void> DeviceTable::addRow(const QString& line) {
    const QStringList cells = splitOutside(line, '|');
    if (cells.size() < 3 || cells.size() > 4) {
        return corrupt(QStringLiteral(
            "a row must have the form NAME | ARGUMENTS | ANSWER | DELAY; the delay is optional"));
    }
    Row row;
    row.name = cells[0].trimmed().toStdString();
    row.argumentText = cells[1].trimmed().toStdString();
    row.anyArguments = row.argumentText == "*";
    const QString answer = cells[2].trimmed();
    if (row.name.empty()) {
        return corrupt(QStringLiteral("the name is missing"));
    }
    if (cells.size() == 4) {
        bool ok = false;
        row.answer.delay = cells[3].trimmed().toDouble(&ok);
        if (!ok || !(row.answer.delay >= 0 && row.answer.delay <= kMaxDeviceDelay)) {
            return corrupt(QStringLiteral("'%1' is not a delay in seconds").arg(cells[3].trimmed()));
        }
    }
    if (answer == QLatin1String("fault") || answer.startsWith(QLatin1String("fault "))) {
        row.answer.fault = answer.mid(6).trimmed().toStdString();
    } else if (protocol_ == Protocol::Lines) {
        row.answer.text = answer.isEmpty() ? std::string() : lineOf(answer);
    } else if (!answer.isEmpty()) {
        const Result<urscript::Value> value = urscript::constantValue(answer.toStdString());
        if (!value) {
            return corrupt(QStringLiteral("the answer '%1' is not a URScript value: %2")
                               .arg(answer, value.error().controllerMessage));
        }
        row.answer.value = *value;
    }
    if (protocol_ == Protocol::XmlRpc && !row.anyArguments) {
        if (Result<void> arguments = readArguments(row); !arguments) {
            return arguments;
        }
    }
    rows_.push_back(std::move(row));
    return {};
}

Result<void> DeviceTable::readArguments(Row& row) {
    const QString text = QString::fromStdString(row.argumentText);
    for (const QString& part : text.isEmpty() ? QStringList() : splitOutside(text, ',')) {
        const QString argument = part.trimmed();
        if (argument == QLatin1String("*")) {
            row.arguments.emplace_back();
            continue;
        }
        const Result<urscript::Value> value = urscript::constantValue(argument.toStdString());
        if (!value) {
            return corrupt(QStringLiteral("the argument '%1' is not a URScript value: %2")
                               .arg(argument, value.error().controllerMessage));
        }
        row.arguments.emplace_back(*value);
    }
    return {};
}

template <class Matches>
std::optional<DeviceAnswer> DeviceTable::next(Matches matches) {
    Row* found = nullptr;
    for (Row& row : rows_) {
        // Examine the first matching row, and later rows with the same name and arguments.
        const bool continues =
            found != nullptr && row.name == found->name && row.argumentText == found->argumentText;
        if (found != nullptr ? continues : matches(row)) {
            found = &row;
            if (!row.isUsed) {
                break;
            }
        }
    }
    if (found == nullptr) {
        return std::nullopt;
    }
    found->isUsed = true;
    return found->answer;
}

std::optional<DeviceAnswer> DeviceTable::answer(std::string_view method,
                                                std::span<const urscript::Value> arguments) {
    return next([&](const Row& row) {
        return row.name == method &&
               (row.anyArguments ||
                std::equal(row.arguments.begin(), row.arguments.end(), arguments.begin(), arguments.end(),
                           [](const auto& wanted, const urscript::Value& given) {
                               return !wanted || isSame(*wanted, given);
                           }));
    });
}

std::optional<DeviceAnswer> DeviceTable::answer(std::string_view line) {
    const std::string_view request = trimmed(line);
    return next([&](const Row& row) {
        if (!request.starts_with(row.name)) {
            return false;
        }
        const std::string_view rest = request.substr(row.name.size());
        if (rest.empty()) {
            return row.argumentText.empty() || row.anyArguments;
        }
        return isSeparator(rest.front()) && (row.anyArguments || trimmed(rest.substr(1)) == row.argumentText);
    });
}

}  // namespace tiller::simulator
