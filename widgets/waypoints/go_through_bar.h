// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The buttons for "Run route": hold to run, one waypoint back, one waypoint forward, selection of waypoints,
// and running once or in a loop. Also shows the next waypoint. HoldRules determines when a held motion ends.

#include <QWidget>
#include <array>
#include <functional>

#include "robot/station/route/route_runner.h"

class QCheckBox;

namespace tiller {

class ChoiceBox;
class HoldToRunButton;
struct HoldPolicy;

class GoThroughBar : public QWidget {
    Q_OBJECT

public:
    /// The waypoints of the route, in the order of the list.
    enum class Scope { FromHere, Selection, All };

    /// policy  hold policy of the window; must outlive the bar
    /// The other arguments are those of RouteRunner.
    GoThroughBar(MotionPort port, HoldPolicy& policy, ActionPort actions, const ProjectDocument& document,
                 const std::function<HeldSpeed()>& heldSpeed, QWidget* parent = nullptr);
    ~GoThroughBar() override;

    void setState(const SessionState& state);
    void setGripper(GripperPort gripper) { actions_.gripper = std::move(gripper); }
    /// Sets the selection and restarts the route.
    /// current  -1 for none
    void setSelection(int current, const QList<int>& selected);
    /// Updates the route after an edit of the document, with this selection.
    void followDocument(int current, const QList<int>& selected);
    void showSpeed();
    void stop(control::StopCause cause);
    bool isHolding() const;

    /// Row of the next waypoint while running or paused; -1 otherwise.
    int comingRow() const;
    const RouteRunner& goThrough() const { return goThrough_; }

Q_SIGNALS:
    /// Emitted when the next waypoint changes, or when a button is pressed or released.
    void comingChanged();
    /// A press had no effect, or the run was aborted for this reason.
    /// passing  true if the reason disappears automatically, e.g. because another button is held
    void refused(const QString& reason, bool passing);

private:
    HoldToRunButton* addKey(const QString& text, const QString& objectName, const QString& accessibleName,
                            const QString& toolTip, RouteRunner::Way way);
    QVector<int> rows() const;
    void showRoute();
    void showDetail();
    HoldToRunButton& through();
    void updateAvailability();

    MotionPort port_;
    HoldPolicy& policy_;
    ActionPort actions_;
    const ProjectDocument& document_;
    SessionState state_;
    RouteRunner goThrough_;
    int current_ = -1;
    QList<int> selected_;
    std::array<QString, 3> obstacles_;  ///< reasons why the route cannot run, by RouteRunner::Way

    QString place_;  ///< e.g. "2 of 7"
    QString speed_;

    std::array<HoldToRunButton*, 3> keys_{};  ///< hold-to-run buttons by RouteRunner::Way
    ChoiceBox* scope_;
    QCheckBox* loop_;
};

}  // namespace tiller
