// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The speed slider of the header, 2 to 100 %. It shows the value reported by the robot, except while the user
// changes it. The slider responds to dragging, and to keys while it has the focus. It ignores a single click
// and the mouse wheel.

#include <QAbstractSlider>
#include <QTimer>

namespace tiller {

class SpeedChip : public QAbstractSlider {
    Q_OBJECT

public:
    explicit SpeedChip(QWidget* parent = nullptr);

    /// Sets the value reported by the robot, 0 ... 1.
    /// valid  if false, the slider is grey
    void setReported(double fraction, bool valid);
    /// reason  why the speed cannot be changed, as a sentence; empty if it can be changed
    void setLocked(const QString& reason);
    /// If true, a drag sends only the value at its release, because the operator must confirm every value
    /// that is sent.
    void setSendsOnRelease(bool onRelease) { sendsOnRelease_ = onRelease; }

    QSize sizeHint() const override { return {230, 47}; }
    QSize minimumSizeHint() const override { return {118, 47}; }

Q_SIGNALS:
    /// The user requested this fraction, 0.02 ... 1.
    void fractionChosen(double fraction);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;

private:
    QRectF groove() const;

    QTimer settle_;  // active while the reported value may lag behind the user input
    bool showing_ = false;
    bool valid_ = false;
    bool sendsOnRelease_ = false;
    QString lock_;
    int pressedAt_ = 0;  ///< position of the press [px]
    int pressedValue_ = 0;
};

}  // namespace tiller
