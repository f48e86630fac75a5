// SPDX-License-Identifier: MIT
#pragma once

// A project with all elements of a project file, for tests of files and project functions.

#include <QJsonArray>

#include "robot/project/project_file.h"
#include "robot/project/waypoint_revision.h"

namespace tiller::project {

inline Waypoint fullWaypoint(const QString& name, const QUuid& frame) {
    Waypoint point;
    point.id = QUuid::createUuid();
    point.name = name;
    point.move = MoveKind::Linear;
    point.priority = TargetKind::Pose;
    point.frame = frame;
    point.tcpOffset = Pose(0, 0, 0.1234567890123456789, 0, 0, 0);
    point.joints = JointPositions(0.1, -1.1, 1.0 / 3, -1.7, 1.5, 0.3);
    point.pose = Pose(0.1, 0.2, 0.3, 1e-17, -2.2, 0.7);
    point.jointSpeed = 0.7;
    point.toolSpeed = 0.05;
    point.blend = 0.005;
    point.group = QStringLiteral("Käfig \"A\"");
    point.colour = WaypointColour::Pink;
    point.note = QStringLiteral("mind the clamp\nand the hose } ] \\");
    using Kind = WaypointAction::Kind;
    point.actions = {{Kind::SetOutput, IoGroup::Standard, 7, true, 0, {}},
                     {Kind::PulseOutput, IoGroup::Tool, 1, false, 0.25, {}},
                     {Kind::WaitForInput, IoGroup::Configurable, 3, true, 12.5, {}},
                     {Kind::WaitTime, IoGroup::Standard, 0, true, 1.0 / 3, {}},
                     {Kind::OpenGripper, IoGroup::Standard, 0, true, 0, {}},
                     {Kind::CloseGripper, IoGroup::Standard, 0, true, 0, {}}};
    return point;
}

inline Project fullProject() {
    Project document;
    document.robot = RobotModelId::UR10e;
    const QUuid tray = QUuid::createUuid();
    document.frames.append({tray, QStringLiteral("Tray Ä"), Pose(0.5, 0.1, 0, 0, 0, 1.0 / 3), {}});

    const Waypoint corner = fullWaypoint(QStringLiteral("corner"), tray);
    document.waypoints.append(corner);
    Pattern pattern;
    pattern.id = QUuid::createUuid();
    pattern.name = QStringLiteral("tray");
    pattern.first = corner;
    pattern.columnEnd = corner.pose.position + Eigen::Vector3d(0.3, 0, 0);
    pattern.rowEnd = corner.pose.position + Eigen::Vector3d(0, 0.2, 0);
    pattern.columns = 3;
    pattern.rows = 2;
    pattern.layers = 2;
    pattern.layerStep = 0.04;
    pattern.order = PatternOrder::Meander;
    pattern.excluded = {{1, 1}};
    pattern.corners = {corner.id, QUuid(), QUuid()};
    pattern.note = QStringLiteral("blue ones");
    document.patterns.append(pattern);
    for (const Waypoint& point : waypointsOf(pattern, robotModel(RobotModelId::UR10e), document.frames)) {
        document.waypoints.append(point);
    }
    Waypoint changed = corner;
    changed.id = QUuid::createUuid();
    changed.name = QStringLiteral("changed");
    Waypoint earlier = changed;
    earlier.frame = QUuid::createUuid();  // id of a deleted frame
    earlier.actions.clear();
    const QDateTime noon = QDateTime::fromString(QStringLiteral("2026-03-04T12:00:00Z"), Qt::ISODate);
    changed = withRevision(changed, earlier, noon, QStringLiteral("Ann"), QStringLiteral("Touch up"));
    changed = withRevision(changed, changed, noon.addSecs(61), {}, QStringLiteral("Rename"));
    document.waypoints.append(changed);

    const auto id = [] { return QUuid::createUuid(); };
    document.tooling.tools = {{id(), "gripper", Pose(0, 0, 0.15, 0, 0, 1), 0.04, "left jaw", {}},
                              {id(), "nozzle", Pose(0.01, 0, 0.2, 0, 0.5, 0), 0, {}, {}}};
    document.tooling.activeTool = document.tooling.tools.at(1).id;
    document.tooling.payloads = {
        {id(), "empty", 0.95, {0, 0, 0.05}, std::nullopt, {}, {}},
        {id(), "with part", 2.1, {0.01, -0.02, 0.08}, {{0.01, 0.011, 0.012, 0, -0.001, 0}}, "new", {}}};
    document.tooling.activePayload = document.tooling.payloads.at(0).id;
    document.positions.list = {{id(), "Home", JointPositions(0, -1.57, 1.57, -1.57, -1.57, 0), "above", {}},
                               {id(), "Service", JointPositions(1, -1, 1, -1, -1, 1), {}, {}}};
    document.positions.home = document.positions.list.at(0).id;
    document.positions.safeHeight = SafeHeight{tray, 0.35};
    document.cell.floor = -0.01;
    document.cell.boxes = {{id(), "table", tray, Pose(0, 0, -0.2, 0, 0, 0), {0.8, 0.6, 0.4}, true, {}}};
    document.cell.planes = {{id(), "glass", QUuid(), Pose(0, 0.7, 0, 1.57, 0, 0), true, {}}};
    RecordedPath path;
    path.id = id();
    path.name = QStringLiteral("around the rim");
    path.tcpOffset = Pose(0, 0, 0.1, 0, 0, 0);
    path.tolerance = 0.0005;
    path.points = {{0, JointPositions(0, -1, 1, -1, -1, 0)}, {0.5, JointPositions(0.1, -1, 1, -1, -1, 0)}};
    path.note = QStringLiteral("shown by hand");
    document.paths.append(path);
    Program program;
    program.id = id();
    program.name = QStringLiteral("load the tray");
    program.parameters = {QStringLiteral("part")};
    program.note = QStringLiteral("for the night");
    const QJsonObject toCorner{{"waypoint", corner.id.toString(QUuid::WithoutBraces)}, {"speed", 1.0 / 3}};
    program.steps = {{id(), "loop", {{"times", 3}}, false, {{id(), "moveJ", toCorner, true, {}}}},
                     {id(), "kind of the future", {{"shape", QJsonArray{1, "two"}}}, false, {}}};
    document.programs.append(program);
    return document;
}

}  // namespace tiller::project
