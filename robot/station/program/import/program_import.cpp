// SPDX-License-Identifier: MIT
#include "robot/station/program/import/program_import.h"

#include <QDir>
#include <QFileInfo>
#include <QRegularExpression>
#include <algorithm>

#include "robot/core/file_reading.h"
#include "robot/simulator/pendant/pendant_program.h"
#include "robot/simulator/script_run.h"
#include "robot/station/program/import/statement_import.h"
#include "robot/station/program/program_text.h"
#include "robot/station/program/step_kind.h"

namespace tiller::program {

using simulator::pendant::PendantProgram;
using simulator::pendant::PendantSource;

namespace {

Error importError(const QString& file, const QString& why) {
    return {ErrorCode::FileCorrupt, QStringLiteral("%1: %2").arg(file, why), {}};
}

/// Replaces the prefix of names that are reserved for generated scripts.
QString withoutReservedNames(QString script) {
    QString prefix = QStringLiteral("imported_");
    while (script.contains(prefix)) {
        prefix.prepend(QLatin1Char('x'));
    }
    return script.replace(QLatin1String("tiller_"), prefix);
}

/// note  receives a note for the report
Result<PendantProgram> readScriptFile(const ImportSource& source, QString& note) {
    const QString suffix = QFileInfo(source.file).suffix().toLower();
    PendantSource pendant;
    pendant.files = source.files ? source.files
                                 : [](const QString&) -> std::optional<QByteArray> { return std::nullopt; };
    pendant.keepsDisabled = true;
    pendant.isReserved = simulator::ScriptRun::isReservedName;
    const bool isUrp = suffix == QLatin1String("urp") || simulator::pendant::isUrpFile(source.content);
    Result<PendantProgram> read =
        isUrp ? simulator::pendant::readUrp(source.content, QStringLiteral("program"), pendant)
        : suffix == QLatin1String("urpx") ? simulator::pendant::readUrpx(source.content)
                                          : PendantProgram{source.content.toStdString(), {}, {}};
    if (!read) {
        // The teach pendant saves the script of a program in the same folder.
        const auto saved = isUrp || suffix == QLatin1String("urpx")
                               ? pendant.files(QFileInfo(source.file).completeBaseName() + ".script")
                               : std::nullopt;
        if (!saved) {
            return importError(source.file,
                               ProgramText::tr("%1. Save the program on the teach pendant and copy its "
                                               ".script file to the same folder, or change the program.")
                                   .arg(read.error().context));
        }
        note = ProgramText::tr(
                   "The nodes cannot be imported: %1. The script saved by the teach pendant was imported "
                   "instead.")
                   .arg(read.error().context);
        return PendantProgram{saved->toStdString(), {}, {}};
    }
    if (read->unfinished) {
        return importError(source.file,
                           ProgramText::tr("%1. Complete the program on the teach pendant first.")
                               .arg(read->unfinished->context));
    }
    return read;
}

}  // namespace

Result<ImportSource> readImportSource(const QString& path) {
    const auto content = readWholeFile(path, kMaxImportedBytes);
    if (!content) {
        return content.error();
    }
    ImportSource source;
    source.file = QFileInfo(path).fileName();
    source.content = *content;
    const QDir folder = QFileInfo(path).absoluteDir();
    source.files = [folder](const QString& name) -> std::optional<QByteArray> {
        const auto other = readWholeFile(folder.filePath(QFileInfo(name).fileName()), kMaxImportedBytes);
        return other ? std::optional(*other) : std::nullopt;
    };
    return source;
}

QString resultText(const ImportRow& row) {
    const StepKind* kind = findStepKind(row.kind);
    const QString step = kind == nullptr ? row.kind : kind->name();
    const auto withReason = [&row](const QString& text) {
        return row.reason.isEmpty() ? text : QStringLiteral("%1 (%2)").arg(text, row.reason);
    };
    const auto text = [&] {
        switch (row.result) {
            case ImportRow::Result::Step:
            case ImportRow::Result::Text:
                return withReason(step);
            case ImportRow::Result::Merged:
                return row.reason;
            case ImportRow::Result::Omitted:
                return withReason(ProgramText::tr("not imported"));
        }
        return QString();
    };
    return row.disabled ? ProgramText::tr("%1, disabled").arg(text()) : text();
}

int ImportedProgram::count(ImportRow::Result result) const {
    return static_cast<int>(
        std::count_if(rows.begin(), rows.end(), [&](const ImportRow& row) { return row.result == result; }));
}

Result<ImportedProgram> importProgram(const project::Project& project, const ImportSource& source) {
    const QString name =
        source.programName.isEmpty() ? QFileInfo(source.file).completeBaseName() : source.programName;
    if (name.trimmed().isEmpty()) {
        return Error{ErrorCode::InvalidArgument, ProgramText::tr("the program has no name"), {}};
    }
    if (project.programs.findByName(name) != nullptr) {
        return Error{ErrorCode::InvalidArgument,
                     ProgramText::tr("the project already has a program '%1'; choose another name").arg(name),
                     {}};
    }
    if (source.content.size() > kMaxImportedBytes) {
        return importError(source.file, ProgramText::tr("the file is too large for a program"));
    }
    QString note;
    const Result<PendantProgram> read = readScriptFile(source, note);
    if (!read) {
        return read.error();
    }
    const QString script =
        QString::fromStdString(read->script).remove(QLatin1Char('\r')).remove(QChar(QChar::ByteOrderMark));
    if (script.contains(QChar(0)) || script.contains(QChar::ReplacementCharacter)) {
        return importError(source.file, ProgramText::tr("the file is not text in UTF-8"));
    }
    static const QRegularExpression control(QStringLiteral("^\\s*\\$ 0 \"External Control\"$"),
                                            QRegularExpression::MultilineOption);
    if (script.contains(control)) {
        return importError(source.file,
                           ProgramText::tr("the External Control node runs a script from another computer, "
                                           "which cannot be imported. Remove this node from the program."));
    }
    Result<ImportedProgram> imported =
        importStatements(project, name, withoutReservedNames(script).split(QLatin1Char('\n')), read->marks);
    if (!imported) {
        return importError(source.file, imported.error().context);
    }
    if (!note.isEmpty()) {
        imported->notes.prepend(note);
    }
    return imported;
}

}  // namespace tiller::program
