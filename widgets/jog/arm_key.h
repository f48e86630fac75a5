// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The key in the title bar of the jog column that arms the keyboard and shows that it is armed, in the colour of the
// frame around the window. It moves nothing.

#include <QAbstractButton>

namespace tiller {

class ArmKey : public QAbstractButton {
    Q_OBJECT

public:
    explicit ArmKey(QWidget* parent = nullptr);

    void setArmed(bool armed);
    /// why  the keyboard cannot be armed, as a sentence; empty when it can
    void setLock(const QString& why);
    bool isArmed() const { return isChecked(); }

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void nextCheckState() override {}  // the keyboard says whether it is armed, not the click
    void paintEvent(QPaintEvent* event) override;
    void changeEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;  ///< Space, which stops the arm, arms nothing.
    void focusInEvent(QFocusEvent* event) override;

private:
    bool focusByKey_ = false;
    QString lock_;
};

}  // namespace tiller
