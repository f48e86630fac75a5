// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/project/project_files.h"

#include <QApplication>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>
#include <QStandardPaths>

#include "widgets/session/texts.h"

namespace tiller {

QString projectFolder() {
    const QString documents = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
    return QDir(documents.isEmpty() ? QDir::homePath() : documents).filePath(QStringLiteral("Tiller"));
}

ProjectFiles::ProjectFiles(ProjectDocument& document, QObject* parent) : QObject(parent), store_(document) {
    connect(&store_, &ProjectStore::keptAside, this, [this](const QString& copy) {
        Q_EMIT message(Severity::Warning, tr("The damaged project file was kept as %1").arg(copy));
    });
    connect(&store_, &ProjectStore::saveFailed, this,
            [this](const Error& error) { warn(tr("The project could not be saved"), error); });
}

void ProjectFiles::warn(const QString& title, const Error& error) {
    // The version is the file's here, never the robot's.
    const QString text =
        error.code == ErrorCode::VersionUnsupported
            ? tr("%1. Update Tiller to open it. The file was left as it is.").arg(error.context)
            : texts::errorText(error);
    Q_EMIT message(Severity::Error, text);
    Q_EMIT noticeWanted({title, text, {}, {}});
}

QString ProjectFiles::startingPlace() const {
    if (!store_.copyName().isEmpty()) {
        return QDir(projectFolder()).filePath(store_.copyName() + QStringLiteral(".tiller"));
    }
    return store_.path().isEmpty() ? projectFolder() : store_.path();
}

void ProjectFiles::askToOpen(QWidget* over) {
    const QString path = QFileDialog::getOpenFileName(over, tr("Open project"), startingPlace(),
                                                      tr("Tiller projects (*.tiller)"));
    if (!path.isEmpty()) {
        open(path);
    }
}

void ProjectFiles::askToSave(QWidget* over) {
    if (store_.path().isEmpty()) {
        QDir().mkpath(projectFolder());
    }
    const QString path = QFileDialog::getSaveFileName(over, tr("Save project"), startingPlace(),
                                                      tr("Tiller projects (*.tiller)"));
    if (!path.isEmpty()) {
        saveAs(path);
    }
}

void ProjectFiles::open(const QString& path) {
    const Result<void> opened = store_.openOrStart(path);
    if (opened) {
        return;
    }
    const Error& error = opened.error();
    if (error.code == ErrorCode::FileCorrupt) {
        Q_EMIT message(Severity::Error, texts::errorText(error));
        offerRecovery(path, error);
    } else {
        warn(tr("The project could not be opened"), error);
    }
}

void ProjectFiles::openCopy(const QString& path, const QString& name) {
    if (const Result<void> opened = store_.openCopy(path, name); !opened) {
        warn(tr("The project could not be opened"), opened.error());
        return;
    }
    Q_EMIT message(Severity::Info, tr("Opened a copy of “%1”. Save it to a file to keep changes.").arg(name));
}

bool ProjectFiles::mayLeave(QWidget* over) {
    if (!store_.isUnsavedCopy()) {
        return true;
    }
    QMessageBox question(QMessageBox::Question, tr("Save project"),
                         tr("“%1” is a copy and has changes that are in no file.").arg(store_.copyName()),
                         QMessageBox::NoButton, over);
    question.setObjectName(QStringLiteral("unsavedCopy"));
    QPushButton* save = question.addButton(tr("Save as…"), QMessageBox::AcceptRole);
    save->setObjectName(QStringLiteral("unsavedCopy.save"));
    QPushButton* drop = question.addButton(tr("Drop the changes"), QMessageBox::DestructiveRole);
    drop->setObjectName(QStringLiteral("unsavedCopy.drop"));
    QPushButton* stay = question.addButton(tr("Cancel"), QMessageBox::RejectRole);
    stay->setObjectName(QStringLiteral("unsavedCopy.stay"));
    question.setDefaultButton(save);
    question.setEscapeButton(stay);
    question.exec();
    if (question.clickedButton() == save) {
        askToSave(over);
        return !store_.isUnsavedCopy();
    }
    return question.clickedButton() == drop;
}

void ProjectFiles::offerRecovery(const QString& path, const Error& error) {
    const QString title = tr("%1 is damaged").arg(QFileInfo(path).fileName());
    const Result<project::RecoveredProject> found = project::recoverProject(path);
    if (!found || found->document.waypoints.isEmpty()) {
        Q_EMIT noticeWanted({title, error.context, {}, {}});
        return;
    }
    const int whole = found->document.waypoints.size();
    Q_EMIT noticeWanted({title,
                         tr("%1. Waypoints that can be read: %2, that cannot: %3. The damaged file is kept.")
                             .arg(error.context)
                             .arg(whole)
                             .arg(found->lostWaypoints),
                         tr("Open %n waypoints", nullptr, whole), [this, path] {
                             // What was open when the file was found damaged may have been changed since.
                             if (!mayLeave(QApplication::activeWindow())) {
                                 return;
                             }
                             if (const auto recovered = store_.openRecovered(path); !recovered) {
                                 warn(tr("The project could not be opened"), recovered.error());
                             }
                         }});
}

void ProjectFiles::saveAs(const QString& path) {
    const QString full = QFileInfo(path).suffix().isEmpty() ? path + QStringLiteral(".tiller") : path;
    if (const Result<void> saved = store_.saveAs(full); !saved) {
        warn(tr("The project could not be saved"), saved.error());
    }
}

}  // namespace tiller

#include "moc_project_files.cpp"
