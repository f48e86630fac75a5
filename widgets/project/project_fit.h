// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Whether the open project fits the connected robot: its arm, and its TCP. While it does not, no move to a place of the
// project begins (RobotSession::setProjectGuard), and the operator is asked what to do: about another arm when the
// project is opened and when the robot is connected, about another TCP when the arm is to move.

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
    /// session, document  must outlive it; it becomes the project guard of the session
    /// over               the window that the questions belong to
    ProjectFit(RobotSession& session, ProjectDocument& document, QWidget* over);
    ~ProjectFit() override;

    /// Why nothing moves to a place of the project, as a sentence; empty when it may.
    QString obstacle() const;
    /// Asks about what does not fit; reports that all fits otherwise.
    void ask();

Q_SIGNALS:
    /// The arm has to stop before the window loses the keyboard.
    void questionOpens();
    void noticeWanted(const tiller::Notice& notice);
    /// Notices with this cause are no longer true.
    void noticeResolved(const QString& cause);
    /// Something the operator should be able to read again later.
    void message(tiller::Severity severity, const QString& text);

private:
    void follow(const SessionState& state);
    bool isOfOtherModel() const;
    /// The TCP the project uses, where the robot has another one.
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
    std::optional<RobotModelId> askedFor_;  ///< the arm that has been asked about for this project
    /// The TCP of the robot that the operator wants to keep with this project.
    std::optional<Pose> keptTcp_;
    bool noticed_ = false;  ///< a notice about the model is shown
};

}  // namespace tiller
