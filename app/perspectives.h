// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Named arrangements of the panels: three built-in arrangements and those saved by the user. Selecting a
// perspective always restores its saved state. Later changes are kept until the next selection, even after a
// restart. Header, jog column and status bar are not affected.

#include <QKeySequence>
#include <QObject>
#include <QString>
#include <functional>

#include "app/settings.h"
#include "robot/control/motion_types.h"
#include "robot/station/journal/journal.h"

namespace tiller::app {

class DockStage;

class Perspectives : public QObject {
    Q_OBJECT

public:
    struct Hooks {
        /// Ends a hold-to-run motion.
        std::function<void(control::StopCause)> stop;
        std::function<void(const QString&)> showTab;
        std::function<QString()> tab;  ///< returns the name of the current tab
    };
    struct Entry {
        QString id;  ///< e.g. "teach" or "saved.3"
        QString name;
        QString help;           ///< one sentence
        QKeySequence shortcut;  ///< built-in perspectives only
        bool builtIn = true;

        bool operator==(const Entry&) const = default;
    };

    /// Shows the first perspective.
    /// stage     contains all panels
    /// settings  must outlive the object
    Perspectives(DockStage& stage, Settings& settings, Journal& journal, Hooks hooks,
                 QObject* parent = nullptr);

    /// The built-in perspectives, followed by those of the user in the order of saving.
    QList<Entry> all() const;
    Entry current() const;
    bool isChanged() const { return changed_; }

    /// Ends a hold-to-run motion and restores the saved state of the perspective, even if it is the current
    /// perspective.
    void choose(const QString& id);
    void reset() { choose(current_); }

    /// Returns the reason why a perspective cannot have this name, as a sentence; empty if the name is valid.
    /// except  ID of the perspective to be renamed
    QString obstacle(const QString& name, const QString& except = {}) const;
    /// Saves the current arrangement under this name, which must be valid, and makes it the current
    /// perspective.
    void saveAs(const QString& name);
    /// Saves the current arrangement in the current perspective, which must not be built-in.
    void save();
    /// Renames a perspective of the user. Built-in perspectives cannot be renamed.
    void rename(const QString& id, const QString& name);
    void remove(const QString& id);

    /// Restores the last arrangement. Call this once, when the window is shown.
    void restoreLast();
    /// Restores the panel sizes of a last arrangement that was changed by the user. Call this when the window
    /// gets its size shortly after it was shown.
    void restoreSizes();
    /// Reloads the perspectives after an import of settings.
    void readAgain();
    /// Saves the arrangement, e.g. when the window closes.
    /// jogWidth  width of the jog column [px]
    void keep(int jogWidth);

Q_SIGNALS:
    /// A perspective was added, removed or renamed.
    void listChanged();
    /// A perspective was selected, saved under a new name, or restored.
    void currentChanged();

private:
    bool bring(const QString& id);
    void fallBack(const QString& why);
    SavedPerspective* savedOf(const QString& id);
    bool isKnown(const QString& id) const;
    void write();

    DockStage& stage_;
    Settings& settings_;
    Journal& journal_;
    Hooks hooks_;
    QVector<SavedPerspective> saved_;
    QString current_;
    bool changed_ = false;
};

}  // namespace tiller::app
