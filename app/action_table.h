// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Table of all actions of the window: name, menu, shortcut, a help sentence, and the reason why an action is
// disabled. The menus, the shortcuts, the command list, the shortcut settings and the help page are generated
// from this table.

#include <QAction>
#include <QKeySequence>
#include <QMap>
#include <QObject>
#include <functional>
#include <vector>

#include "robot/station/link/session_state.h"

namespace tiller::app {

struct ActionSpec {
    QString id;    ///< e.g. "power.on"; the part before the dot is the menu ID
    QString text;  ///< e.g. "Power on"
    QString help;  ///< one sentence
    QKeySequence shortcut = {};
    std::function<void()> run;
    /// Returns the reason why the action is disabled; empty if it is enabled. If null, the action is always
    /// enabled.
    std::function<QString(const SessionState&)> obstacle = {};
};

/// Returns the text of the action without its mnemonic.
QString plain(const QAction& action);

/// Ids and titles of the menus, in order.
QList<QPair<QString, QString>> actionMenus();

class ActionTable : public QObject {
    Q_OBJECT

public:
    /// owner  receives the shortcuts
    explicit ActionTable(QWidget& owner);

    QAction* add(ActionSpec spec);
    /// Adds an existing action, e.g. of a tab, to the table.
    void adopt(const QString& menu, QAction* action);
    /// Deletes an action created by add().
    void remove(QAction* action);

    const QList<QAction*>& all() const { return actions_; }
    QList<QAction*> inMenu(const QString& menu) const;
    QAction* find(const QString& id) const;
    static QString menuOf(const QAction& action);
    static QString helpOf(const QAction& action);
    /// Returns the reason why the action is disabled; empty if it is enabled.
    static QString obstacleOf(const QAction& action);
    /// True if the actions would conflict with the same shortcut. False if their shortcuts are limited to
    /// different tabs.
    static bool share(const QAction& a, const QAction& b);
    static QKeySequence builtInShortcut(const QAction& action);
    /// Assigns to each action its shortcut in the map. Actions that are not in the map get their default
    /// shortcut.
    void setShortcuts(const QMap<QString, QKeySequence>& chosen);

    /// Returns a table of all actions as rich text, for the help page.
    QString helpText() const;

public Q_SLOTS:
    void applyState(const tiller::SessionState& state);

protected:
    /// Handles shortcuts on keyboards without Latin letters. A letter in a shortcut then refers to the
    /// position of the key on a US keyboard.
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QAction* heardAt(const QWidget& focus, const QKeySequence& keys) const;

    struct Rule {
        QAction* action;
        std::function<QString(const SessionState&)> obstacle;
    };

    QWidget& owner_;
    QList<QAction*> actions_;
    std::vector<Rule> rules_;
    /// Shortcuts selected by the user. They also apply to actions added later.
    QMap<QString, QKeySequence> chosen_;
};

}  // namespace tiller::app
