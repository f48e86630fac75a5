// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/practice/first_steps_card.h"

#include <QHBoxLayout>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

#include "widgets/practice/checklist_item.h"

namespace tiller {

FirstStepsCard::FirstStepsCard(FirstSteps& steps, QWidget& view)
    : ViewCard(QStringLiteral("firstSteps"), tr("First steps"), 0, view), steps_(steps) {
    for (const FirstStep step : kFirstSteps) {
        auto* line = new ChecklistItem(FirstSteps::text(step), this);
        line->setObjectName(QStringLiteral("firstSteps.%1").arg(static_cast<int>(step)));
        content().addWidget(line);
        lines_[static_cast<std::size_t>(step)] = line;
    }
    content().addStretch(1);
    auto* practice = new QPushButton(tr("Practice tasks"), this);
    practice->setObjectName(QStringLiteral("firstSteps.practice"));
    auto* dismiss = new QPushButton(tr("Dismiss"), this);
    dismiss->setObjectName(QStringLiteral("firstSteps.dismiss"));
    dismiss->setToolTip(tr("The list will not appear again. Use the command “First steps” to reopen it."));
    for (QPushButton* key : {practice, dismiss}) {
        key->setFocusPolicy(Qt::TabFocus);
        keys().addWidget(key, 1);
    }
    connect(practice, &QPushButton::clicked, this, &FirstStepsCard::practiceRequested);
    connect(dismiss, &QPushButton::clicked, this, &FirstStepsCard::dismissed);
    connect(&steps_, &FirstSteps::changed, this, &FirstStepsCard::showSteps);
    showSteps();
}

void FirstStepsCard::showSteps() {
    const auto done = std::count_if(kFirstSteps.begin(), kFirstSteps.end(),
                                    [this](FirstStep step) { return steps_.isDone(step); });
    for (const FirstStep step : kFirstSteps) {
        lines_[static_cast<std::size_t>(step)]->setDone(steps_.isDone(step));
    }
    setTitle(tr("First steps · %1 of %2").arg(done).arg(kFirstSteps.size()));
}

}  // namespace tiller

#include "moc_first_steps_card.cpp"
