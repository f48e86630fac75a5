// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The live TCP pose in the chosen frame, and which that is: position in mm with the way since the press (or since
// "zero here"), orientation as roll, pitch and yaw in degrees, or as the operator chose. Above it how fast the TCP
// goes, and what a modifier key that is down makes of the chosen speed. Digits change ten times a second at most;
// values older than 0.3 s are greyed.

#include <QTimer>
#include <QWidget>

#include "robot/core/spatial.h"

namespace tiller {

class PoseView : public QWidget {
    Q_OBJECT

public:
    explicit PoseView(QWidget* parent = nullptr);

    /// moving  shows one digit less, because the last one only flickers
    /// valid   false: dashes; stale: grey
    /// pose    in the base frame
    void setPose(const Pose& pose, bool moving, bool valid, bool stale);
    /// The frame in which it is shown, as it is called and where it lies.
    void setFrame(const QString& name, const Pose& T_base_frame);
    void setTcp(const Pose& offset);
    void setSpeed(const Twist& tcpSpeed);
    /// Of the chosen speed: 1, 3 or 0.1.
    void setFactor(double factor);
    /// Counts the way from here until it is asked again, which goes back to the way since the press. A click
    /// on the view, or Enter on it, does the same.
    void zeroHere();
    /// A motion begins here: counts from here, unless the operator chose another place.
    void pressedHere();

    QString positionText(int axis) const;
    QString deltaText(int axis) const;
    QString rotationText(int axis) const;
    /// "in Base · TCP 120.0 mm from the flange"
    QString frameText() const;
    /// "50 mm/s", with the turn behind it while it turns: "0.0 mm/s · 15 °/s".
    QString speedText() const;
    /// "× 0.1"; empty at the chosen speed.
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
    /// All that changes with the arm, as it is written.
    QStringList figures() const;
    void showFigures();
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
    bool ownZero_ = false;  ///< the operator's, not the press's
    bool moving_ = false;
    bool valid_ = false;
    bool stale_ = false;
    bool focusByKey_ = false;
};

}  // namespace tiller
