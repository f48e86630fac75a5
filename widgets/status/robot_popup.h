// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Shows a popup of the teach pendant in the window: heading, text and a button that closes it on the robot. It covers
// the view, takes no focus and moves nothing. A click that was meant for the covered widget does not close it, nor does
// Space, which means stop: a program that waits for the popup would continue. Many popups at once, as from a program that
// opens them in a loop, are kept up to a limit and shown a few times a second.

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
    /// window  that it is a child of
    /// over    in whose middle it stands, while that is shown
    RobotPopup(RobotSession& session, QWidget& window, QWidget& over);

    /// Popups on the pendant that were reported, at most kMaxPopups; the newest is shown.
    int count() const { return static_cast<int>(popups_.size()); }
    /// How many times the shown popup was replaced, for tests of the load.
    int updates() const { return updates_; }

    static constexpr int kMaxPopups = 100;    ///< beyond these the oldest are forgotten
    static constexpr int kShowEveryMs = 200;  ///< [ms] between two updates of the widget

    /// So long a new one cannot be closed [ms].
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
    QString obstacle_;                ///< why it can only be closed on the pendant
    std::optional<qsizetype> asked_;  ///< which the robot was asked to close, until it answers
    bool refused_ = false;            ///< the robot did not close the one that is shown
    QTimer unread_;
    QTimer nextUpdate_;
    int updates_ = 0;
    QLabel* heading_;
    QLabel* text_;
    QLabel* note_;
    QPushButton* key_;
};

}  // namespace tiller
