// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Everything the window can do, once: name, menu, shortcut, one sentence of help, and why it cannot be done
// now. Menus, shortcuts, the command palette, the settings of the shortcuts and the help page are all made
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
    QString id;    ///< "power.on"; the part before the dot names its menu
    QString text;  ///< "Power on"
    QString help;  ///< one sentence
    QKeySequence shortcut = {};
    std::function<void()> run;
    /// Why it cannot be done now; empty when it can. Null: always possible.
    std::function<QString(const SessionState&)> obstacle = {};
};

/// The action's text without the mark of its menu key.
QString plain(const QAction& action);

/// The menus in their order: id and title.
QList<QPair<QString, QString>> actionMenus();

class ActionTable : public QObject {
    Q_OBJECT

public:
    /// owner  gets the shortcuts
    explicit ActionTable(QWidget& owner);

    QAction* add(ActionSpec spec);
    /// An action that lives elsewhere (a tab's own) and is listed here with the others.
    void adopt(const QString& menu, QAction* action);
    /// An action of add() that is not possible any more; it is deleted.
    void remove(QAction* action);

    const QList<QAction*>& all() const { return actions_; }
    QList<QAction*> inMenu(const QString& menu) const;
    QAction* find(const QString& id) const;
    static QString menuOf(const QAction& action);
    static QString helpOf(const QAction& action);
    /// Why the action cannot be done now, empty when it can.
    static QString obstacleOf(const QAction& action);
    /// True when one key could mean both: not when each hears its key only in a tab of its own.
    static bool share(const QAction& a, const QAction& b);
    /// The key it has as long as the operator chose no other.
    static QKeySequence builtInShortcut(const QAction& action);
    /// Gives every action its built-in key, or that of the map.
    void setShortcuts(const QMap<QString, QKeySequence>& chosen);

    /// A table of all actions for people, as rich text.
    QString helpText() const;

public Q_SLOTS:
    void applyState(const tiller::SessionState& state);

protected:
    /// Where the keyboard writes no Latin letters, a shortcut with a letter is meant by the place of its key.
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
    QMap<QString, QKeySequence> chosen_;  ///< the keys of the operator, also for what is added later
};

}  // namespace tiller::app
