// SPDX-License-Identifier: MIT
#include "robot/project/project_file.h"

#include <QFile>
#include <QFileInfo>
#include <QJsonDocument>
#include <QSaveFile>

#include "robot/project/detail/project_reader.h"
#include "robot/project/detail/project_writer.h"

namespace tiller::project {
namespace {

/// As earlier versions called it; the fields are the same.
constexpr char kFormerFormat[] = "tiller-session";

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

Result<RecoveredProject> readRoot(const QJsonObject& root) {
    const QString format = root.value(QLatin1String("format")).toString();
    if (format != QLatin1String(kProjectFormat) && format != QLatin1String(kFormerFormat)) {
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
    reader.read(root, true);
    return reader.take();
}

Result<RecoveredProject> salvage(const QByteArray& bytes, const QJsonParseError& error) {
    const FileProblem problem{placeOf(bytes, error.offset), error.errorString()};
    if (!bytes.contains(kProjectFormat) && !bytes.contains(kFormerFormat)) {
        return corrupt(problem.toString());
    }
    const SalvagedEntries entries = salvageEntries(bytes);
    ProjectReader reader;
    reader.addProblem(problem.where, problem.what);
    reader.read(entries.root, false);
    for (auto list = entries.broken.cbegin(); list != entries.broken.cend(); ++list) {
        for (int i = 0; i < list.value(); ++i) {
            reader.addLost(list.key());
        }
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
    QByteArray bytes = QJsonDocument(toJson(document)).toJson(QJsonDocument::Indented);
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
