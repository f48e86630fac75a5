// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What somebody who is to help needs to know, as one zip: versions, log, settings, the last stop, a crash. Names and
// addresses stay at home unless the user lets them go.

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
    QString name;  ///< "log.txt"
    QByteArray content;
};

/// What the report is made of.
struct ReportSources {
    SettingsBundle settings;
    SessionState state;
    QStringList knownNames;  ///< of robots, inputs, outputs and files, and addresses: what is hidden
    QString log;
    std::optional<StopRecord> lastStop;
    QByteArray crash;
};

/// Replaces these names, and everything that is an address or lies in somebody's home, by a word for it.
QString withoutNames(QString text, const QStringList& names);

/// names  false: without names and addresses; words  what the user says about it, kept as it is
QVector<ReportPart> reportParts(const ReportSources& sources, bool names, const QString& words);

/// A zip archive of these files.
QByteArray zipped(const QVector<ReportPart>& parts);

/// Errors  FileNotWritable, DiskFull
Result<void> writeReport(const QString& path, const QVector<ReportPart>& parts);

}  // namespace tiller::app
