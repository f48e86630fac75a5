// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The checklist of the first five minutes. It asks nothing and blocks nothing.

#include <array>

#include "widgets/practice/first_steps.h"
#include "widgets/practice/view_card.h"

namespace tiller {

class TickLine;

class FirstStepsCard : public ViewCard {
    Q_OBJECT

public:
    /// steps, view  must outlive it
    FirstStepsCard(FirstSteps& steps, QWidget& view);

Q_SIGNALS:
    void practiceRequested();
    /// The operator does not want to see it again.
    void dismissed();

private:
    void showSteps();

    FirstSteps& steps_;
    std::array<TickLine*, kFirstSteps.size()> lines_{};
};

}  // namespace tiller
