// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What the pages of the tab "Tools" have in common: keys above, the list, the details of the selected row below, and a
// notice at the lower edge. A page may show something else in place of the list, such as teaching.

#include <QUuid>
#include <QWidget>
#include <functional>

#include "robot/station/link/robot_session.h"
#include "widgets/tools/part_model.h"

class QAction;
class QHBoxLayout;
class QMenu;
class QPushButton;
class QStackedWidget;
class QUndoStack;

namespace tiller {

class NoticeBar;
class RowTable;

class PartPage : public QWidget {
    Q_OBJECT

public:
    /// Row of the selected one; -1 for none.
    int currentRow() const;
    void selectRow(int row);
    /// Every action, for menus, the command palette and the help.
    QList<QAction*> commandActions() const { return actions_; }

Q_SIGNALS:
    /// Something the operator should be able to read again later.
    void message(tiller::Severity severity, const QString& text);
    /// A command was given that goes on in this page.
    void frontWanted();

protected:
    /// name     "tcp": its parts are the objects tcp.table, tcp.more ...
    /// empty    what to do when there is none
    /// details  below the list
    PartPage(const QString& name, const QString& title, PartModel* model, const QString& empty,
             QWidget* details, QWidget* parent);
    ~PartPage() override;

    QPushButton* addKey(const QString& name, const QString& text, const QString& spoken, int stretch,
                        std::function<void()> run);
    /// needsRow  greyed while nothing is selected
    QAction* addCommand(const QString& name, const QString& text, bool needsRow, std::function<void()> run);
    QMenu* menu() { return menu_; }
    /// In place of keys, list and details; null: those again.
    void showInstead(QWidget* widget);
    PartModel& model() { return *model_; }
    RowTable& table() { return *table_; }
    NoticeBar& notice() { return *notice_; }
    QWidget& details() { return *details_; }
    void showProblem(const QString& text);
    /// The list is another one.
    void followList();
    /// The details say something without a row, too.
    void keepDetails() { detailsAlways_ = true; }

    /// Another row, or none, is selected, or its figures are others.
    virtual void onSelection() = 0;

private:
    QString name_;
    PartModel* model_;
    QList<QAction*> actions_;
    QWidget* usual_;
    QHBoxLayout* keys_;
    QPushButton* more_;
    QMenu* menu_;
    QStackedWidget* pages_;
    RowTable* table_;
    QWidget* details_;
    NoticeBar* notice_;
    QWidget* instead_ = nullptr;
    bool detailsAlways_ = false;
};

}  // namespace tiller
