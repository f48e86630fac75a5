// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Checks whether the model and the TCP of the connected robot match the open project. If they do not match,
// moves to positions of the project are refused (RobotSession::setProjectGuard), and the operator is asked
// how to proceed. The question about another model is shown when a project is opened and when a robot is
// connected. The question about another TCP is shown when the user starts a move.

#include <QObject>
#include <QPointer>
#include <optional>

#include "robot/project/model_change.h"
#include "robot/station/link/robot_session.h"
#include "widgets/common/notice_bar.h"

class QMessageBox;
class QWidget;

namespace tiller {

class ProjectDocument;

class ProjectFit : public QObject {
    Q_OBJECT

public:
    /// session, document  must outlive the object, which becomes the project guard of the session
    /// over               parent window of the questions
    ProjectFit(RobotSession& session, ProjectDocument& document, QWidget* over);
    ~ProjectFit() override;

    /// The reason why moves to positions of the project are refused, as a sentence; empty if they are
    /// permitted.
    QString obstacle() const;
    /// Asks about the differences, or reports that there are none.
    void ask();

Q_SIGNALS:
    /// A question is about to open. The arm must stop before the window loses the keyboard focus.
    void questionOpens();
    void noticeWanted(const tiller::Notice& notice);
    /// Notices with this cause no longer apply.
    void noticeResolved(const QString& cause);

private:
    void follow(const SessionState& state);
    bool isOfOtherModel() const;
    /// The TCP of the project if it differs from the TCP of the robot.
    std::optional<project::Tool> otherTcp() const;
    QString modelText() const;
    QString tcpText(const project::Tool& tool) const;
    void askAboutModel();
    void askAboutTcp(const project::Tool& tool);
    void show(QMessageBox& question);
    void change(project::Keep keep);
    void remind();
    void resolve();

    RobotSession& session_;
    ProjectDocument& document_;
    QWidget* over_;
    QPointer<QMessageBox> question_;
    /// Robot model in the last question for this project.
    std::optional<RobotModelId> askedFor_;
    /// TCP of the robot that the user has decided to keep for this project.
    std::optional<Pose> keptTcp_;
    bool noticed_ = false;  ///< true if a notice about the model is shown
};

}  // namespace tiller
