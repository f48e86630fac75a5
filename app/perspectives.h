// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Named arrangements of the panels: three that are built in, and those the operator saves. Choosing one always
// gives it as it was saved; what was changed since is kept until the next choice, also over a restart. None of
// them reaches header, jog column and status line.

#include <QKeySequence>
#include <QObject>
#include <QString>
#include <functional>

#include "app/settings.h"
#include "robot/control/motion_types.h"
#include "robot/station/link/robot_session.h"

namespace tiller::app {

class DockStage;

class Perspectives : public QObject {
    Q_OBJECT

public:
    struct Hooks {
        /// Ends whatever is held.
        std::function<void(control::StopCause)> stop;
        std::function<void(const QString&)> showTab;
        std::function<QString()> tab;  ///< the one in front
    };
    struct Entry {
        QString id;  ///< "teach", or "saved.3"
        QString name;
        QString help;           ///< one sentence
        QKeySequence shortcut;  ///< of those that are built in
        bool builtIn = true;

        bool operator==(const Entry&) const = default;
    };

    /// stage     with all its panels: shows the first perspective
    /// settings  must outlive this
    Perspectives(DockStage& stage, Settings& settings, Hooks hooks, QObject* parent = nullptr);

    /// Those that are built in, then the operator's in the order of saving.
    QList<Entry> all() const;
    Entry current() const;
    bool isChanged() const { return changed_; }

    /// Ends what is held and shows the perspective as it was saved, also when it is the current one.
    void choose(const QString& id);
    void reset() { choose(current_); }

    /// Why a perspective cannot have this name, as a sentence; empty when it can.
    /// except  id of the one that gets a new name
    QString obstacle(const QString& name, const QString& except = {}) const;
    /// The panels as they stand now, under a name that has no obstacle. It is the current one then.
    void saveAs(const QString& name);
    /// The same into the current one. Only for one of the operator's own.
    void save();
    /// Only for one of the operator's own.
    void rename(const QString& id, const QString& name);
    void remove(const QString& id);

    /// As the window was left last. To be called once, when it is shown.
    void restoreLast();
    /// The settings hold others now: those of another computer.
    void readAgain();
    /// Remembers how the window is left.
    /// jogWidth  of the jog column [px]
    void keep(int jogWidth);

Q_SIGNALS:
    /// There are others, or one has another name.
    void listChanged();
    /// Another one is chosen.
    void currentChanged();
    void message(tiller::Severity severity, const QString& text);

private:
    bool bring(const QString& id);
    void fallBack(const QString& why);
    SavedPerspective* savedOf(const QString& id);
    bool isKnown(const QString& id) const;
    void write();

    DockStage& stage_;
    Settings& settings_;
    Hooks hooks_;
    QVector<SavedPerspective> saved_;
    QString current_;
    bool changed_ = false;
};

}  // namespace tiller::app
