// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A problem report for the support team as a zip file: versions, log, settings, the last stop, and a crash
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

/// The data for the report.
struct ReportSources {
    SettingsBundle settings;
    SessionState state;
    /// Texts to remove: names of robots, inputs, outputs and files, and addresses.
    QStringList knownNames;
    QString log;
    std::optional<StopRecord> lastStop;
    QByteArray crash;
};

/// Replaces these names, all addresses and all home folders by placeholders.
QString withoutNames(QString text, const QStringList& names);

/// names  if false, names and addresses are removed
/// words  description by the user; included unchanged
QVector<ReportPart> reportParts(const ReportSources& sources, bool names, const QString& words);

/// Creates a zip archive of these files.
QByteArray zipped(const QVector<ReportPart>& parts);

/// Errors  FileNotWritable, DiskFull
Result<void> writeReport(const QString& path, const QVector<ReportPart>& parts);

}  // namespace tiller::app
