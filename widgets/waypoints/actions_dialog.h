// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What is done at one or several waypoints once the arm has come there: a list of actions in their order, and what
// the chosen one does. Nothing is done here.

#include <QDialog>
#include <functional>
#include <vector>

#include "robot/project/waypoint_list.h"

class QLabel;
class QListWidget;
class QPushButton;

namespace tiller {

class ChoiceBox;
class FigureBox;

class ActionsDialog : public QDialog {
    Q_OBJECT

public:
    /// waypoints  at least one; it begins with what is done at the first
    explicit ActionsDialog(const std::vector<project::Waypoint>& waypoints, QWidget* parent = nullptr);

    /// As they are to be, at each of them.
    const project::WaypointActions& actions() const { return actions_; }

    void accept() override;

private:
    QWidget* buildKeys();
    QWidget* buildFields();
    QPushButton* addKey(const char* name, const QString& text, const QString& toolTip,
                        const std::function<void()>& pressed);
    void add();
    void remove();
    void move(int by);
    void change();
    void listPins();
    void show(int current);
    void refresh();

    project::WaypointActions actions_;
    bool filling_ = false;  ///< the fields follow the list, not the hand
    QListWidget* list_;
    QPushButton* remove_ = nullptr;
    QPushButton* up_ = nullptr;
    QPushButton* down_ = nullptr;
    ChoiceBox* kind_;
    ChoiceBox* pin_;
    ChoiceBox* value_;
    FigureBox* seconds_;
    QLabel* kindText_;
    QLabel* pinText_;
    QLabel* valueText_;
    QLabel* secondsText_;
};

}  // namespace tiller
