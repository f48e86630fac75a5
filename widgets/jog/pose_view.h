// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The current TCP pose in the selected frame: position in mm with the distance since the press (or since "zero
// here"), and orientation as roll, pitch and yaw in degrees or in the selected notation. Above it the TCP speed and
// the factor of a pressed modifier key. Numbers change at most ten times per second; values older than 0.3 s are
// grey.

#include <QTimer>
#include <QWidget>

#include "robot/core/spatial.h"

namespace tiller {

class PoseView : public QWidget {
    Q_OBJECT

public:
    explicit PoseView(QWidget* parent = nullptr);

    /// pose    in the base frame
    /// moving  shows one decimal less
    /// valid   false: dashes
    /// stale   grey
    void setPose(const Pose& pose, bool moving, bool valid, bool stale);
    /// Name and pose of the frame.
    void setFrame(const QString& name, const Pose& T_base_frame);
    void setTcp(const Pose& offset);
    void setSpeed(const Twist& tcpSpeed);
    /// Factor of the selected speed: 1, 3 or 0.1.
    void setFactor(double factor);
    /// Sets the zero point of the distances; a second call returns to distances since the press. Also triggered by
    /// a click or Enter on the view.
    void zeroHere();
    /// Start of a motion: new zero point, unless the user has set one.
    void pressedHere();

    QString positionText(int axis) const;
    QString deltaText(int axis) const;
    QString rotationText(int axis) const;
    /// e.g. "in Base · TCP 120.0 mm from the flange"
    QString frameText() const;
    /// e.g. "50 mm/s", while rotating "0.0 mm/s · 15 °/s".
    QString speedText() const;
    /// e.g. "× 0.1"; empty at the selected speed.
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
    /// All texts that change with the arm.
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
    bool ownZero_ = false;  ///< set by the user, not by the press
    bool moving_ = false;
    bool valid_ = false;
    bool stale_ = false;
    bool focusByKey_ = false;
};

}  // namespace tiller
