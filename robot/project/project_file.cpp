// SPDX-License-Identifier: MIT
#include "robot/project/project_file.h"

#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QSaveFile>

#include "robot/project/detail/project_reader.h"

namespace tiller::project {
namespace {

constexpr char kFormat[] = "tiller-project";
/// As earlier versions called it; the fields are the same.
constexpr char kFormerFormat[] = "tiller-session";

QJsonArray arrayOf(const std::array<double, 6>& values) {
    QJsonArray result;
    for (const double value : values) {
        result.append(value);
    }
    return result;
}

QString textOf(const QUuid& id) {
    return id.toString(QUuid::WithoutBraces);
}

QJsonObject toJson(const Frame& frame) {
    QJsonObject object = frame.extra;
    object["id"] = textOf(frame.id);
    object["name"] = frame.name;
    object["pose"] = arrayOf(frame.T_base_frame.array());
    return object;
}

QJsonObject toJson(const Waypoint& point) {
    QJsonObject object = point.extra;
    object["id"] = textOf(point.id);
    object["name"] = point.name;
    object["move"] = QLatin1String(point.move == MoveKind::Joint ? "J" : "L");
    object["rules"] = QLatin1String(point.ruling == Ruling::Joints ? "joints" : "pose");
    object["frame"] = point.frame.isNull() ? QJsonValue(QJsonValue::Null) : QJsonValue(textOf(point.frame));
    object["tcpOffset"] = arrayOf(point.tcpOffset.array());
    object["joints"] = arrayOf(point.joints.array());
    object["pose"] = arrayOf(point.pose.array());
    object["jointSpeed"] = point.jointSpeed;
    object["toolSpeed"] = point.toolSpeed;
    object["blend"] = point.blend;
    return object;
}

QString placeOf(const QByteArray& bytes, int offset) {
    const QByteArray before = bytes.left(offset);
    const qsizetype line = before.count('\n') + 1;
    const qsizetype column = before.size() - before.lastIndexOf('\n');
    return QStringLiteral("line %1, column %2").arg(line).arg(column);
}

Error corrupt(const QString& what) {
    return {ErrorCode::FileCorrupt, what, {}};
}

Error inFile(Error error, const QString& path) {
    error.context = QStringLiteral("%1: %2").arg(QFileInfo(path).fileName(), error.context);
    return error;
}

Result<QByteArray> readFile(const QString& path) {
    QFile file(path);
    if (QFileInfo(path).isDir() || !file.open(QIODevice::ReadOnly)) {
        return Error{ErrorCode::FileNotReadable, QStringLiteral("read %1").arg(path), file.errorString()};
    }
    if (file.size() > kMaxProjectFileBytes) {
        return inFile(
            corrupt(
                QStringLiteral("has %1 MB, more than a project can have").arg(file.size() / (1024 * 1024))),
            path);
    }
    QByteArray bytes = file.readAll();
    if (file.error() != QFileDevice::NoError) {
        return Error{ErrorCode::FileNotReadable, QStringLiteral("read %1").arg(path), file.errorString()};
    }
    return bytes;
}

Error writeError(const QString& path, const QFileDevice& file) {
    const bool full = file.error() == QFileDevice::ResourceError;
    return {full ? ErrorCode::DiskFull : ErrorCode::FileNotWritable, QStringLiteral("write %1").arg(path),
            file.errorString()};
}

/// A file that would be written over although it cannot be read completely goes aside first.
Result<SaveReport> keepWhatCannotBeRead(const QString& path) {
    const QFileInfo info(path);
    if (!info.exists() || (info.isFile() && info.size() == 0) || loadProject(path).ok()) {
        return SaveReport{};
    }
    for (int number = 1;; ++number) {
        const QString copy = QStringLiteral("%1.damaged-%2").arg(path).arg(number);
        if (QFileInfo::exists(copy)) {
            continue;
        }
        QFile file(path);
        if (!file.copy(copy)) {
            return Error{ErrorCode::FileNotWritable,
                         QStringLiteral("put the damaged %1 aside as %2").arg(path, copy),
                         file.errorString()};
        }
        return SaveReport{copy};
    }
}

/// An array of the root; a wrong type is a problem, absence only where it is said to be one.
QJsonArray arrayIn(const QJsonObject& root, const char* key, bool required, ProjectReader& reader) {
    const QJsonValue value = root.value(QLatin1String(key));
    if (value.isUndefined() ? required : !value.isArray()) {
        reader.addProblem(QLatin1String(key), value.isUndefined() ? QStringLiteral("is missing")
                                                                  : QStringLiteral("is not a list"));
    }
    return value.toArray();
}

Result<RecoveredProject> readRoot(const QJsonObject& root) {
    const QString format = root.value(QLatin1String("format")).toString();
    if (format != QLatin1String(kFormat) && format != QLatin1String(kFormerFormat)) {
        return corrupt(QStringLiteral("is not a Tiller project (field \"format\")"));
    }
    ProjectReader reader;
    const QJsonValue version = root.value(QLatin1String("version"));
    if (version.toDouble(0) > kProjectFileVersion) {
        return Error{
            ErrorCode::VersionUnsupported,
            QStringLiteral("was written by a newer Tiller (version %1 of the format, this one reads %2)")
                .arg(version.toDouble())
                .arg(kProjectFileVersion),
            {}};
    }
    if (version.toInt(0) < 1) {
        reader.addProblem(QStringLiteral("version"), version.isUndefined()
                                                         ? QStringLiteral("is missing")
                                                         : QStringLiteral("is not a whole number from 1 on"));
    }
    reader.readRobot(root.value(QLatin1String("robot")));
    reader.readFrames(arrayIn(root, "frames", false, reader));
    reader.readWaypoints(arrayIn(root, "waypoints", true, reader));
    reader.setExtra(without(root, {"format", "version", "robot", "frames", "waypoints"}));
    return reader.take();
}

Result<RecoveredProject> salvage(const QByteArray& bytes, const QJsonParseError& error) {
    const FileProblem problem{placeOf(bytes, error.offset), error.errorString()};
    if (!bytes.contains(kFormat) && !bytes.contains(kFormerFormat)) {
        return corrupt(problem.toString());
    }
    const SalvagedEntries entries = salvageEntries(bytes);
    ProjectReader reader;
    reader.addProblem(problem.where, problem.what);
    reader.readFrames(entries.frames);
    reader.readWaypoints(entries.waypoints);
    for (int i = 0; i < entries.brokenFrames; ++i) {
        reader.addLostFrame();
    }
    for (int i = 0; i < entries.brokenWaypoints; ++i) {
        reader.addLostWaypoint();
    }
    return reader.take();
}

}  // namespace

Result<RecoveredProject> recoverFromBytes(const QByteArray& bytes) {
    QJsonParseError error;
    const QJsonDocument json = QJsonDocument::fromJson(bytes, &error);
    if (error.error != QJsonParseError::NoError) {
        return salvage(bytes, error);
    }
    if (!json.isObject()) {
        return corrupt(QStringLiteral("is not a Tiller project (not an object)"));
    }
    return readRoot(json.object());
}

Result<RecoveredProject> recoverProject(const QString& path) {
    const Result<QByteArray> bytes = readFile(path);
    if (!bytes) {
        return bytes.error();
    }
    Result<RecoveredProject> recovered = recoverFromBytes(*bytes);
    return recovered ? recovered : inFile(recovered.error(), path);
}

Result<Project> parseProject(const QByteArray& bytes) {
    Result<RecoveredProject> recovered = recoverFromBytes(bytes);
    if (!recovered) {
        return recovered.error();
    }
    if (!recovered->problems.isEmpty()) {
        const qsizetype others = recovered->problems.size() - 1;
        QString what = recovered->problems.first().toString();
        if (others > 0) {
            what += QStringLiteral(" (and %1 more)").arg(others);
        }
        return corrupt(what);
    }
    return std::move(recovered->document);
}

Result<Project> loadProject(const QString& path) {
    const Result<QByteArray> bytes = readFile(path);
    if (!bytes) {
        return bytes.error();
    }
    Result<Project> document = parseProject(*bytes);
    return document ? document : inFile(document.error(), path);
}

Result<QByteArray> serializeProject(const Project& document) {
    QJsonArray frames;
    for (const Frame& frame : document.frames) {
        frames.append(toJson(frame));
    }
    QJsonArray waypoints;
    for (const Waypoint& point : document.waypoints) {
        waypoints.append(toJson(point));
    }
    QJsonObject root = document.extra;
    root["format"] = QLatin1String(kFormat);
    root["version"] = kProjectFileVersion;
    if (document.robot) {
        root["robot"] = QLatin1String(robotModel(*document.robot).name);
    }
    root["frames"] = frames;
    root["waypoints"] = waypoints;
    QByteArray bytes = QJsonDocument(root).toJson(QJsonDocument::Indented);
    // What could not be read again must not be written: JSON has no NaN, for one.
    const Result<Project> again = parseProject(bytes);
    if (!again) {
        return Error{ErrorCode::InvalidArgument, again.error().context, {}};
    }
    return bytes;
}

Result<SaveReport> saveProject(const QString& path, const Project& document) {
    const Result<QByteArray> bytes = serializeProject(document);
    if (!bytes) {
        return bytes.error();
    }
    Result<SaveReport> report = keepWhatCannotBeRead(path);
    if (!report) {
        return report;
    }
    QSaveFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(*bytes) != bytes->size() || !file.commit()) {
        return writeError(path, file);
    }
    return report;
}

}  // namespace tiller::project
