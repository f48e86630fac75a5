// SPDX-License-Identifier: MIT
#include "robot/project/project_file.h"

#include <QCryptographicHash>
#include <QFileInfo>
#include <QJsonDocument>

#include "robot/core/atomic_file.h"
#include "robot/core/file_reading.h"
#include "robot/core/save_guard.h"
#include "robot/core/text_place.h"
#include "robot/project/detail/project_reader.h"
#include "robot/project/detail/project_writer.h"

namespace tiller::project {
namespace {

/// Format name in files of earlier versions. The fields are the same.
constexpr char kFormerFormat[] = "tiller-session";

Error corrupt(const QString& what) {
    return {ErrorCode::FileCorrupt, what, {}};
}

Error inFile(Error error, const QString& path) {
    error.context = QStringLiteral("%1: %2").arg(QFileInfo(path).fileName(), error.context);
    return error;
}

/// Copies a file that cannot be read completely to another name before the file is replaced.
/// there  content of the file
Result<QString> keepDamaged(const QString& path, const QByteArray& there) {
    if (there.isEmpty() || parseProject(there).ok()) {
        return QString();
    }
    QString copy;
    for (int number = 1; copy.isEmpty() || QFileInfo::exists(copy); ++number) {
        copy = QStringLiteral("%1.damaged-%2").arg(path).arg(number);
    }
    const Result<void> kept =
        writeFileAtomically(copy, there, QStringLiteral("%1, a copy of the damaged file %2").arg(copy, path));
    return kept ? Result<QString>(copy) : Result<QString>(kept.error());
}

Result<RecoveredProject> readRoot(const QJsonObject& root) {
    const QString format = root.value(QLatin1String("format")).toString();
    if (format != QLatin1String(kProjectFormat) && format != QLatin1String(kFormerFormat)) {
        return corrupt(QStringLiteral("not a Tiller project (field \"format\")"));
    }
    ProjectReader reader;
    const QJsonValue version = root.value(QLatin1String("version"));
    if (version.toDouble(0) > kProjectFileVersion) {
        return Error{
            ErrorCode::VersionUnsupported,
            QStringLiteral(
                "written by a newer version of Tiller (format version %1; this version reads up to %2)")
                .arg(version.toDouble())
                .arg(kProjectFileVersion),
            {}};
    }
    if (version.toInt(0) < 1) {
        reader.addProblem(QStringLiteral("version"),
                          version.isUndefined() ? QStringLiteral("is missing")
                                                : QStringLiteral("is not a whole number of 1 or more"));
    }
    reader.read(root, true);
    return reader.take();
}

Result<RecoveredProject> salvage(const QByteArray& bytes, const QJsonParseError& error) {
    const FileProblem problem{placeInText(bytes, error.offset), error.errorString()};
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
        return corrupt(QStringLiteral("not a Tiller project (not an object)"));
    }
    return readRoot(json.object());
}

QByteArray fingerprintOf(const QByteArray& content) {
    return QCryptographicHash::hash(content, QCryptographicHash::Sha256);
}

Result<RecoveredProject> recoverProject(const QString& path) {
    const Result<QByteArray> bytes = readWholeFile(path, kMaxProjectFileBytes);
    if (!bytes) {
        return bytes.error();
    }
    Result<RecoveredProject> recovered = recoverFromBytes(*bytes);
    if (!recovered) {
        return inFile(recovered.error(), path);
    }
    recovered->fingerprint = fingerprintOf(*bytes);
    return recovered;
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

Result<OpenedProject> openProject(const QString& path) {
    const Result<QByteArray> bytes = readWholeFile(path, kMaxProjectFileBytes);
    if (!bytes) {
        return bytes.error();
    }
    Result<Project> document = parseProject(*bytes);
    if (!document) {
        return inFile(document.error(), path);
    }
    return OpenedProject{std::move(*document), fingerprintOf(*bytes)};
}

Result<Project> loadProject(const QString& path) {
    Result<OpenedProject> opened = openProject(path);
    return opened ? Result<Project>(std::move(opened->document)) : opened.error();
}

Result<QByteArray> serializeProject(const Project& document) {
    QByteArray bytes = QJsonDocument(toJson(document)).toJson(QJsonDocument::Indented);
    // Do not write content that could not be read back, e.g. NaN, which JSON does not support.
    const Result<Project> again = parseProject(bytes);
    if (!again) {
        return Error{ErrorCode::InvalidArgument, again.error().context, {}};
    }
    return bytes;
}

Result<SaveReport> saveProject(const QString& path, const Project& document,
                               const std::optional<QList<QByteArray>>& known) {
    const Result<QByteArray> bytes = serializeProject(document);
    if (!bytes) {
        return bytes.error();
    }
    const auto guard = SaveGuard::acquire(path);
    if (!guard) {
        return guard.error();
    }
    SaveReport report;
    report.fingerprint = fingerprintOf(*bytes);
    if (QFileInfo::exists(path)) {
        const Result<QByteArray> there = readWholeFile(path, kMaxProjectFileBytes);
        if (!there) {
            return there.error();
        }
        const QByteArray found = fingerprintOf(*there);
        if (known && found != report.fingerprint && !known->contains(found)) {
            report.changedByOther = true;
            return report;
        }
        const Result<QString> kept = keepDamaged(path, *there);
        if (!kept) {
            return kept.error();
        }
        report.keptCopy = *kept;
    }
    if (const Result<void> written = writeFileAtomically(path, *bytes); !written) {
        return written.error();
    }
    return report;
}

}  // namespace tiller::project
