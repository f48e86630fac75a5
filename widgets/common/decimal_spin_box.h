// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Input field for a number with a unit. The mouse wheel does not change the value. Both point and comma are
// accepted as decimal separators. The value is reported only when editing is finished by Return or a change
// of focus. The entered text remains as typed. A value outside the range is refused with a message, and the
// field is marked until its text is valid. Esc restores the last value. The minus sign is displayed
// typographically and copied as a hyphen for spreadsheets and scripts. After Return, undo and redo apply to
// the project.

#include <QDoubleSpinBox>

namespace tiller {

class DecimalSpinBox : public QDoubleSpinBox {
    Q_OBJECT

public:
    explicit DecimalSpinBox(QWidget* parent = nullptr);

    /// True if the text is not a valid value. In this case, value() returns the previous value.
    bool isRefused() const;
    /// Shows the error with the valid range next to the box.
    void explainRefusal();

    QValidator::State validate(QString& text, int& position) const override;
    double valueFromText(const QString& text) const override;
    /// Uses the typographic minus sign and the decimal separator of the language.
    QString textFromValue(double value) const override;

protected:
    bool event(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;

private:
    QString withoutUnit(QString text) const;
    bool copies(const QKeyEvent& event);
    void restore();
    void followText();

    QString ownToolTip_;  ///< tooltip without the explanation of a refused value
};

}  // namespace tiller
