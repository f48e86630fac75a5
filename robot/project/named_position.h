// SPDX-License-Identifier: MIT
#pragma once

// Named joint positions, such as Home, and the safe height for travel.

#include <QJsonObject>
#include <QString>
#include <QUuid>
#include <optional>

#include "robot/core/joints.h"
#include "robot/project/entity_list.h"

namespace tiller::project {

struct NamedPosition {
    QUuid id;
    QString name;
    JointPositions joints;  ///< [rad]
    QString note;
    QJsonObject extra;  ///< unknown fields of the file, preserved when saving
    friend bool operator==(const NamedPosition&, const NamedPosition&) = default;
};
using PositionList = EntityList<NamedPosition>;

/// Height above which there are no obstacles, so that the TCP can travel horizontally.
struct SafeHeight {
    QUuid frame;        ///< measured along the Z axis of this frame; null: base frame
    double height = 0;  ///< [m]
    friend bool operator==(const SafeHeight&, const SafeHeight&) = default;
};

struct Positions {
    PositionList list;
    QUuid home;  ///< position for the Home button; null: default of the program
    std::optional<SafeHeight> safeHeight;

    /// The selected home position; null if none is selected.
    const NamedPosition* homePosition() const { return home.isNull() ? nullptr : list.find(home); }
    friend bool operator==(const Positions&, const Positions&) = default;
};

}  // namespace tiller::project
