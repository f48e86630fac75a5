// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Shows a popup of the teach pendant in the window: heading, text and a button that closes it on the robot. It
// covers the view, does not take the focus and moves nothing. A click intended for the covered widget does not
// close it, nor does Space, which stops the arm: a program that waits for the popup would continue. Many popups in
// a short time, e.g. from a loop, are limited in number and shown a few times per second.

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
    /// over    the widget it is centred on while that is visible
    RobotPopup(RobotSession& session, QWidget& window, QWidget& over);

    /// Number of reported popups on the pendant, at most kMaxPopups; the newest is shown.
    int count() const { return static_cast<int>(popups_.size()); }
    /// Number of replacements of the displayed popup, for load tests.
    int updates() const { return updates_; }

    static constexpr int kMaxPopups = 100;    ///< beyond this number the oldest are dropped
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
    QString obstacle_;                ///< the reason why it can only be closed on the pendant
    std::optional<qsizetype> asked_;  ///< the popup that the robot was requested to close, until it responds
    bool refused_ = false;            ///< the robot did not close the displayed popup
    QTimer unread_;
    QTimer nextUpdate_;
    int updates_ = 0;
    QLabel* heading_;
    QLabel* text_;
    QLabel* note_;
    QPushButton* key_;
};

}  // namespace tiller
