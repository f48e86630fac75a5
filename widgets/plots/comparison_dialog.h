// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Dialog in which the user selects the model and the limits for comparing a recording with the model of its
// arm.

#include <QDialog>
#include <optional>

#include "robot/divergence/divergence.h"

class QPushButton;

namespace tiller {

class ChoiceBox;
class DecimalSpinBox;

class ComparisonDialog : public QDialog {
    Q_OBJECT

public:
    /// model  initial selection; empty if the user must select a model
    ComparisonDialog(const divergence::Limits& limits, std::optional<RobotModelId> model,
                     QWidget* parent = nullptr);

    divergence::Limits limits() const;
    std::optional<RobotModelId> model() const;

    void accept() override;

private:
    DecimalSpinBox* box(const char* name, const QString& text, const QString& unit, double value,
                        double most);

    ChoiceBox* model_;
    DecimalSpinBox* joint_;
    DecimalSpinBox* tcp_;
    DecimalSpinBox* current_;
    DecimalSpinBox* force_;
    DecimalSpinBox* lasting_;
    QPushButton* compare_;
};

}  // namespace tiller
