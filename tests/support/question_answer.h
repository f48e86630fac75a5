// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QApplication>
#include <QMessageBox>
#include <QPushButton>
#include <QTest>
#include <QTimer>

namespace tiller::test {

/// Clicks a button of the next modal question, which otherwise blocks its caller until a user answers.
class QuestionAnswer {
public:
    /// button  object name; a question without this button is rejected
    explicit QuestionAnswer(const char* button) {
        timer_.setInterval(20);
        QObject::connect(&timer_, &QTimer::timeout, &timer_, [this, button] {
            auto* question = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
            if (question == nullptr) {
                return;
            }
            asked_ = true;
            timer_.stop();
            if (auto* found = question->findChild<QPushButton*>(QLatin1String(button))) {
                QTest::mouseClick(found, Qt::LeftButton);
            } else {
                question->reject();
            }
        });
        timer_.start();
    }
    bool wasAsked() const { return asked_; }

private:
    QTimer timer_;
    bool asked_ = false;
};

}  // namespace tiller::test
