// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The live TCP pose: position in mm with the way since the press (or since "zero here"), orientation
// as roll, pitch and yaw in degrees, or as the operator chose. Digits change ten times a second at most;
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
    void setPose(const Pose& pose, bool moving, bool valid, bool stale);
    /// Counts the way from here until it is asked again, which goes back to the way since the press. A click
    /// on the view, or Enter on it, does the same.
    void zeroHere();
    /// A motion begins here: counts from here, unless the operator chose another place.
    void pressedHere();

    QString positionText(int axis) const;
    QString deltaText(int axis) const;
    QString rotationText(int axis) const;

    QSize sizeHint() const override { return {366, 93}; }
    QSize minimumSizeHint() const override { return {300, 78}; }

protected:
    void paintEvent(QPaintEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;

private:
    void describe();

    Pose pose_;
    Eigen::Vector3d zero_ = Eigen::Vector3d::Zero();
    QTimer pace_;
    bool pending_ = false;
    bool hasZero_ = false;
    bool ownZero_ = false;  ///< the operator's, not the press's
    bool moving_ = false;
    bool valid_ = false;
    bool stale_ = false;
    bool focusByKey_ = false;
};

}  // namespace tiller
