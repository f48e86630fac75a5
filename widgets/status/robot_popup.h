// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Shows a popup of the teach pendant in the window: heading, text, and a button that closes the popup on the
// robot. The widget covers the view, does not take the focus and does not move other widgets. A click
// intended for the covered widget, or Space, which stops the arm, must not close the popup, because a program
// that waits for the popup would continue. If a program opens many popups, e.g. in a loop, their number is
// limited and the display is updated at most five times per second.

#include <QFrame>
#include <QList>
#include <QTimer>
#include <optional>

#include "robot/script/controller_message.h"
#include "robot/station/link/robot_session.h"

class QLabel;
class QPushButton;

namespace tiller {

class RobotPopup : public QFrame {
    Q_OBJECT

public:
    /// window  the parent
    /// over    the popup is centred on this widget while it is visible
    RobotPopup(RobotSession& session, QWidget& window, QWidget& over);

    /// Number of popups that are known to be open on the teach pendant, at most kMaxPopups. The newest is
    /// displayed.
    int count() const { return static_cast<int>(popups_.size()); }
    /// Closes the newest popup on the robot. Like the button, it has no effect until the popup could be read,
    /// or while the robot is closing a popup.
    void closeNewest();
    /// The reason why closeNewest() would have no effect; empty if it would close a popup.
    QString closeObstacle() const;
    /// Number of updates of the widget, for load tests.
    int updates() const { return updates_; }

    static constexpr int kMaxPopups = 100;    ///< if there are more popups, the oldest are dropped
    static constexpr int kShowEveryMs = 200;  ///< interval between two updates of the widget [ms]

    /// Time during which a new popup cannot be closed, so that the user can read it [ms].
    static constexpr int kUnreadMs = 500;

protected:
    void paintEvent(QPaintEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void hear(const script::ControllerMessage& message);
    void followState(const SessionState& state);
    void followCommand(RobotCommand command, bool done);
    void closeOnRobot();
    bool isCloseEnabled() const;
    QString obstacleNow(const SessionState& state) const;
    void remove(qsizetype which);
    void forget();
    void showSoon();
    void showNewest();
    void showKey();
    void place();

    RobotSession& session_;
    QWidget& over_;
    QList<script::ControllerMessage> popups_;
    QString obstacle_;  ///< the reason why the popup can be closed only on the teach pendant
    /// Index of the popup that the robot is requested to close; empty after the response.
    std::optional<qsizetype> asked_;
    double robotTime_ = 0;  ///< time since the controller was switched on, as last reported [s]
    bool refused_ = false;  ///< true if the robot did not close the displayed popup
    QTimer unread_;
    QTimer nextUpdate_;
    int updates_ = 0;
    QLabel* heading_;
    QLabel* text_;
    QLabel* note_;
    QPushButton* key_;
};

}  // namespace tiller
