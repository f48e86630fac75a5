// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// "Report a problem": shows every file of the report before it is saved. The report is not sent anywhere.

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

    /// The files as they would be saved now.
    QVector<ReportPart> parts() const;
    /// path  gets the extension .zip if it has none
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
