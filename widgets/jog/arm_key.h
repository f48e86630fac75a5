// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The button in the title bar of the jog column that arms and disarms the keyboard. While the keyboard is
// armed, the button has the same colour as the frame around the window. The button does not move the arm.

#include <QAbstractButton>

namespace tiller {

class ArmKey : public QAbstractButton {
    Q_OBJECT

public:
    explicit ArmKey(QWidget* parent = nullptr);

    void setArmed(bool armed);
    /// why  the reason why the keyboard cannot be armed, as a sentence; empty if it can be armed
    void setLock(const QString& why);
    bool isArmed() const { return isChecked(); }

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void nextCheckState() override {}  // KeyboardJog sets the state, not a click
    void paintEvent(QPaintEvent* event) override;
    void changeEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;  ///< Space stops the arm and must not arm the keyboard
    void focusInEvent(QFocusEvent* event) override;

private:
    bool focusByKey_ = false;
    QString lock_;
};

}  // namespace tiller
