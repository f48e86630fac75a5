// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Edits the actions at one or several waypoints: a list in execution order and the parameters of the selected
// action. The dialog does not execute actions.

#include <QDialog>
#include <functional>
#include <vector>

#include "robot/project/waypoint_list.h"

class QLabel;
class QListWidget;
class QPushButton;

namespace tiller {

class ChoiceBox;
class DecimalSpinBox;

class ActionsDialog : public QDialog {
    Q_OBJECT

public:
    /// waypoints  at least one; the dialog initially shows the actions of the first
    explicit ActionsDialog(const std::vector<project::Waypoint>& waypoints, QWidget* parent = nullptr);

    /// The edited actions, which apply to each of the waypoints.
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
    bool filling_ = false;  ///< true while the code updates the fields
    QListWidget* list_;
    QPushButton* remove_ = nullptr;
    QPushButton* up_ = nullptr;
    QPushButton* down_ = nullptr;
    ChoiceBox* kind_;
    ChoiceBox* pin_;
    ChoiceBox* value_;
    DecimalSpinBox* seconds_;
    QLabel* kindText_;
    QLabel* pinText_;
    QLabel* valueText_;
    QLabel* secondsText_;
};

}  // namespace tiller
