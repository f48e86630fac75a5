// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The gripper panel. Supports Robotiq grippers (activate, open, close, position, speed, force, object
// detection) and grippers controlled by outputs. Each click sends one command. The display shows the state
// reported by the gripper or, for outputs, by the robot. The selected gripper is saved for each robot.

#include <QElapsedTimer>
#include <QMap>
#include <QTimer>
#include <QVector>
#include <QWidget>
#include <functional>
#include <optional>

#include "robot/core/clock.h"
#include "robot/station/link/gripper_choice.h"
#include "robot/station/link/gripper_port.h"
#include "robot/station/link/output_gripper.h"
#include "robot/station/link/robot_session.h"
#include "robot/station/link/robotiq_link.h"

class QAbstractButton;
class QComboBox;
class QGridLayout;
class QLabel;

namespace tiller {

class DecimalSpinBox;

/// Stores the gripper of each robot. `robot` is the address of the robot, or "simulator". The value has the
/// format of GripperChoice::toText().
struct GripperMemory {
    std::function<QString(const QString& robot)> load;
    std::function<void(const QString& robot, const QString& choice)> keep;
};

class GripperPanel : public QWidget {
    Q_OBJECT

public:
    explicit GripperPanel(RobotSession& session, QWidget* parent = nullptr);

    void setMemory(GripperMemory memory);
    /// Loads the gripper of the current robot again. Call this after the stored value may have changed.
    void readAgain();
    /// Sets the user's names of outputs, by terminal.
    void setNames(const QMap<QString, QString>& names);

    const GripperChoice& choice() const { return choice_; }
    const RobotiqLink& robotiq() const { return robotiq_; }
    /// Interface for other panels, valid for the lifetime of the panel.
    GripperPort port();

    /// For tests: replaces the receiver of output commands, the clock, and the address of the gripper.
    using OutputSetter = std::function<void(std::uint32_t mask, std::uint32_t values, const QString& what)>;
    void setOutputSetter(OutputSetter setter) { setOutputs_ = std::move(setter); }
    void setClock(const Clock& clock) { clock_ = &clock; }
    void setAddress(const QString& host, int port);

protected:
    void changeEvent(QEvent* event) override;

private:
    void build();
    QWidget* buildKeys();
    void addRow(QGridLayout* grid, const QString& label, QWidget* field, QVector<QWidget*>& group,
                QWidget* key = nullptr);
    void fitValues();
    void listOutputs();
    void choose(const GripperChoice& choice);
    void chosenByUser();
    void follow(const SessionState& state);
    void refollow();
    void refresh();
    void refreshRobotiq();
    void refreshOutputs();
    void setObstacles(const QString& opening, const QString& activating);
    void say(const QString& text, const char* role);
    void move(int position, const QString& what, const CancelToken& token = {});
    QString robotiqObstacle() const;
    std::optional<Result<void>> robotiqOutcome(bool close) const;
    void setHand(bool close);
    QString obstacleOfLink() const;

    RobotSession& session_;
    OutputSetter setOutputs_;
    const Clock* clock_ = &SteadyClock::shared();
    GripperMemory memory_;
    QMap<QString, QString> names_;
    SessionState state_;
    QString robot_;  ///< address of the robot; empty: no robot
    GripperChoice choice_;
    std::optional<std::pair<QString, int>> address_;  ///< if set, used instead of the robot's address
    QElapsedTimer chosen_;                            ///< time since the gripper was selected
    QTimer refreshTimer_;

    OutputGripper outputs_;

    QComboBox* kind_;
    QComboBox* closeOutput_;
    QComboBox* openOutput_;
    QLabel* stateText_;
    QLabel* openingText_;
    QLabel* holdsText_;
    QAbstractButton* activate_;
    QAbstractButton* open_;
    QAbstractButton* close_;
    QAbstractButton* move_;
    DecimalSpinBox* position_;
    DecimalSpinBox* speed_;
    DecimalSpinBox* force_;
    QLabel* remedy_;
    QVector<QWidget*> ofAny_;
    QVector<QWidget*> ofRobotiq_;
    QVector<QWidget*> ofOutputs_;
    QVector<QWidget*> ofTwoOutputs_;

    RobotiqLink robotiq_;  // last member, so that it is destroyed before the members it uses
};

}  // namespace tiller
