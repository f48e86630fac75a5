// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Opening and saving for people: asks which file, says what is wrong with one, and offers what can be read of
// a damaged one. Where the words appear is the window's affair.

#include <QObject>

#include "robot/station/document/project_store.h"
#include "robot/station/link/robot_session.h"
#include "widgets/common/notice_bar.h"

class QWidget;

namespace tiller {

class ProjectDocument;

class ProjectFiles : public QObject {
    Q_OBJECT

public:
    /// document  must outlive this object
    explicit ProjectFiles(ProjectDocument& document, QObject* parent = nullptr);

    /// The file behind the project: which one, autosave, and what the status line says about it.
    ProjectStore& store() { return store_; }

    /// over  the window the question stands in front of
    void askToOpen(QWidget* over);
    void askToSave(QWidget* over);
    /// Opens the file; where there is none yet, an empty project that will be saved there. A damaged file is
    /// named with its fault, and what can be read of it is offered.
    void open(const QString& path);
    /// Opens what is in the file as a project without a file; saving asks for one.
    /// name  what the copy is called until then
    void openCopy(const QString& path, const QString& name);
    /// Offers the newest work that a window which has ended left behind unsaved.
    void offerKept();
    /// Saves what is not saved yet; where that is not possible, asks what becomes of it.
    /// over  the window the question stands in front of
    /// Returns  false when the operator wants to stay
    bool mayLeave(QWidget* over);
    /// path  gets the extension .tiller where it has none
    void saveAs(const QString& path);

Q_SIGNALS:
    void noticeWanted(const tiller::Notice& notice);
    /// Notices with this cause are no longer true.
    void noticeResolved(const QString& cause);
    /// Something the operator should be able to read again later.
    void message(tiller::Severity severity, const QString& text);

private:
    void offerRecovery(const QString& path, const Error& error);
    void warn(const QString& title, const Error& error, const QString& cause);
    void onOpenElsewhere();
    void onChangedByOther();
    void takeOver();
    void reload();
    void keepBoth();
    /// Where the questions begin: the open file, or the folder for projects.
    QString startingPlace() const;

    ProjectStore store_;
};

/// The folder a new project goes to: "Tiller" in the user's documents. It need not exist yet.
QString projectFolder();

}  // namespace tiller
