// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Type a few letters, press Enter: every action of the table by its name. What cannot be done now is listed
// too, with the reason.

#include <QDialog>

class QAction;
class QLineEdit;
class QListWidget;

namespace tiller {
class NothingFound;
}

namespace tiller::app {

class ActionTable;

class CommandPalette : public QDialog {
    Q_OBJECT

public:
    explicit CommandPalette(const ActionTable& actions, QWidget* parent = nullptr);

    /// The actions listed now, best first.
    QList<QAction*> listed() const { return listed_; }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void list(const QString& words);
    void runCurrent();

    const ActionTable& actions_;
    QLineEdit* words_;
    QListWidget* list_;
    NothingFound* nothing_;
    QList<QAction*> listed_;
};

}  // namespace tiller::app
