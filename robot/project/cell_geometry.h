// SPDX-License-Identifier: MIT
#pragma once

// What stands around the arm: a floor, boxes, and planes nothing may pass. Drawn, looked at before a move, and
// given to the simulated controller.

#include <QJsonObject>
#include <QString>
#include <QUuid>
#include <optional>

#include "robot/core/spatial.h"
#include "robot/project/entity_list.h"

namespace tiller::project {

inline constexpr double kLeastBoxEdge = 0.0001;          ///< [m]
inline constexpr double kDefaultSafetyDistance = 0.010;  ///< [m]
inline constexpr double kMaxSafetyDistance = 0.5;        ///< [m]

struct CellBox {
    QUuid id;
    QString name;
    QUuid frame;                                            ///< of `pose`; null is the base frame
    Pose pose;                                              ///< of its centre, edges along its axes [m, rad]
    Eigen::Vector3d size = Eigen::Vector3d::Constant(0.1);  ///< edges along X, Y, Z [m]
    bool enabled = true;                                    ///< false: neither drawn nor checked
    QJsonObject extra;  ///< fields of the file that this version does not know
    friend bool operator==(const CellBox&, const CellBox&) = default;
};

/// Its XY plane is the border; the arm stays on the side of +Z.
struct CellPlane {
    QUuid id;
    QString name;
    QUuid frame;  ///< of `pose`; null is the base frame
    Pose pose;    ///< [m, rad]
    bool enabled = true;
    QJsonObject extra;
    friend bool operator==(const CellPlane&, const CellPlane&) = default;
};

using CellBoxList = EntityList<CellBox>;
using CellPlaneList = EntityList<CellPlane>;

struct CellGeometry {
    std::optional<double> floor;  ///< its height in the base frame [m]; nothing: there is none
    CellBoxList boxes;
    CellPlaneList planes;
    double safetyDistance =
        kDefaultSafetyDistance;  ///< that the arm keeps from all of it, and from itself [m]
    QJsonObject extra;

    bool isEmpty() const { return !floor && boxes.isEmpty() && planes.isEmpty(); }  ///< Nothing is there.
    friend bool operator==(const CellGeometry&, const CellGeometry&) = default;
};

}  // namespace tiller::project
