// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Controls for recorded paths: the button that starts and stops a recording and shows its duration, the
// tolerance menu, and export and import.

#include <QList>
#include <QWidget>
#include <functional>

#include "robot/station/route/path_recorder.h"

class QAction;
class QMenu;
class QPushButton;

namespace tiller {

class PathControls : public QWidget {
    Q_OBJECT

public:
    /// Access to the selection in the list.
    struct Selection {
        std::function<int()> currentRow;  ///< -1 for none
        std::function<QList<int>()> rows;
    };

    PathControls(RobotSession& session, ProjectDocument& document, Selection selection,
                 QWidget* parent = nullptr);

    PathRecorder& recorder() { return recorder_; }
    /// The actions Record, Export and Import, for the menus, the command list and the help page.
    QList<QAction*> actions() const { return actions_; }
    /// Menu for the maximum deviation of the simplified path from the recorded positions.
    QMenu* toleranceMenu() { return tolerances_; }
    void setState(const SessionState& state);
    /// "● REC 00:12" while a path is recorded, otherwise empty.
    QString recordingText() const;

    /// Called by the commands after a file was selected.
    void exportTo(const QString& path);
    void importFrom(const QString& path);

Q_SIGNALS:
    void kept(const QString& summary);
    void refused(const QString& reason, const QString& details);
    /// The sentence is for the log, e.g. after a file was written.
    void reported(const QString& sentence);

private:
    QAction* addAction(const QString& name, const QString& text, const std::function<void()>& run);
    void toggle();
    void show();
    void askForExport();
    void askForImport();

    Selection selection_;
    PathRecorder recorder_;
    QPushButton* record_;
    QMenu* tolerances_;
    QList<QAction*> actions_;
    bool live_ = false;
};

}  // namespace tiller
