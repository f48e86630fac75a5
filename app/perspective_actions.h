// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The commands for selecting, saving, renaming and deleting perspectives. They are in the perspective menu
// and in the menu of the button that shows the current perspective.

#include <QList>
#include <QObject>
#include <functional>

#include "app/perspectives.h"

class QAction;
class QActionGroup;
class QDialog;
class QMenu;
class QToolButton;

namespace tiller::app {

class ActionTable;

class PerspectiveActions : public QObject {
    Q_OBJECT

public:
    struct Hooks {
        /// Ends a hold-to-run motion before a dialog opens.
        std::function<void()> dialogOpens;
        /// Updates the enabled state of all actions.
        std::function<void()> refresh;
    };

    /// table, perspectives, window  must outlive the object
    /// window  parent of the dialogs
    PerspectiveActions(ActionTable& table, Perspectives& perspectives, Hooks hooks, QWidget& window);

    /// Adds the commands to the menu and keeps the menu up to date.
    void fill(QMenu& menu);
    /// Returns the button for the status bar, which its new parent deletes. Call this after fill().
    QToolButton* key();

private:
    void addCommands();
    void list();
    void showCurrent();
    void fillMenu();
    void askForName(const QString& title, const QString& proposal, const QString& except,
                    const std::function<void(const QString&)>& done);
    void askToDelete();
    QString ownOnly(const QString& what) const;

    ActionTable& table_;
    Perspectives& perspectives_;
    Hooks hooks_;
    QWidget& window_;
    QActionGroup* group_;
    QMenu* menu_ = nullptr;
    QToolButton* key_ = nullptr;
    QList<QAction*> choices_;
    QList<Perspectives::Entry> listed_;
};

}  // namespace tiller::app
