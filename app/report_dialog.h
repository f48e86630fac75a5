// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// "Report a problem": shows every file of the report before saving it. The report is not sent.

#include <QDialog>

#include "app/problem_report.h"

class QCheckBox;
class QLabel;
class QListWidget;
class QPlainTextEdit;

namespace tiller::app {

class ReportDialog : public QDialog {
    Q_OBJECT

public:
    explicit ReportDialog(ReportSources sources, QWidget* parent = nullptr);

    /// The files with the content that would be saved.
    QVector<ReportPart> parts() const;
    /// path  file path; the extension .zip is added if there is no extension
    void saveTo(const QString& path);

Q_SIGNALS:
    void saved(const QString& path);

private:
    void askToSave();
    void listParts();
    void showPart();

    ReportSources sources_;
    QPlainTextEdit* words_;
    QCheckBox* names_;
    QListWidget* list_;
    QPlainTextEdit* content_;
    QLabel* failure_;
};

}  // namespace tiller::app
