// SPDX-License-Identifier: GPL-3.0-or-later

#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <algorithm>

#include "app/cli_command.h"
#include "robot/core/atomic_file.h"
#include "robot/core/file_reading.h"
#include "robot/station/document/cell_surroundings.h"
#include "robot/station/document/project_check.h"
#include "robot/station/document/waypoint_exchange.h"
#include "robot/station/text/move_words.h"
#include "robot/station/text/notation.h"
#include "robot/station/text/reach_words.h"

namespace tiller::app {

namespace {

QString named(const QString& name) {
    return QStringLiteral("“%1”").arg(name);
}

QString modelName(RobotModelId id) {
    return QString::fromLatin1(robotModel(id).name);
}

// ---- info ------------------------------------------------------------------------------------------

template <class List>
QJsonArray namesOf(const List& list) {
    QJsonArray names;
    for (const auto& entry : list) {
        names.append(entry.name);
    }
    return names;
}

QString frameOf(const project::Project& project, const project::Waypoint& point) {
    if (point.frame.isNull()) {
        return QStringLiteral("Base");
    }
    const project::Frame* frame = project.frames.find(point.frame);
    return frame != nullptr ? frame->name : QStringLiteral("missing");
}

QJsonObject infoOf(const project::Project& project) {
    QJsonArray waypoints;
    for (const project::Waypoint& point : project.waypoints) {
        waypoints.append(QJsonObject{{"name", point.name},
                                     {"move", point.move == project::MoveKind::Joint ? "J" : "L"},
                                     {"frame", frameOf(project, point)},
                                     {"actions", static_cast<int>(point.actions.size())}});
    }
    QJsonArray paths;
    for (const project::RecordedPath& path : project.paths) {
        paths.append(QJsonObject{{"name", path.name},
                                 {"points", static_cast<double>(path.points.size())},
                                 {"seconds", path.duration()}});
    }
    return {{"model", project.robot ? QJsonValue(modelName(*project.robot)) : QJsonValue()},
            {"waypoints", waypoints},
            {"frames", namesOf(project.frames)},
            {"tools", namesOf(project.tooling.tools)},
            {"payloads", namesOf(project.tooling.payloads)},
            {"positions", namesOf(project.positions.list)},
            {"patterns", namesOf(project.patterns)},
            {"paths", paths},
            {"boxes", namesOf(project.cell.boxes)},
            {"planes", namesOf(project.cell.planes)},
            {"floor", project.cell.floor ? QJsonValue(*project.cell.floor) : QJsonValue()},
            {"safetyDistance", project.cell.safetyDistance}};
}

void print(const QString& file, const project::Project& project) {
    out() << QStringLiteral("%1: %2, %3 waypoints\n")
                 .arg(file, project.robot ? modelName(*project.robot) : QStringLiteral("no robot model"))
                 .arg(project.waypoints.size());
    int number = 0;
    for (const project::Waypoint& point : project.waypoints) {
        out() << QStringLiteral("  %1  %2  Move%3, %4\n")
                     .arg(++number)
                     .arg(point.name,
                          point.move == project::MoveKind::Joint ? QStringLiteral("J") : QStringLiteral("L"),
                          frameOf(project, point));
    }
    const auto list = [](const char* title, const QJsonArray& names) {
        if (!names.isEmpty()) {
            QStringList texts;
            for (const QJsonValue& name : names) {
                texts << name.toString();
            }
            out() << title << ": " << texts.join(QStringLiteral(", ")) << '\n';
        }
    };
    list("frames", namesOf(project.frames));
    list("tools", namesOf(project.tooling.tools));
    list("payloads", namesOf(project.tooling.payloads));
    list("positions", namesOf(project.positions.list));
    list("patterns", namesOf(project.patterns));
    for (const project::RecordedPath& path : project.paths) {
        out() << QStringLiteral("recorded path: %1, %2 points, %3 s\n")
                     .arg(path.name)
                     .arg(path.points.size())
                     .arg(path.duration(), 0, 'f', 1);
    }
    list("boxes", namesOf(project.cell.boxes));
    list("planes", namesOf(project.cell.planes));
}

// ---- check -----------------------------------------------------------------------------------------

QString placeOf(const project::Project& project, const ProjectFinding& finding) {
    if (finding.kind == ProjectFinding::Kind::RecordedPath) {
        return QStringLiteral("recorded path ") +
               named(project.paths.at(static_cast<std::size_t>(finding.row)).name);
    }
    if (finding.kind == ProjectFinding::Kind::Unplaced) {
        return QStringLiteral("cell ") + named(finding.object.name);
    }
    const auto waypoint = [&](int row) {
        return QStringLiteral("%1 %2").arg(row + 1).arg(named(project.waypoints.at(row).name));
    };
    const bool isPath =
        finding.kind == ProjectFinding::Kind::Blocked || finding.kind == ProjectFinding::Kind::Slow;
    return isPath ? QStringLiteral("path %1 to %2").arg(waypoint(finding.row - 1), waypoint(finding.row))
                  : QStringLiteral("waypoint ") + waypoint(finding.row);
}

QString reasonOf(const ProjectFinding& finding, const collision::Surroundings& around) {
    switch (finding.kind) {
        case ProjectFinding::Kind::Unreachable:
            return reachAdvice(finding.reach);
        case ProjectFinding::Kind::TooClose: {
            const collision::Contact& contact = finding.contact;
            const QString part = linkText(contact.link);
            const QString other = surroundingsText(contact.with, contact.other, around);
            return contact.distance <= collision::kTouching
                       ? QStringLiteral("%1 is in contact with %2.").arg(part, other)
                       : QStringLiteral("%1 is only %2 from %3.")
                             .arg(part, format::shortLength(contact.distance), other);
        }
        case ProjectFinding::Kind::Blocked:
        case ProjectFinding::Kind::Slow:
        case ProjectFinding::Kind::RecordedPath:
            return limitText(finding.limit, around) + QLatin1Char('.');
        case ProjectFinding::Kind::Unplaced:
            return unplacedText(finding.object) + QLatin1Char('.');
    }
    return {};
}

int check(const QString& path, const project::Project& project, RobotModelId model, bool json) {
    const std::vector<ProjectFinding> findings = checkProject(project, robotModel(model));
    const collision::Surroundings around = surroundingsOf(project).around;
    const auto errors = std::count_if(findings.begin(), findings.end(),
                                      [](const ProjectFinding& finding) { return finding.isError(); });
    QJsonArray list;
    for (const ProjectFinding& finding : findings) {
        const QString severity = finding.isError() ? QStringLiteral("error") : QStringLiteral("warning");
        const QString place = placeOf(project, finding);
        const QString reason = reasonOf(finding, around);
        if (json) {
            list.append(QJsonObject{{"severity", severity}, {"where", place}, {"reason", reason}});
        } else {
            out() << severity << ": " << place << ": " << reason << '\n';
        }
    }
    if (json) {
        out() << QJsonDocument(QJsonObject{{"model", modelName(model)},
                                           {"waypoints", project.waypoints.size()},
                                           {"errors", static_cast<int>(errors)},
                                           {"findings", list}})
                     .toJson();
    } else {
        out() << QStringLiteral("%1: %2, %3 waypoints, %4 recorded paths: %5 errors, %6 warnings\n")
                     .arg(path, modelName(model))
                     .arg(project.waypoints.size())
                     .arg(project.paths.size())
                     .arg(errors)
                     .arg(static_cast<qsizetype>(findings.size()) - errors);
    }
    out().flush();
    return errors == 0 ? kSuccess : kFailed;
}

// ---- convert ---------------------------------------------------------------------------------------

Result<project::Project> projectOfWaypoints(const QString& path, RobotModelId model) {
    const Result<QByteArray> bytes = readWholeFile(path, project::kMaxProjectFileBytes);
    if (!bytes) {
        return bytes.error();
    }
    waypoint_clipboard::Defaults defaults;
    defaults.robot = &robotModel(model);
    auto waypoints = waypoint_exchange::fromCsv(*bytes, {}, defaults);
    if (!waypoints) {
        return waypoints.error();
    }
    project::Project project;
    project.robot = model;
    for (project::Waypoint& point : *waypoints) {
        project.waypoints.append(std::move(point));
    }
    return project;
}

Result<void> writeCsv(const QString& path, const project::Project& project) {
    const std::vector<project::Waypoint> waypoints(project.waypoints.begin(), project.waypoints.end());
    return writeFileAtomically(path, waypoint_exchange::toCsv(waypoints, project.frames));
}

int runProjectAction(const CommandArguments& arguments) {
    const QStringList words = arguments.operands();
    if (words.size() != 2 || !QStringList{"info", "check", "convert"}.contains(words.constFirst())) {
        return wrongArguments(
            QStringLiteral("project: an action (info, check or convert) and one file are required"));
    }
    const QString& action = words[0];
    const QString& path = words[1];
    const auto chosen = robotModelByName(arguments.value("model"));
    if (arguments.isSet("model") && !chosen) {
        return wrongArguments(
            QStringLiteral("project: '%1' is not a robot model").arg(arguments.value("model")));
    }
    const auto isCsv = [](const QString& file) {
        return QFileInfo(file).suffix().compare(QLatin1String("csv"), Qt::CaseInsensitive) == 0;
    };
    const QString target = arguments.value("out");
    const bool converts = action == QLatin1String("convert");
    if (converts) {
        if (!isCsv(target) &&
            QFileInfo(target).suffix().compare(QLatin1String("tiller"), Qt::CaseInsensitive) != 0) {
            return wrongArguments(QStringLiteral("project: --out FILE.tiller or --out FILE.csv is missing"));
        }
        if (isCsv(path) && isCsv(target)) {
            return wrongArguments(
                QStringLiteral("project: a .csv file can be converted only to a .tiller file"));
        }
        if (QFileInfo::exists(target) && !arguments.isSet("force")) {
            return wrongArguments(
                QStringLiteral("project: %1 already exists; --force replaces it").arg(target));
        }
        if (isCsv(path) && !chosen) {
            return wrongArguments(
                QStringLiteral("project: a .csv file contains no robot model; use --model"));
        }
    }
    Result<project::Project> loaded =
        converts && isCsv(path) ? projectOfWaypoints(path, *chosen) : project::loadProject(path);
    if (!loaded) {
        return complain(loaded.error().toString(), kFailed);
    }
    if (action == QLatin1String("info")) {
        if (arguments.isSet("json")) {
            out() << QJsonDocument(infoOf(*loaded)).toJson();
        } else {
            print(path, *loaded);
        }
        out().flush();
        return kSuccess;
    }
    if (chosen && loaded->robot && *loaded->robot != *chosen) {
        return wrongArguments(
            QStringLiteral("project: %1 is for %2; --model is only for files without a robot model")
                .arg(path, modelName(*loaded->robot)));
    }
    if (!loaded->robot) {
        loaded->robot = chosen;
    }
    if (!converts) {
        return loaded->robot
                   ? check(path, *loaded, *loaded->robot, arguments.isSet("json"))
                   : wrongArguments(
                         QStringLiteral("project: %1 contains no robot model; use --model").arg(path));
    }
    Result<void> written;
    if (isCsv(target)) {
        written = writeCsv(target, *loaded);
    } else if (const auto saved = project::saveProject(target, *loaded); !saved) {
        written = saved.error();
    }
    if (!written) {
        return complain(written.error().toString(), kFailed);
    }
    out() << QStringLiteral("%1: %2 waypoints").arg(target).arg(loaded->waypoints.size()) << Qt::endl;
    return kSuccess;
}

}  // namespace

const Command& projectCommand() {
    static const Command kCommand{
        .name = "project",
        .operands = "ACTION FILE",
        .summary = "inspects, checks or converts a project (see 'tiller-cli project --help')",
        .title = "inspects, checks and converts projects",
        .usage = {"info FILE [options]", "check FILE [options]", "convert FILE --out FILE [options]"},
        .operandRows = {{"info", "prints the content of the project"},
                        {"check",
                         "checks every waypoint and every path: reach, singularities, and collisions "
                         "between the arm, the tool and the cell. Uses the nominal kinematics of the robot "
                         "model"},
                        {"convert",
                         "converts the waypoints of a .tiller file to a .csv file, a .csv file to a .tiller "
                         "file, or a .tiller file of an earlier version to the current version"},
                        {"FILE", "project (.tiller); convert also accepts waypoints (.csv)"}},
        .options = {{"json", "", "info, check: prints one JSON object instead of text"},
                    {"model", "MODEL",
                     "robot model for a file that contains no model: ur3e, ur5e, ur10e, ur20, ur30..."},
                    {"out", "FILE", "convert: file to write, .tiller or .csv"},
                    {"force", "", "convert: replaces an existing file"}},
        .notes =
            "Exit code: 0 success, and check found no error; 1 the file cannot be read or written, or check "
            "found an error; 2 invalid arguments. A problem that only slows down the arm is a warning.",
        .run = runProjectAction};
    return kCommand;
}

}  // namespace tiller::app
