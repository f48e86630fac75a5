// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The hatched label that indicates a simulated robot.

#include <QWidget>

namespace tiller {

class SimulationChip : public QWidget {
    Q_OBJECT

public:
    explicit SimulationChip(QWidget* parent = nullptr);

    QSize sizeHint() const override { return {145, 34}; }
    QSize minimumSizeHint() const override { return {112, 34}; }

protected:
    void paintEvent(QPaintEvent* event) override;
};

}  // namespace tiller
