// SPDX-License-Identifier: GPL-3.0-or-later

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include "app/cli_command.h"
#include "robot/station/program/import/program_import.h"

namespace tiller::app {

namespace {

using program::ImportRow;

QJsonObject rowJson(const ImportRow& row) {
    static const char* const kResults[] = {"step", "text", "merged", "omitted"};
    QJsonObject json{{"line", row.line},
                     {"name", row.name},
                     {"result", QLatin1String(kResults[static_cast<int>(row.result)])}};
    if (!row.kind.isEmpty()) {
        json.insert("kind", row.kind);
    }
    if (!row.reason.isEmpty()) {
        json.insert("reason", row.reason);
    }
    if (row.disabled) {
        json.insert("disabled", true);
    }
    return json;
}

void printReport(const QString& program, const QString& path, const program::ImportedProgram& imported,
                 bool asJson) {
    const int steps = imported.count(ImportRow::Result::Step);
    const int texts = imported.count(ImportRow::Result::Text);
    const int omitted = imported.count(ImportRow::Result::Omitted);
    if (asJson) {
        QJsonArray rows;
        for (const ImportRow& row : imported.rows) {
            rows.append(rowJson(row));
        }
        out() << QJsonDocument(QJsonObject{{"project", path},
                                           {"program", program},
                                           {"programs", imported.programs},
                                           {"waypoints", imported.waypoints},
                                           {"steps", steps},
                                           {"texts", texts},
                                           {"omitted", omitted},
                                           {"notes", QJsonArray::fromStringList(imported.notes)},
                                           {"rows", rows}})
                     .toJson();
        out().flush();
        return;
    }
    for (const ImportRow& row : imported.rows) {
        const QString line = row.line > 0 ? QString::number(row.line) : QString();
        out() << QStringLiteral("%1  %2: %3\n").arg(line, 4).arg(row.name, program::resultText(row));
    }
    for (const QString& note : imported.notes) {
        out() << "note: " << note << '\n';
    }
    out() << QStringLiteral(
                 "%1: program '%2': %3 entries imported as steps, %4 as URScript text, %5 not imported; %6 "
                 "new waypoints\n")
                 .arg(path, program, QString::number(steps), QString::number(texts), QString::number(omitted),
                      QString::number(imported.waypoints));
    out().flush();
}

int import(const CommandArguments& arguments) {
    if (arguments.operands().size() != 1) {
        return wrongArguments(QStringLiteral("import: one program file is required"));
    }
    if (!arguments.isSet("project")) {
        return wrongArguments(QStringLiteral("import: --project FILE is missing"));
    }
    const QString file = arguments.operands().constFirst();
    const QString path = arguments.value("project");
    auto source = program::readImportSource(file);
    if (!source) {
        return complain(source.error().toString(), kFailed);
    }
    source->programName = arguments.value("program");
    const auto opened = project::openProject(path);
    if (!opened) {
        return complain(opened.error().toString(), kFailed);
    }
    const auto imported = program::importProgram(opened->document, *source);
    if (!imported) {
        return complain(imported.error().toString(), kFailed);
    }
    const auto saved = project::saveProject(path, imported->project, QList<QByteArray>{opened->fingerprint});
    if (!saved) {
        return complain(saved.error().toString(), kFailed);
    }
    if (saved->changedByOther) {
        return complain(
            QStringLiteral("another program changed %1, so the import was not saved; try again").arg(path),
            kFailed);
    }
    const QString name = imported->project.programs.find(imported->program)->name;
    printReport(name, path, *imported, arguments.isSet("json"));
    return kSuccess;
}

}  // namespace

const Command& importCommand() {
    static const Command kCommand{
        .name = "import",
        .operands = "FILE",
        .summary = "adds a teach pendant program or a URScript file to a project",
        .title = "adds a teach pendant program or a URScript file to a project",
        .usage = {"FILE --project FILE.tiller [options]"},
        .operandRows = {{"FILE",
                         "program (.urp, .urpx) or URScript (.script). The installation, subprograms and "
                         "scripts that the program uses must be in the same folder"}},
        .options = {{"project", "FILE", "project to which the program and its waypoints are added"},
                    {"program", "NAME", "name of the new program; default: the name of the file"},
                    {"json", "", "prints the report as one JSON object"}},
        .notes =
            "For each node or statement, prints the resulting step. Everything without an equivalent step "
            "becomes URScript text. An existing program is never replaced, and after an error the "
            "project is unchanged. Exit code: 0 imported, 1 the program cannot be imported or a file cannot "
            "be read or written, 2 invalid arguments.",
        .run = import};
    return kCommand;
}

}  // namespace tiller::app
