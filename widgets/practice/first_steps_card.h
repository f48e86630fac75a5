// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The checklist of the first steps. It does not block other input.

#include <array>

#include "robot/station/practice/first_steps.h"
#include "widgets/practice/view_card.h"

namespace tiller {

class ChecklistItem;

class FirstStepsCard : public ViewCard {
    Q_OBJECT

public:
    /// steps, view  must outlive the object
    FirstStepsCard(FirstSteps& steps, QWidget& view);

Q_SIGNALS:
    void practiceRequested();
    void dismissed();

private:
    void showSteps();

    FirstSteps& steps_;
    std::array<ChecklistItem*, kFirstSteps.size()> lines_{};
};

}  // namespace tiller
