// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A figure to be typed, with its unit behind it. The wheel never changes it, point and
// comma both are the decimal sign, and it is told of only when it is finished: by Return, or when the focus goes on.
// Whatever is typed stands as it was typed; what is outside the range is refused, with the range, and changes nothing. Esc brings the last
// figure back. A minus is shown as in all figures, and copied as spreadsheets and scripts read it.

#include <QDoubleSpinBox>

namespace tiller {

class FigureBox : public QDoubleSpinBox {
    Q_OBJECT

public:
    explicit FigureBox(QWidget* parent = nullptr);

    /// Whether the text that stands in it is no figure it takes; value() is still the one before.
    bool isRefused() const;
    /// Says so, with the range, beside the box.
    void explainRefusal();

    QValidator::State validate(QString& text, int& position) const override;
    double valueFromText(const QString& text) const override;
    /// With the minus that all figures of the window have, and the decimal sign of its language.
    QString textFromValue(double value) const override;

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;

private:
    /// Without the unit, as a number is read: with a hyphen for the minus and a point.
    QString bare(QString text) const;
    bool copies(const QKeyEvent& event);
    void restore();
};

}  // namespace tiller
