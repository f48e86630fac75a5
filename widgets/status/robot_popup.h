// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A popup that stands on the teach pendant, shown in the window as the robot shows it: heading, text and a key that
// closes it there. It lies over the view, takes the focus from nobody and moves nothing; a click that was meant for
// what it covers does not close it, nor does Space, which means stop: a program that waits would go on.

#include <QFrame>
#include <QList>
#include <QTimer>
#include <optional>

#include "robot/script/controller_message.h"
#include "widgets/session/robot_session.h"

class QLabel;
class QPushButton;

namespace tiller {

class RobotPopup : public QFrame {
    Q_OBJECT

public:
    /// window  that it is a child of
    /// over    in whose middle it stands, while that is shown
    RobotPopup(RobotSession& session, QWidget& window, QWidget& over);

    /// How many stand on the pendant, as far as was heard; the newest is shown.
    int count() const { return static_cast<int>(popups_.size()); }

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
    QLabel* heading_;
    QLabel* text_;
    QLabel* note_;
    QPushButton* key_;
};

}  // namespace tiller
