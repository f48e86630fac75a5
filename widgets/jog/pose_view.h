// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The current TCP pose in the selected frame, in the units and notation of the settings. Shows the position
// with the distance since the press (or since "zero here"), and the orientation. The line above shows the TCP
// speed and the factor of a pressed modifier key. Numbers change at most ten times per second. Values older
// than 0.3 s are grey.

#include <QTimer>
#include <QWidget>

#include "robot/core/spatial.h"

namespace tiller {

class PoseView : public QWidget {
    Q_OBJECT

public:
    explicit PoseView(QWidget* parent = nullptr);

    /// pose    in the base frame
    /// moving  if true, shows one decimal fewer
    /// valid   if false, shows dashes
    /// stale   if true, shows grey values
    void setPose(const Pose& pose, bool moving, bool valid, bool stale);
    void setFrame(const QString& name, const Pose& T_base_frame);
    void setTcp(const Pose& offset);
    void setSpeed(const Twist& tcpSpeed);
    /// Sets the factor applied to the selected speed: 1, 3 or 0.1.
    void setFactor(double factor);
    /// Sets the zero point of the distances. A second call restores the distances since the press. A click or
    /// Enter on the view has the same effect.
    void zeroHere();
    /// Sets the zero point unless the user has set one. Call this at the start of a motion.
    void pressedHere();

    QString positionText(int axis) const;
    QString deltaText(int axis) const;
    QString deltaText(int axis, const QFont& font, int space) const;
    QString rotationText(int axis) const;
    /// Text of the caption, e.g. "in Base · TCP 120.0 mm from the flange".
    QString frameText() const;
    /// Text of the TCP speed, e.g. "50 mm/s", or "0.0 mm/s · 15 °/s" while rotating.
    QString speedText() const;
    /// Text of the factor, e.g. "× 0.1"; empty if the factor is 1.
    QString factorText() const;

    QSize sizeHint() const override { return {366, 110}; }
    QSize minimumSizeHint() const override { return {300, 80}; }

protected:
    void paintEvent(QPaintEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void changeEvent(QEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;

private:
    void describe();
    void changed(bool atOnce);
    /// All displayed texts that change with the arm.
    QStringList figures() const;
    void updateValueTexts();
    Eigen::Vector3d inFrame(const Eigen::Vector3d& way) const;

    Pose pose_;
    QString frame_;
    Pose T_base_frame_;
    Pose tcp_;
    Twist speed_;
    double factor_ = 1;
    Eigen::Vector3d zero_ = Eigen::Vector3d::Zero();
    QTimer pace_;
    QStringList shown_;
    bool pending_ = false;
    bool hasZero_ = false;
    bool ownZero_ = false;  ///< true if the user has set the zero point
    bool moving_ = false;
    bool valid_ = false;
    bool stale_ = false;
    bool focusByKey_ = false;
};

}  // namespace tiller
