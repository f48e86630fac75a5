// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Estimates the payload from the forces measured in four or more poses. Between the poses, the user jogs the
// arm, or holds a button that moves the arm to a suggested pose. Shows the consistency of the poses and the
// pose with the largest residual.

#include <QWidget>
#include <vector>

#include "robot/kinematics/payload_estimation.h"
#include "robot/station/link/motion_port.h"
#include "robot/station/link/move_time.h"
#include "robot/station/link/standstill_mean.h"
#include "widgets/hold/hold_guard.h"

class QLabel;
class QPushButton;

namespace tiller {

class HoldToRunButton;

class PayloadEstimator : public QWidget {
    Q_OBJECT

public:
    /// policy  the policy of the window; must outlive the widget
    PayloadEstimator(MotionPort port, HoldPolicy& policy, QWidget* parent = nullptr);
    ~PayloadEstimator() override;

    /// Restarts the estimation with the current position.
    void begin();
    void setState(const SessionState& state);
    void setHeldSpeed(std::function<HeldSpeed()> speed) { heldSpeed_ = std::move(speed); }
    const kinematics::PayloadEstimate& estimate() const { return estimate_; }

Q_SIGNALS:
    void found(double mass, const Eigen::Vector3d& centre);
    void cancelled();

private:
    Result<MotionPort::Id> beginMove();
    JointPositions nextPose() const;
    void take();
    void refresh();
    QString feedback() const;

    MotionPort port_;
    std::function<HeldSpeed()> heldSpeed_ = [] { return HeldSpeed(); };
    HoldBounds bounds_;
    SessionState state_;
    JointPositions start_;
    std::vector<kinematics::PayloadReading> readings_;
    kinematics::PayloadEstimate estimate_;
    StandstillMean mean_;
    bool taking_ = false;
    QString problem_;
    QPushButton* take_;
    QPushButton* again_;
    HoldToRunButton* next_;
    QLabel* feedback_;
    QLabel* poses_;
    QPushButton* keep_;
};

}  // namespace tiller
