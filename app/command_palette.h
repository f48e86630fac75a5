// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Finds actions of the table by a few letters of their name. Enter runs the selected action. Disabled actions
// are listed together with the reason.

#include <QDialog>

class QAction;
class QLineEdit;
class QListWidget;

namespace tiller {
class EmptyState;
}

namespace tiller::app {

class ActionTable;

class CommandPalette : public QDialog {
    Q_OBJECT

public:
    explicit CommandPalette(const ActionTable& actions, QWidget* parent = nullptr);

    /// The listed actions, best match first.
    QList<QAction*> listed() const { return listed_; }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void list(const QString& words);
    void runCurrent();

    const ActionTable& actions_;
    QLineEdit* words_;
    QListWidget* list_;
    EmptyState* nothing_;
    QList<QAction*> listed_;
};

}  // namespace tiller::app
