// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The tool centre points of the project: named, entered or taught, one of them active. The TCP of the robot is also
// displayed; if the two differ, the user is asked, and neither is changed automatically.

#include <optional>

#include "robot/project/tooling.h"
#include "widgets/tools/part_page.h"

class QLabel;

namespace tiller {

class PoseEditor;
class ProjectDocument;
class TcpTeacher;

class TcpPage : public PartPage {
    Q_OBJECT

public:
    /// document  must outlive the object
    TcpPage(RobotSession& session, ProjectDocument& document, QWidget* parent = nullptr);

    void setState(const SessionState& state);
    /// After undo or redo: selects the changed TCP, and asks if the robot has a different one.
    void followStep(const QUuid& id);

    /// Larger differences between robot and project are reported [m, rad].
    static constexpr double kSameDistance = 5e-5;
    static constexpr double kSameAngle = 1e-3;

protected:
    void onSelection() override;

private:
    const project::Tool* current() const;
    void addFromRobot();
    void teach();
    void use();
    void duplicate();
    void remove();
    void change(const project::Tool& tool, const QString& text);
    void insert(project::Tool tool);
    void refresh();
    void compare();

    RobotSession& session_;
    ProjectDocument& document_;
    SessionState state_;
    PoseEditor* pose_;
    QLabel* facts_;
    TcpTeacher* teacher_;
    QUuid teachingInto_;
    std::optional<project::Tool> asked_;  ///< the tool for which the user was asked
    Pose askedAbout_;                     ///< the TCP of the robot in that question
};

}  // namespace tiller
