// SPDX-License-Identifier: MIT
#pragma once

// A waypoint from its JSON object, with its actions and its history. Private to robot/project.

#include "robot/project/detail/field_reader.h"

namespace tiller::project {

class WaypointReader {
public:
    /// Both must outlive it.
    WaypointReader(FieldReader& fields, const FrameList& frames) : fields_(fields), frames_(frames) {}

    /// Everything of it.
    Waypoint read(const QString& where, const QJsonObject& object);

private:
    enum class Frames {
        MustBeHere,
        MayBeGone,  ///< of a revision: the frame of then may have been deleted since
    };
    /// Without id and history.
    Waypoint facts(const QString& where, const QJsonObject& object, Frames frames);
    WaypointAction action(const QString& where, const QJsonObject& object);
    WaypointHistory history(const QString& where, const QJsonObject& object, const QUuid& id);

    FieldReader& fields_;
    const FrameList& frames_;
};

}  // namespace tiller::project
