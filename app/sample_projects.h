// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The sample projects of the application, and the dialog for selecting one. The application opens a copy of
// the sample.

#include <QDialog>
#include <QList>
#include <QString>

namespace tiller::app {

struct SampleProject {
    QString id;     ///< base name of the file, e.g. "gluing"
    QString title;  ///< name of the copy until it is saved
    QString text;   ///< description in two sentences
    QString path;   ///< path of the embedded resource
};

QList<SampleProject> sampleProjects();

class SampleDialog : public QDialog {
    Q_OBJECT

public:
    explicit SampleDialog(QWidget* parent = nullptr);

Q_SIGNALS:
    /// The user has selected a sample. The dialog is closed.
    void chosen(const QString& path, const QString& title);

protected:
    void showEvent(QShowEvent* event) override;
};

}  // namespace tiller::app
