// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The sample projects that come with the program, and the dialog that offers them. Each is opened as a copy.

#include <QDialog>
#include <QList>
#include <QString>

namespace tiller::app {

struct SampleProject {
    QString id;     ///< "gluing", the name of its file
    QString title;  ///< what the copy is called until it is saved
    QString text;   ///< two sentences
    QString path;   ///< in the program's own resources
};

QList<SampleProject> sampleProjects();

class SampleDialog : public QDialog {
    Q_OBJECT

public:
    explicit SampleDialog(QWidget* parent = nullptr);

Q_SIGNALS:
    /// It was chosen, and the dialog has closed.
    void chosen(const QString& path, const QString& title);

protected:
    void showEvent(QShowEvent* event) override;
};

}  // namespace tiller::app
