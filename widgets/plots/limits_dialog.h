// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Asks for the limits of the value axes of a plot.

#include <QDialog>
#include <optional>
#include <vector>

#include "widgets/plots/plot_layout.h"

class QCheckBox;
class QLabel;
class QLineEdit;

namespace tiller {

class LimitsDialog : public QDialog {
    Q_OBJECT

public:
    struct Axis {
        QString title;
        std::optional<ValueLimits> limits;
        ValueLimits shown;  ///< current scale, suggested as limits
    };
    explicit LimitsDialog(const std::vector<Axis>& axes, QWidget* parent = nullptr);

    /// Limits of each axis; empty: the scale follows the curves.
    std::vector<std::optional<ValueLimits>> limits() const;

    void accept() override;

private:
    struct Row {
        QString title;
        QCheckBox* fixed;
        QLineEdit* low;
        QLineEdit* high;
    };
    static std::optional<ValueLimits> limitsOf(const Row& row);

    std::vector<Row> rows_;
    QLabel* problem_;
};

}  // namespace tiller
