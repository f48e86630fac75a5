// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Asks for name, unit, scale, offset, colour, line style and axis of a curve.

#include <QColor>
#include <QDialog>
#include <functional>

#include "robot/station/history/scaled_signal.h"
#include "widgets/plots/plot_layout.h"

class QLabel;
class QLineEdit;
class QPushButton;

namespace tiller {

class ChoiceBox;

class CurveDialog : public QDialog {
    Q_OBJECT

public:
    struct Choice {
        ScaledSignal signal;
        CurveStyle style;
    };
    /// automatic  colour of the curve if the user does not select a colour
    /// apply      applies the choice; returns the error as a sentence, or an empty text
    CurveDialog(const Choice& choice, const QColor& automatic, std::function<QString(const Choice&)> apply,
                QWidget* parent = nullptr);

    void accept() override;

private:
    void chooseColor();
    void showColor();
    QString refusal(Choice& choice) const;

    Choice choice_;
    QColor automatic_;
    std::function<QString(const Choice&)> apply_;
    QLineEdit* name_;
    QLineEdit* unit_;
    QLineEdit* scale_;
    QLineEdit* offset_;
    QPushButton* color_;
    QPushButton* usual_;
    ChoiceBox* line_;
    ChoiceBox* axis_;
    QLabel* problem_;
};

}  // namespace tiller
