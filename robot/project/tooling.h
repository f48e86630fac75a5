// SPDX-License-Identifier: MIT
#pragma once

// Named tools (tool centre points) and payloads at the flange, and the selected tool and payload. The
// controller has separate settings. If they differ, the user is asked which settings to use.

#include <QJsonObject>
#include <QString>
#include <QUuid>
#include <array>
#include <optional>

#include "robot/core/spatial.h"
#include "robot/project/entity_list.h"

namespace tiller::project {

inline constexpr double kWidestTool = 1.0;  ///< [m] limit of Tool::radius

/// A tool centre point, and the space occupied by the tool around the line from the flange to the TCP.
struct Tool {
    QUuid id;
    QString name;
    Pose tcpOffset;  ///< flange to TCP [m, rad]
    double radius =
        0;  ///< radius of a cylinder from the flange to the TCP [m]; 0: neither displayed nor checked
    QString note;
    QJsonObject extra;  ///< unknown fields of the file, preserved when saving
    friend bool operator==(const Tool&, const Tool&) = default;
};

/// Maximum mass in a project [kg]. Exceeds the payload of all models.
inline constexpr double kHeaviestPayload = 50.0;
/// Maximum distance of the centre of gravity from the flange, per axis [m].
inline constexpr double kFarthestPayload = 5.0;

/// The load at the flange: the tool and the held object.
struct Payload {
    QUuid id;
    QString name;
    double mass = 0;                                   ///< [kg]
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();  ///< centre of gravity in the flange frame [m]
    /// Ixx, Iyy, Izz, Ixy, Ixz, Iyz about the centre of gravity in the axes of the flange [kg m2], if known.
    std::optional<std::array<double, 6>> inertia;
    QString note;
    QJsonObject extra;
    friend bool operator==(const Payload&, const Payload&) = default;
};

using ToolList = EntityList<Tool>;
using PayloadList = EntityList<Payload>;

struct Tooling {
    ToolList tools;
    QUuid activeTool;  ///< null: setting of the controller
    PayloadList payloads;
    QUuid activePayload;  ///< null: setting of the controller
    friend bool operator==(const Tooling&, const Tooling&) = default;
};

}  // namespace tiller::project
