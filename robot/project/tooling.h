// SPDX-License-Identifier: MIT
#pragma once

// What can be mounted at the flange: tool centre points and payloads, each by name, and which of them the
// operator works with. The controller has its own idea of both; which one is right is asked, never guessed.

#include <QJsonObject>
#include <QString>
#include <QUuid>
#include <array>
#include <optional>

#include "robot/core/spatial.h"
#include "robot/project/entity_list.h"

namespace tiller::project {

inline constexpr double kWidestTool = 1.0;  ///< [m] Tool::radius

/// A tool centre point, and the space the tool takes up around the line from the flange to it.
struct Tool {
    QUuid id;
    QString name;
    Pose tcpOffset;     ///< flange to TCP [m, rad]
    double radius = 0;  ///< of a round body from the flange to the TCP [m]; 0: it is not drawn nor looked at
    QString note;
    QJsonObject extra;  ///< fields of the file that this version does not know
    friend bool operator==(const Tool&, const Tool&) = default;
};

/// The heaviest payload a project may hold [kg]: above that of every model.
inline constexpr double kHeaviestPayload = 50.0;
inline constexpr double kFarthestPayload = 5.0;  ///< of its centre from the flange, along each axis [m]

/// What hangs at the flange, the tool with what it holds.
struct Payload {
    QUuid id;
    QString name;
    double mass = 0;                                   ///< [kg]
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();  ///< of gravity, from the flange in its axes [m]
    /// Ixx, Iyy, Izz, Ixy, Ixz, Iyz about the centre of gravity in the flange's axes [kg m2], where known.
    std::optional<std::array<double, 6>> inertia;
    QString note;
    QJsonObject extra;
    friend bool operator==(const Payload&, const Payload&) = default;
};

using ToolList = EntityList<Tool>;
using PayloadList = EntityList<Payload>;

struct Tooling {
    ToolList tools;
    QUuid activeTool;  ///< null: whatever the controller has
    PayloadList payloads;
    QUuid activePayload;  ///< null: whatever the controller has
    friend bool operator==(const Tooling&, const Tooling&) = default;
};

}  // namespace tiller::project
