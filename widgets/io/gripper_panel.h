// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The gripper at the wrist: a Robotiq (activate, open, close, how far open, how fast, how strong, and what it
// holds), or tool outputs that open and close one. A click gives one command, as with an output; what is shown
// is what the gripper, or the robot for its outputs, says itself. Which gripper it is belongs to the robot and
// is remembered with it.

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

class FigureBox;

/// Where the choice is kept, by robot: its address, or "simulator". As GripperChoice::toText() has it.
struct GripperMemory {
    std::function<QString(const QString& robot)> load;
    std::function<void(const QString& robot, const QString& choice)> keep;
};

class GripperPanel : public QWidget {
    Q_OBJECT

public:
    explicit GripperPanel(RobotSession& session, QWidget* parent = nullptr);

    void setMemory(GripperMemory memory);
    /// The memory may hold another gripper for this robot now.
    void readAgain();
    /// The operator's own names of outputs, by terminal.
    void setNames(const QMap<QString, QString>& names);

    const GripperChoice& choice() const { return choice_; }
    const RobotiqLink& robotiq() const { return robotiq_; }
    /// For others; it may be used as long as the panel lives.
    GripperPort port();

    /// For tests: where the outputs' commands go, what time is, and where the gripper answers.
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
    void fitFigures();
    void listOutputs();
    void choose(const GripperChoice& choice);
    void chosenByHand();
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
    QString robot_;  ///< whose gripper it is; empty: no robot
    GripperChoice choice_;
    std::optional<std::pair<QString, int>> address_;  ///< instead of the robot's
    QElapsedTimer chosen_;                            ///< since the keys came to where they are
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
    FigureBox* position_;
    FigureBox* speed_;
    FigureBox* force_;
    QLabel* remedy_;
    QVector<QWidget*> ofAny_;
    QVector<QWidget*> ofRobotiq_;
    QVector<QWidget*> ofOutputs_;
    QVector<QWidget*> ofTwoOutputs_;

    RobotiqLink robotiq_;  // last: while it ends, nothing of the panel is used any more
};

}  // namespace tiller
