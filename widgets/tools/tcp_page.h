// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The tool centre points of the project: named, typed or taught, one of them in use. What the robot has is shown beside
// it; where the two differ it is said and asked about, and neither is changed by itself.

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
    /// document  must outlive it
    TcpPage(RobotSession& session, ProjectDocument& document, QWidget* parent = nullptr);

    void setState(const SessionState& state);
    /// After undo or redo: selects what changed, and asks when the robot has another one than the project.
    void followStep(const QUuid& id);

    /// Larger differences are told [m, rad].
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
    std::optional<project::Tool> asked_;  ///< the operator was asked about the difference of this tool
    Pose askedAbout_;                     ///< to this TCP of the robot
};

}  // namespace tiller
