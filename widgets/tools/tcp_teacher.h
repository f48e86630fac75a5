// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The TCP of a tool, taught with the arm: its tip from four or more poses in which it stands on one point, and how it
// is turned from one pose or three. It says at any time what is missing, how well the poses agree, and which one
// fits least.

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

    /// Begins anew.
    /// rotation  of the tool, kept where no other is taught
    void begin(const QString& title, const Eigen::Vector3d& rotation);
    /// Where the flange stands; poses can be taken while there are live data.
    void setLive(const SessionState& state);
    /// The next pose of the tip, or of the rotation once the tip is known.
    void takeNext();
    void finish();

    /// What the poses give so far.
    std::optional<Pose> tcp() const;

Q_SIGNALS:
    void made(const tiller::Pose& tcpOffset);
    void cancelled();

private:
    /// What the rotation is taken from.
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
    std::vector<Eigen::Isometry3d> turns_;  ///< one or three
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
