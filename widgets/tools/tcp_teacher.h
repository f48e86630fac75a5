// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Teaches a TCP with the arm. The tip position results from four or more poses with the tip at the same
// point. The tool orientation results from one or three poses. Shows the next pose, the consistency of the
// poses, and the pose with the largest residual.

#include <QWidget>
#include <array>
#include <optional>
#include <vector>

#include "robot/kinematics/tcp_calibration.h"
#include "robot/station/link/session_state.h"

class QLabel;
class QPushButton;

namespace tiller {

class ChoiceBox;

class TcpTeacher : public QWidget {
    Q_OBJECT

public:
    explicit TcpTeacher(QWidget* parent = nullptr);

    /// Restarts teaching.
    /// rotation  tool orientation, which is kept unless an orientation is taught
    void begin(const QString& title, const Eigen::Vector3d& rotation);
    /// Sets the current flange pose. Poses can be recorded while data are live.
    void setLive(const SessionState& state);
    /// Records the next pose of the tip or, when the tip is complete, of the orientation.
    void takeNext();
    void finish();

    /// The TCP computed from the recorded poses.
    std::optional<Pose> tcp() const;

Q_SIGNALS:
    void made(const tiller::Pose& tcpOffset);
    void cancelled();

private:
    /// Methods for teaching the tool orientation.
    enum Turning { AsItIs, StraightDown, ThreePoses };

    std::optional<Eigen::Isometry3d> flange() const;
    void takeTip();
    void takeTipAgain();
    void takeTurn();
    std::optional<Eigen::Vector3d> rotation() const;
    QString tipFeedback() const;
    QString turnFeedback() const;
    void refresh();

    SessionState state_;
    Eigen::Vector3d before_ = Eigen::Vector3d::Zero();
    std::vector<Eigen::Isometry3d> tips_;
    std::vector<Eigen::Isometry3d> turns_;  ///< flange poses for the orientation: one or three
    kinematics::TipFit fit_;
    QLabel* title_;
    QPushButton* take_;
    QPushButton* again_;
    QLabel* poses_;
    QLabel* feedback_;
    ChoiceBox* turning_;
    QPushButton* takeTurn_;
    QLabel* turnFeedback_;
    QPushButton* make_;
};

}  // namespace tiller
