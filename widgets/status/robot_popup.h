// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Shows a popup of the teach pendant in the window: heading, text, and a button that closes the popup on the
// robot. The widget covers the view, does not take the focus and does not move other widgets. It cannot be
// closed by a click intended for the covered widget, or by Space, which stops the arm. Otherwise, a program
// that waits for the popup would continue. If many popups arrive in a short time, e.g. from a loop, their
// number is limited and the display is updated only a few times per second.

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
    /// over    the widget on which the popup is centred while that widget is visible
    RobotPopup(RobotSession& session, QWidget& window, QWidget& over);

    /// Number of reported popups on the pendant, at most kMaxPopups. The newest popup is displayed.
    int count() const { return static_cast<int>(popups_.size()); }
    /// Closes the newest popup on the robot. Like the button, it has no effect until the popup could be read,
    /// or while the robot is closing a popup.
    void closeNewest();
    /// The reason why closeNewest() would have no effect; empty if it would close a popup.
    QString closeObstacle() const;
    /// Number of updates of the displayed popup, for load tests.
    int updates() const { return updates_; }

    static constexpr int kMaxPopups = 100;    ///< if there are more popups, the oldest are dropped
    static constexpr int kShowEveryMs = 200;  ///< interval between two updates of the widget [ms]

    /// A new popup cannot be closed during this time [ms].
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
    QString obstacle_;  ///< the reason why the popup can be closed only on the pendant
    /// The popup that the robot was requested to close; empty after the response.
    std::optional<qsizetype> asked_;
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
