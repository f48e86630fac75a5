// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/practice/practice_card.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>
#include <cmath>

#include "robot/station/practice/practice.h"
#include "widgets/common/theme.h"
#include "widgets/practice/checklist_item.h"

namespace tiller {
namespace {

constexpr int kHeight = 370;  // height that fits the longest task with its check [px]

}  // namespace

PracticeCard::PracticeCard(Practice& practice, QWidget& view)
    : ViewCard(QStringLiteral("practice"), tr("Practice"), kHeight, view)
    , practice_(practice)
    , name_(new QLabel)
    , text_(new QLabel)
    , answerRow_(new QWidget)
    , answer_(new QLineEdit)
    , check_(new ChecklistItem({}))
    , start_(new QPushButton(tr("Start")))
    , done_(new QPushButton(tr("Done"))) {
    name_->setObjectName(QStringLiteral("practice.name"));
    name_->setProperty("role", QStringLiteral("strong"));
    name_->setWordWrap(true);
    text_->setObjectName(QStringLiteral("practice.what"));
    text_->setWordWrap(true);
    check_->setObjectName(QStringLiteral("practice.check"));
    check_->reserveLines(3);

    answer_->setObjectName(QStringLiteral("practice.answer"));
    answer_->setAccessibleName(tr("Force Fz in newtons"));
    answer_->setMaxLength(12);
    answer_->setPlaceholderText(tr("Enter a value and press Return"));
    auto* unit = new QLabel(tr("Fz [N]"));
    auto* answer = new QHBoxLayout(answerRow_);
    answer->setContentsMargins(0, 0, 0, 0);
    answer->addWidget(unit);
    answer->addWidget(answer_, 1);

    content().addWidget(name_);
    content().addWidget(text_);
    content().addStretch(1);
    addAboveKeys(answerRow_);
    addAboveKeys(check_);

    const auto turnKey = [this](const char* name, const QString& sign, const QString& text, int by) {
        auto* key = new QPushButton(sign, this);
        key->setObjectName(QLatin1String(name));
        key->setAccessibleName(text);
        key->setToolTip(text);
        key->setFocusPolicy(Qt::TabFocus);
        connect(key, &QPushButton::clicked, this, [this, by] { practice_.turn(by); });
        return key;
    };
    start_->setObjectName(QStringLiteral("practice.start"));
    done_->setObjectName(QStringLiteral("practice.done"));
    done_->setProperty("primary", true);
    keys().addWidget(turnKey("practice.back", QStringLiteral("‹"), tr("Previous task"), -1));
    keys().addWidget(turnKey("practice.next", QStringLiteral("›"), tr("Next task"), 1));
    keys().addWidget(start_, 1);
    keys().addWidget(done_, 1);
    for (QPushButton* key : {start_, done_}) {
        key->setFocusPolicy(Qt::TabFocus);
    }
    connect(start_, &QPushButton::clicked, this, [this] {
        answer_->clear();
        practice_.start();
    });
    connect(done_, &QPushButton::clicked, &practice_, &Practice::finish);
    connect(answer_, &QLineEdit::editingFinished, this, &PracticeCard::readAnswer);
    connect(&practice_, &Practice::changed, this, &PracticeCard::showTask);
    showTask();
}

void PracticeCard::readAnswer() {
    QString typed = answer_->text().trimmed();
    typed.replace(QLatin1Char(','), QLatin1Char('.')).replace(QChar(0x2212), QLatin1Char('-'));
    bool ok = false;
    const double figure = typed.toDouble(&ok);
    // toDouble() also accepts "nan" and "inf", so require a finite value.
    practice_.setAnswer(ok && std::isfinite(figure) ? std::optional(figure) : std::nullopt);
}

void PracticeCard::showTask() {
    const PracticeTask task = practice_.task();
    if (task_ != static_cast<int>(task)) {
        task_ = static_cast<int>(task);
        answer_->clear();
        name_->setText(practiceTitle(task));
        setUsable(*answer_, false);
        answerRow_->setVisible(task == PracticeTask::Measure);
        setTitle(tr("Practice · %1 of %2").arg(task_ + 1).arg(kPracticeTasks.size()));
    }
    // Update the texts every time, because the units in them may have changed.
    text_->setText(practiceText(task));
    check_->setText(practice_.text());
    check_->setDone(practice_.passed() || (!practice_.isRunning() && practice_.isDone(task)));
    const QString why = practice_.obstacle();
    setUsable(*start_, why.isEmpty());
    start_->setToolTip(why.isEmpty() ? tr("Starts or restarts the task") : why);
    setUsable(*done_, practice_.passed());
    done_->setToolTip(practice_.passed() ? tr("Continues with the next task")
                                         : tr("Available after the check above has passed"));
    setUsable(*answer_, practice_.isRunning());
}

}  // namespace tiller

#include "moc_practice_card.cpp"
