// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The button in the title bar of the jog column that arms the keyboard and shows whether it is armed, in the colour
// of the window frame. It does not move the arm.

#include <QAbstractButton>

namespace tiller {

class ArmKey : public QAbstractButton {
    Q_OBJECT

public:
    explicit ArmKey(QWidget* parent = nullptr);

    void setArmed(bool armed);
    /// why  the reason why the keyboard cannot be armed, as a sentence; empty if it can
    void setLock(const QString& why);
    bool isArmed() const { return isChecked(); }

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void nextCheckState() override {}  // KeyboardJog sets the state, not the click
    void paintEvent(QPaintEvent* event) override;
    void changeEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;  ///< Space stops the arm and must not arm the keyboard.
    void focusInEvent(QFocusEvent* event) override;

private:
    bool focusByKey_ = false;
    QString lock_;
};

}  // namespace tiller
