// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A figure to be typed, with its unit behind it. The wheel never changes it, a comma is a decimal point, and
// it is told of only when it is finished: by Enter, or when the focus goes on.

#include <QDoubleSpinBox>

namespace tiller {

class FigureBox : public QDoubleSpinBox {
    Q_OBJECT

public:
    explicit FigureBox(QWidget* parent = nullptr);

    QValidator::State validate(QString& text, int& position) const override;

protected:
    void wheelEvent(QWheelEvent* event) override;
};

}  // namespace tiller
