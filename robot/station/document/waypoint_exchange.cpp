// SPDX-License-Identifier: MIT
#include "robot/station/document/waypoint_exchange.h"

#include <QCoreApplication>
#include <QHash>
#include <QSet>
#include <QStringList>
#include <algorithm>

#include "robot/project/project_file.h"

namespace tiller::waypoint_exchange {
namespace {

struct WaypointExchange {
    Q_DECLARE_TR_FUNCTIONS(WaypointExchange)
};

QString quoted(const QString& field) {
    if (!field.contains(QLatin1Char(',')) && !field.contains(QLatin1Char('"')) &&
        !field.contains(QLatin1Char('\n'))) {
        return field;
    }
    return QLatin1Char('"') + QString(field).replace(QLatin1Char('"'), QLatin1String("\"\"")) +
           QLatin1Char('"');
}

QChar separatorOf(const QString& text) {
    const QString line = text.section(QLatin1Char('\n'), 0, 0);
    const auto more = [&](QChar a, QChar b) { return line.count(a) >= line.count(b) ? a : b; };
    return more(more(QLatin1Char(','), QLatin1Char(';')), QLatin1Char('\t'));
}

/// Converts the text to the tab-separated fields of the clipboard.
Result<QString> tabbed(const QString& text) {
    const QChar separator = separatorOf(text);
    QString result;
    bool inside = false;
    int line = 1;
    for (qsizetype i = 0; i < text.size(); ++i) {
        const QChar c = text[i];
        if (c == QLatin1Char('\n')) {
            ++line;
        }
        if (c == QLatin1Char('"')) {
            if (inside && i + 1 < text.size() && text[i + 1] == QLatin1Char('"')) {
                result += c;
                ++i;
            } else {
                inside = !inside;
            }
        } else if (inside) {
            // Line breaks and tabs within a quoted field do not end the field.
            result += c == QLatin1Char('\n') || c == QLatin1Char('\t') ? QLatin1Char(' ') : c;
        } else {
            result += c == separator ? QLatin1Char('\t') : c;
        }
    }
    if (inside) {
        return Error{ErrorCode::InvalidArgument,
                     WaypointExchange::tr("Line %1: the closing quotation mark is missing.").arg(line),
                     {}};
    }
    return result;
}

}  // namespace

QByteArray toCsv(const std::vector<project::Waypoint>& waypoints, const project::FrameList& frames) {
    QString result;
    QStringList lines = waypoint_clipboard::toText(waypoints, frames).split(QLatin1Char('\n'));
    lines.removeLast();  // empty line after the last line break
    for (const QString& line : std::as_const(lines)) {
        QStringList fields = line.split(QLatin1Char('\t'));
        std::transform(fields.begin(), fields.end(), fields.begin(), quoted);
        result += fields.join(QLatin1Char(',')) + QLatin1String("\r\n");
    }
    return result.toUtf8();
}

Result<std::vector<project::Waypoint>> fromCsv(const QByteArray& bytes, const project::FrameList& frames,
                                               const waypoint_clipboard::Defaults& defaults) {
    QString text = QString::fromUtf8(bytes);
    if (text.startsWith(QChar(0xFEFF))) {
        text.remove(0, 1);  // byte order mark, which spreadsheets write
    }
    const Result<QString> table = tabbed(text.remove(QLatin1Char('\r')));
    if (!table) {
        return table.error();
    }
    return waypoint_clipboard::fromText(*table, frames, defaults);
}

Result<QByteArray> toJson(const std::vector<project::Waypoint>& waypoints, const project::FrameList& frames,
                          RobotModelId robot) {
    project::Project document;
    document.robot = robot;
    QSet<QUuid> needed;
    for (project::Waypoint point : waypoints) {
        point.history = {};
        point.place = {};
        needed.insert(point.frame);
        document.waypoints.append(std::move(point));
    }
    for (const project::Frame& frame : frames) {
        if (needed.contains(frame.id)) {
            document.frames.append(frame);
        }
    }
    return project::serializeProject(document);
}

Result<Imported> fromJson(const QByteArray& bytes, const project::FrameList& frames) {
    const Result<project::Project> read = project::parseProject(bytes);
    if (!read) {
        return read.error();
    }
    Imported result;
    QHash<QUuid, QUuid> ids;
    for (project::Frame frame : read->frames) {
        const project::Frame* here = frames.findByName(frame.name);
        if (here != nullptr) {
            ids.insert(frame.id, here->id);
            continue;
        }
        const QUuid id = frames.find(frame.id) != nullptr ? QUuid::createUuid() : frame.id;
        ids.insert(frame.id, id);
        frame.id = id;
        result.frames.push_back(frame);
    }
    for (project::Waypoint point : read->waypoints) {
        point.id = QUuid::createUuid();
        point.frame = point.frame.isNull() ? QUuid() : ids.value(point.frame);
        point.history = {};
        point.place = {};
        result.waypoints.push_back(std::move(point));
    }
    return result;
}

}  // namespace tiller::waypoint_exchange
