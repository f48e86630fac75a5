// SPDX-License-Identifier: GPL-3.0-or-later
// What the plot panel writes: exports of the shown range, and recordings.
#include <QDateTime>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QPixmap>
#include <QStandardPaths>

#include "widgets/plots/plot_dock.h"
#include "widgets/plots/plot_export.h"
#include "widgets/plots/plot_view.h"
#include "widgets/session/robot_session.h"
#include "widgets/session/texts.h"

namespace tiller {

Result<void> PlotDock::exportCsv(const QString& path) const {
    const Result<std::int64_t> rows =
        tiller::exportCsv(*history_, view_->window().start(), view_->window().end(), path);
    return rows ? Result<void>() : Result<void>(rows.error());
}

Result<void> PlotDock::exportPng(const QString& path) const {
    // The whole panel: title, cursors' read-out and lane belong to what the picture says.
    const QPixmap picture = const_cast<PlotDock*>(this)->grab();
    QFileInfo file(path);
    if (!file.absoluteDir().exists()) {
        return Error{ErrorCode::FileNotWritable, tr("export to %1").arg(path),
                     tr("the folder does not exist")};
    }
    if (!picture.save(path, "PNG")) {
        return Error{ErrorCode::FileNotWritable, tr("export to %1").arg(path), {}};
    }
    return {};
}

bool PlotDock::exportTo(const QString& path) {
    const bool csv = path.endsWith(QStringLiteral(".csv"), Qt::CaseInsensitive);
    const Result<void> result = csv ? exportCsv(path) : exportPng(path);
    if (result) {
        Q_EMIT session_.message(Severity::Info, tr("Exported the shown range to %1").arg(path));
    } else if (result.error().code == ErrorCode::InvalidArgument) {
        Q_EMIT session_.message(Severity::Warning,
                                tr("Nothing was exported: the plots show no samples. Connect to a robot, or "
                                   "scroll to a time with samples."));
    } else {
        Q_EMIT session_.message(Severity::Error, texts::errorText(result.error()));
    }
    return result.ok();
}

void PlotDock::askExport() {
    const QString png = tr("Picture (*.png)");
    const QString csv = tr("Values (*.csv)");
    const QString folder = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
    const QString stamp = QDateTime::currentDateTime().toString(QStringLiteral("yyyy-MM-dd_HH-mm-ss"));
    QString filter = png;
    QString path = QFileDialog::getSaveFileName(this, tr("Export the shown range"),
                                                QDir(folder).filePath(QStringLiteral("plots_") + stamp),
                                                png + QStringLiteral(";;") + csv, &filter);
    if (path.isEmpty()) {
        return;
    }
    if (QFileInfo(path).suffix().isEmpty()) {
        path += filter == csv ? QStringLiteral(".csv") : QStringLiteral(".png");
    }
    exportTo(path);
}

void PlotDock::toggleRecording() {
    if (recording_) {
        session_.recording().stop();
        return;
    }
    QString folder = recordingFolder_;
    if (folder.isEmpty()) {
        folder = QDir(QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation))
                     .filePath(QStringLiteral("Tiller"));
    }
    QDir().mkpath(folder);
    const QString name =
        QDateTime::currentDateTime().toString(QStringLiteral("yyyy-MM-dd_HH-mm-ss")) + QStringLiteral(".csv");
    session_.recording().start(QDir(folder).filePath(name));
}

}  // namespace tiller
