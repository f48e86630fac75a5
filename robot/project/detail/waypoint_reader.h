// SPDX-License-Identifier: MIT
#pragma once

// Reads a waypoint with its actions and history from its JSON object. Private to robot/project.

#include "robot/project/detail/field_reader.h"

namespace tiller::project {

class WaypointReader {
public:
    /// Both arguments must outlive the object.
    WaypointReader(FieldReader& fields, const FrameList& frames) : fields_(fields), frames_(frames) {}

    /// Reads a waypoint with ID and history.
    Waypoint read(const QString& where, const QJsonObject& object);

private:
    enum class Frames {
        MustBeHere,
        MayBeDeleted,  ///< part of a revision, whose frame may have been deleted since
    };
    /// Reads a waypoint without ID and history.
    Waypoint facts(const QString& where, const QJsonObject& object, Frames frames);
    WaypointAction action(const QString& where, const QJsonObject& object);
    WaypointHistory history(const QString& where, const QJsonObject& object, const QUuid& id);

    FieldReader& fields_;
    const FrameList& frames_;
};

}  // namespace tiller::project
