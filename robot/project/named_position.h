// SPDX-License-Identifier: MIT
#pragma once

// Joint positions with a name, such as Home, and the height above which the arm may travel.

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
    QJsonObject extra;  ///< fields of the file that this version does not know
    friend bool operator==(const NamedPosition&, const NamedPosition&) = default;
};
using PositionList = EntityList<NamedPosition>;

/// Nothing stands above it: the TCP may go sideways there.
struct SafeHeight {
    QUuid frame;        ///< along whose Z it is measured; null: the base
    double height = 0;  ///< [m]
    friend bool operator==(const SafeHeight&, const SafeHeight&) = default;
};

struct Positions {
    PositionList list;
    QUuid home;  ///< which of them the key Home goes to; null: the program's own
    std::optional<SafeHeight> safeHeight;

    /// Null where none was chosen.
    const NamedPosition* homePosition() const { return home.isNull() ? nullptr : list.find(home); }
    friend bool operator==(const Positions&, const Positions&) = default;
};

}  // namespace tiller::project
