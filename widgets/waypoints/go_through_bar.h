// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The line of keys for "Go through": hold to go, one waypoint back, one on, which waypoints, once or in a loop, and
// which one is the coming one. The rules are those of HoldRules.

#include <QWidget>
#include <array>
#include <functional>

#include "robot/station/route/route_runner.h"

class QCheckBox;

namespace tiller {

class ChoiceBox;
class HoldButton;

class GoThroughBar : public QWidget {
    Q_OBJECT

public:
    /// Which waypoints it goes through; as in the list of choices.
    enum class Scope { FromHere, Selection, All };

    /// As those of RouteRunner.
    GoThroughBar(MotionPort port, ActionPort actions, const ProjectDocument& document,
                 const std::function<HeldSpeed()>& heldSpeed, QWidget* parent = nullptr);
    ~GoThroughBar() override;

    void setState(const SessionState& state);
    void setGripper(GripperPort gripper) { actions_.gripper = std::move(gripper); }
    /// The operator selected other rows: the way begins anew.
    /// current  -1 for none
    void setSelection(int current, const QList<int>& selected);
    /// The document was edited; the selection is this one now.
    void followDocument(int current, const QList<int>& selected);
    /// Shows the speed of a press now.
    void showSpeed();
    /// Ends the motion under way, if any.
    void stop(control::StopCause cause);
    bool isHolding() const;

    /// Row of the coming waypoint while the way is under way or paused; -1 otherwise.
    int comingRow() const;
    const RouteRunner& goThrough() const { return goThrough_; }

Q_SIGNALS:
    /// Another waypoint is the coming one, or a key was pressed or let go.
    void comingChanged();
    /// A press moved nothing, or it ended before its end: why.
    void refused(const QString& reason);

private:
    HoldButton* addKey(const QString& text, const QString& objectName, const QString& accessibleName,
                       const QString& toolTip, RouteRunner::Way way);
    QVector<int> rows() const;
    void showRoute();
    void showDetail();
    HoldButton& through();
    void updateAvailability();

    MotionPort port_;
    ActionPort actions_;
    const ProjectDocument& document_;
    SessionState state_;
    RouteRunner goThrough_;
    int current_ = -1;
    QList<int> selected_;
    std::array<QString, 3> obstacles_;  ///< of the route, by RouteRunner::Way

    QString place_;  ///< "2 of 7"
    QString speed_;

    std::array<HoldButton*, 3> keys_{};  ///< by RouteRunner::Way
    ChoiceBox* scope_;
    QCheckBox* loop_;
};

}  // namespace tiller
