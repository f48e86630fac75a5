// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Shows one practice task at a time: instruction, Start button, text of the check, and Done button.

#include "widgets/practice/view_card.h"

class QLabel;
class QLineEdit;
class QPushButton;

namespace tiller {

class Practice;
class ChecklistItem;

class PracticeCard : public ViewCard {
    Q_OBJECT

public:
    /// practice, view  must outlive the object
    PracticeCard(Practice& practice, QWidget& view);

private:
    void showTask();
    void readAnswer();

    Practice& practice_;
    QLabel* name_;
    QLabel* text_;
    QWidget* answerRow_;
    QLineEdit* answer_;
    ChecklistItem* check_;
    QPushButton* start_;
    QPushButton* done_;
    int task_ = -1;
};

}  // namespace tiller
