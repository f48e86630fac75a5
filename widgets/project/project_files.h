// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Opens and saves projects interactively: prompts for the file, reports errors, and offers to load the
// readable part of a damaged file. Messages are added to the journal. The main window determines where
// notices are shown.

#include <QObject>

#include "robot/station/document/project_store.h"
#include "robot/station/journal/journal.h"
#include "widgets/common/notice_bar.h"

class QWidget;

namespace tiller {

class ProjectFiles : public QObject {
    Q_OBJECT

public:
    /// store, journal  must outlive this object
    ProjectFiles(ProjectStore& store, Journal& journal, QObject* parent = nullptr);

    /// Manages the project file: path, autosave, and the text for the status line.
    ProjectStore& store() { return store_; }

    /// over  parent window of the file dialog
    void askToOpen(QWidget* over);
    void askToSave(QWidget* over);
    void askForNew(QWidget* over);
    /// Starts an empty project for this file, after mayLeave(). The file is created when the project is
    /// saved. If the file exists, shows a message and does nothing.
    void startNew(const QString& path, QWidget* over);
    /// Opens the file. If it does not exist, starts an empty project with this file name. If the file is
    /// damaged, reports the error and offers to load the readable part.
    void open(const QString& path);
    /// Opens the content of the file as a project without a file, so that saving prompts for a file name.
    /// name  name of the copy until it is saved
    void openCopy(const QString& path, const QString& name);
    /// Offers to restore the newest unsaved project of a window that was closed or has crashed.
    void offerKept();
    /// Like mayLeave(), but also refuses with a message if the project must not be replaced now; see
    /// ProjectStore::setReplaceGuard(). Call this before every replacement.
    bool mayReplace(QWidget* over);
    /// The project may be replaced again, so the message of mayReplace() no longer applies.
    void endRefusal();
    /// Saves the project now. Asks for a name if the project has no file, and asks again what to do if
    /// another window has the file open or another program has changed it.
    void save(QWidget* over);
    /// Saves unsaved changes. If saving is not possible, asks whether to discard the changes.
    /// over  parent window of the question
    /// Returns  false if the user cancelled
    bool mayLeave(QWidget* over);
    /// path  file path; the extension .tiller is added if there is no extension
    void saveAs(const QString& path);

Q_SIGNALS:
    void noticeWanted(const tiller::Notice& notice);
    /// Notices with this cause no longer apply.
    void noticeResolved(const QString& cause);

private:
    void askAboutFile();
    bool refusesToReplace();
    void offerRecovery(const QString& path, const Error& error);
    void warn(const QString& title, const Error& error, const QString& cause);
    void onOpenElsewhere();
    void onChangedByOther();
    /// True if an answer about the file must wait because the project must not be replaced now.
    bool postponesAnswer();
    void takeOver();
    void reload();
    void keepBoth();
    static bool confirmsDiscard(const QString& name);
    /// Initial folder of the file dialogs: the folder of the current file, or the folder for projects.
    QString startingPlace() const;

    Journal& journal_;
    ProjectStore& store_;
    bool isAnswerPostponed_ = false;
};

/// The folder for new projects, "Tiller" in the user's documents folder. It may not exist yet.
QString projectFolder();

}  // namespace tiller
