// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Base class of the pages of the tab "Tools": buttons at the top, the list, the details of the selected row
// below the list, and a notice at the bottom. A page may replace the list, e.g. for teaching.

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
    /// Index of the selected row; -1 if there is none.
    int currentRow() const;
    /// The entry in the current row, or null. While a project is being opened, the rows may be those of the
    /// previous project.
    template <class List>
    auto currentIn(const List& list) const -> decltype(&list.at(0)) {
        const int row = currentRow();
        return row < 0 || static_cast<std::size_t>(row) >= list.size()
                   ? nullptr
                   : &list.at(static_cast<std::size_t>(row));
    }
    void selectRow(int row);
    /// All actions, for the menus, the command list and the help page.
    QList<QAction*> commandActions() const { return actions_; }

Q_SIGNALS:
    /// A command needs this page to be visible.
    void frontWanted();

protected:
    /// name     prefix of the object names, e.g. "tcp" for tcp.table, tcp.more
    /// empty    suggested action for an empty list
    /// details  widget below the list
    PartPage(const QString& name, const QString& title, PartModel* model, const QString& empty,
             QWidget* details, QWidget* parent);
    ~PartPage() override;

    QPushButton* addKey(const QString& name, const QString& text, const QString& spoken, int stretch,
                        std::function<void()> run);
    /// needsRow  if true, the command is disabled without a selection
    QAction* addCommand(const QString& name, const QString& text, bool needsRow, std::function<void()> run);
    QMenu* menu() { return menu_; }
    /// Shows the widget in place of the buttons, the list and the details. Null restores them.
    void showInstead(QWidget* widget);
    PartModel& model() { return *model_; }
    RowTable& table() { return *table_; }
    NoticeBar& notice() { return *notice_; }
    QWidget& details() { return *details_; }
    void showProblem(const QString& text);
    /// Updates the page. Call this after a change of the list.
    void followList();
    /// Shows the details even without a selection.
    void keepDetails() { detailsAlways_ = true; }

    /// Called after the selection or the values of the selected object have changed.
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
