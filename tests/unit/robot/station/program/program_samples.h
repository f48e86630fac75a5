// SPDX-License-Identifier: MIT
#pragma once

// Programs for tests, created step by step, and a project with the elements used by the steps.

#include "robot/kinematics/arm_kinematics.h"
#include "robot/project/project_file.h"
#include "robot/station/program/step_kind.h"

namespace tiller::program {

inline const JointPositions kStart{-1.6, -1.7, -2.2, -0.8, 1.6, -0.03};

inline project::Waypoint waypointAt(const QString& name, const Eigen::Vector3d& offset,
                                    const QString& group = {}) {
    const DhParameters& dh = robotModel(RobotModelId::UR5e).dh;
    project::Waypoint point;
    point.id = QUuid::createUuid();
    point.name = name;
    point.group = group;
    Pose pose = kinematics::forwardTcp(dh, kStart);
    pose.position += offset;
    point.pose = pose;
    point.joints = kinematics::inverseNearest(dh, pose, {}, kStart).value();
    point.priority = project::TargetKind::Pose;
    return point;
}

/// Waypoints "home", "pick" and "place", a group "row" of three waypoints, a pattern "tray" of 3 x 4
/// positions, a frame, two tools, a payload.
inline project::Project sampleProject() {
    project::Project project;
    project.robot = RobotModelId::UR5e;
    project.waypoints.append(waypointAt("home", {0, 0, 0.05}));
    project.waypoints.append(waypointAt("pick", {0.1, 0, 0}));
    project.waypoints.append(waypointAt("place", {-0.1, 0, 0}));
    for (int i = 0; i < 3; ++i) {
        project.waypoints.append(waypointAt(QStringLiteral("row %1").arg(i + 1), {0.03 * i, 0.05, 0}, "row"));
    }
    project::Pattern pattern;
    pattern.id = QUuid::createUuid();
    pattern.name = "tray";
    pattern.first = waypointAt("first", {-0.05, 0.02, 0});
    pattern.columnEnd = pattern.first.pose.position + Eigen::Vector3d(0.06, 0, 0);
    pattern.rowEnd = pattern.first.pose.position + Eigen::Vector3d(0, 0.09, 0);
    pattern.columns = 3;
    pattern.rows = 4;
    project.patterns.append(pattern);
    project.frames.append({QUuid::createUuid(), "table", Pose(0.1, 0, 0, 0, 0, 1.5707963267948966), {}});
    project.tooling.tools = {{QUuid::createUuid(), "gripper", Pose(0, 0, 0.1, 0, 0, 0), 0, {}, {}},
                             {QUuid::createUuid(), "camera", Pose(0, 0.05, 0.05, 0, 0, 0), 0, {}, {}}};
    project.tooling.payloads = {{QUuid::createUuid(), "part", 0.5, {0, 0, 0.05}, std::nullopt, {}, {}}};
    return project;
}

inline QString idText(const QUuid& id) {
    return id.toString(QUuid::WithoutBraces);
}
inline QString waypointId(const project::Project& project, const QString& name) {
    return idText(project.waypoints.at(project.waypoints.indexOfName(name)).id);
}

/// A step with the default values of its kind; `fields` override them.
inline project::ProgramStep step(const char* kind, const QJsonObject& fields = {},
                                 std::vector<project::ProgramStep> steps = {}) {
    const StepKind* found = findStepKind(QLatin1String(kind));
    project::ProgramStep result =
        found != nullptr ? newStep(*found) : project::ProgramStep{QUuid::createUuid(), kind, {}, false, {}};
    for (auto field = fields.begin(); field != fields.end(); ++field) {
        result.fields.insert(field.key(), field.value());
    }
    result.steps = std::move(steps);
    return result;
}

inline project::Program makeProgram(const QString& name, std::vector<project::ProgramStep> steps) {
    return {QUuid::createUuid(), name, {}, std::move(steps), {}, {}};
}

/// Moves parts from the pick position to each position of the tray, with a check of the part and an On error
/// section.
inline project::Program trayProgram(const project::Project& project) {
    const QString pick = waypointId(project, "pick");
    const QString tray = idText(project.patterns.at(0).id);
    return makeProgram(
        "Fill the tray",
        {step("moveJ", {{"waypoint", waypointId(project, "home")}}),
         step("gripper", {{"action", "open"}, {"time", 0.2}}),
         step("assign", {{"variable", "parts"}, {"type", "whole"}, {"value", "0"}}),
         step("try", {},
              {step(
                  "forEachPlace", {{"pattern", tray}, {"variable", "slot"}},
                  {step("moveJ", {{"waypoint", pick}, {"before", 0.05}}), step("moveL", {{"waypoint", pick}}),
                   step("gripper", {{"action", "close"}, {"time", 0.2}, {"input", 0}}),
                   step("moveL", {{"waypoint", pick}, {"before", 0.05}}),
                   step("moveL", {{"pose", "slot"}, {"before", 0.05}}), step("moveL", {{"pose", "slot"}}),
                   step("gripper", {{"action", "open"}, {"time", 0.2}}),
                   step("moveL", {{"pose", "slot"}, {"before", 0.05}}),
                   step("assign", {{"variable", "parts"}, {"type", "whole"}, {"value", "parts + 1"}})})}),
         step("onError", {},
              {step("gripper", {{"action", "open"}, {"time", 0.2}}),
               step("log", {{"text", "stopped after "}, {"value", "parts"}})}),
         step("moveJ", {{"waypoint", waypointId(project, "home")}})});
}

}  // namespace tiller::program
