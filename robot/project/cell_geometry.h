// SPDX-License-Identifier: MIT
#pragma once

// The environment of the arm: a floor, boxes and planes. Used by the 3D view, the check of moves, and the
// simulated controller.

#include <QJsonObject>
#include <QString>
#include <QUuid>
#include <optional>

#include "robot/core/spatial.h"
#include "robot/project/entity_list.h"

namespace tiller::project {

inline constexpr double kMinBoxEdge = 0.0001;            ///< [m]
inline constexpr double kDefaultSafetyDistance = 0.010;  ///< [m]
inline constexpr double kMaxSafetyDistance = 0.5;        ///< [m]

struct CellBox {
    QUuid id;
    QString name;
    QUuid frame;  ///< frame of `pose`; null: base frame. If the frame does not exist, the position is unknown
    Pose pose;    ///< pose of the centre; the edges are parallel to the axes of this pose [m, rad]
    Eigen::Vector3d size = Eigen::Vector3d::Constant(0.1);  ///< edges along X, Y, Z [m]
    bool enabled = true;                                    ///< false: neither displayed nor checked
    QJsonObject extra;  ///< unknown fields of the file, preserved when saving
    friend bool operator==(const CellBox&, const CellBox&) = default;
};

/// A plane. The XY plane of its pose is the border, and the arm must stay on the +Z side.
struct CellPlane {
    QUuid id;
    QString name;
    QUuid frame;  ///< as for CellBox
    Pose pose;    ///< [m, rad]
    bool enabled = true;
    QJsonObject extra;
    friend bool operator==(const CellPlane&, const CellPlane&) = default;
};

using CellBoxList = EntityList<CellBox>;
using CellPlaneList = EntityList<CellPlane>;

struct CellGeometry {
    std::optional<double> floor;  ///< height in the base frame [m]; empty: no floor
    CellBoxList boxes;
    CellPlaneList planes;
    double safetyDistance =
        kDefaultSafetyDistance;  ///< minimum distance of the arm from all objects and from itself [m]
    QJsonObject extra;

    bool isEmpty() const {
        return !floor && boxes.isEmpty() && planes.isEmpty();
    }  ///< True if there are no objects.
    friend bool operator==(const CellGeometry&, const CellGeometry&) = default;
};

}  // namespace tiller::project
