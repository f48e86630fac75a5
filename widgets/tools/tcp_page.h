// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The tool centre points of the project, one of which is active. A TCP is entered or taught. The page also
// displays the TCP of the robot. If it differs from the active TCP, the page asks the user and changes
// neither automatically.

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
    /// session, document  must outlive the object
    TcpPage(RobotSession& session, ProjectDocument& document, QWidget* parent = nullptr);

    void setState(const SessionState& state);
    /// Selects the changed TCP, and asks the user if the robot has a different TCP. Call this after undo or
    /// redo.
    void followStep(const QUuid& id);

    /// Tolerances [m, rad]. Larger differences between robot and project are reported.
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
    std::optional<project::Tool> asked_;  ///< tool in the last question to the user
    Pose askedAbout_;                     ///< TCP of the robot in the last question
};

}  // namespace tiller
