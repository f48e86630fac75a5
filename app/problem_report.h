// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A problem report for the support team as one zip file: versions, log, settings, the last stop, and a crash
// report. Names and addresses are removed unless the user includes them.

#include <QByteArray>
#include <QString>
#include <QStringList>
#include <QVector>
#include <optional>

#include "app/settings_file.h"
#include "robot/core/result.h"
#include "robot/station/capture/stop_record.h"
#include "robot/station/link/session_state.h"

namespace tiller::app {

/// One file of the report.
struct ReportPart {
    QString name;  ///< e.g. "log.txt"
    QByteArray content;
};

/// The sources of the report.
struct ReportSources {
    SettingsBundle settings;
    SessionState state;
    /// Names of robots, inputs, outputs and files, and addresses that must be removed.
    QStringList knownNames;
    QString log;
    std::optional<StopRecord> lastStop;
    QByteArray crash;
};

/// Replaces these names and all addresses and home folders by placeholders.
QString withoutNames(QString text, const QStringList& names);

/// names  false: names and addresses are removed
/// words  description written by the user; not modified
QVector<ReportPart> reportParts(const ReportSources& sources, bool names, const QString& words);

/// Creates a zip archive of these files.
QByteArray zipped(const QVector<ReportPart>& parts);

/// Errors  FileNotWritable, DiskFull
Result<void> writeReport(const QString& path, const QVector<ReportPart>& parts);

}  // namespace tiller::app
