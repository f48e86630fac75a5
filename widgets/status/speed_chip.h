// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The speed slider of the header, 2 to 100 %. It shows what the robot reports; a hand on it goes first. It is
// drawn along, or moved by keys once it was clicked: a click alone changes nothing, and the wheel never does.

#include <QAbstractSlider>
#include <QTimer>

namespace tiller {

class SpeedChip : public QAbstractSlider {
    Q_OBJECT

public:
    explicit SpeedChip(QWidget* parent = nullptr);

    /// What the robot reports, 0..1; valid false greys the chip.
    void setReported(double fraction, bool valid);
    /// reason  why it cannot be moved, as a sentence; empty: it can
    void setLocked(const QString& reason);

    QSize sizeHint() const override { return {230, 47}; }
    QSize minimumSizeHint() const override { return {118, 47}; }

Q_SIGNALS:
    /// A hand asks for this fraction, 0.02 ... 1.
    void fractionChosen(double fraction);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;

private:
    QRectF groove() const;

    QTimer settle_;  // how long a reported value waits for the robot to follow the hand
    bool showing_ = false;
    bool valid_ = false;
    QString lock_;
    int pressedAt_ = 0;  ///< where the hand took it [px]
    int pressedValue_ = 0;
};

}  // namespace tiller
