// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Checks whether the open project matches the connected robot: its model and its TCP. If it does not match,
// no move to a position of the project starts (RobotSession::setProjectGuard), and the operator is asked what
// to do. The question about another model is shown when the project is opened and when the robot is
// connected; the question about another TCP is shown when the arm is to move.

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
    /// session, document  must outlive the object; it becomes the project guard of the session
    /// over               parent window of the questions
    ProjectFit(RobotSession& session, ProjectDocument& document, QWidget* over);
    ~ProjectFit() override;

    /// The reason why no move to a position of the project may start, as a sentence; empty if it may.
    QString obstacle() const;
    /// Asks about differences; reports if there are none.
    void ask();

Q_SIGNALS:
    /// A question is about to open: the arm has to stop before the window loses the keyboard focus.
    void questionOpens();
    void noticeWanted(const tiller::Notice& notice);
    /// Notices with this cause no longer apply.
    void noticeResolved(const QString& cause);
    /// A message for the log.
    void message(tiller::Severity severity, const QString& text);

private:
    void follow(const SessionState& state);
    bool isOfOtherModel() const;
    /// The TCP used by the project if the robot uses a different one.
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
    std::optional<RobotModelId> askedFor_;  ///< the robot model the user was asked about for this project
    /// The TCP of the robot that the user chose to keep for this project.
    std::optional<Pose> keptTcp_;
    bool noticed_ = false;  ///< a notice about the model is shown
};

}  // namespace tiller
