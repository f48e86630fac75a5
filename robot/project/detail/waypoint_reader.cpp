// SPDX-License-Identifier: MIT
#include "robot/project/detail/waypoint_reader.h"

#include "robot/project/detail/file_words.h"
#include "robot/project/pattern.h"
#include "robot/project/waypoint_revision.h"

namespace tiller::project {

Waypoint WaypointReader::read(const QString& where, const QJsonObject& object) {
    const QUuid id = fields_.id(where, object, "id");
    Waypoint point = facts(where, object, Frames::MustBeHere);
    point.id = id;
    point.history = history(where, object, id);
    return point;
}

Waypoint WaypointReader::facts(const QString& where, const QJsonObject& object, Frames frames) {
    Waypoint point;
    point.name = fields_.text(where, object, "name");
    point.move = static_cast<MoveKind>(fields_.word(where, object, "move", kMoveWords));
    point.priority = static_cast<TargetKind>(fields_.word(where, object, "rules", kTargetWords));
    point.frame = frames == Frames::MustBeHere ? fields_.frame(where, object, frames_)
                                               : fields_.optionalId(where, object, "frame");
    point.tcpOffset = fields_.pose(where, object, "tcpOffset");
    point.pose = fields_.pose(where, object, "pose");
    point.joints = fields_.joints(fieldAt(where, "joints"), object.value(QLatin1String("joints")));
    point.jointSpeed = fields_.number(where, object, "jointSpeed", 0, 20, "rad/s");
    point.toolSpeed = fields_.number(where, object, "toolSpeed", 0, 20, "m/s");
    point.blend = fields_.number(where, object, "blend", 0, 10, "m");
    point.group = fields_.optionalText(where, object, "group");
    point.note = fields_.optionalText(where, object, "note");
    if (object.contains(QLatin1String("colour"))) {
        point.colour = static_cast<WaypointColour>(fields_.word(where, object, "colour", kColourWords));
    }
    if (const QJsonValue place = object.value(QLatin1String("place")); place.isObject()) {
        const QString at = fieldAt(where, "place");
        const QJsonObject cell = place.toObject();
        point.place.pattern = fields_.id(at, cell, "pattern");
        point.place.column = fields_.whole(at, cell, "column", 0, kMaxPatternSteps);
        point.place.row = fields_.whole(at, cell, "row", 0, kMaxPatternSteps);
        point.place.layer = fields_.whole(at, cell, "layer", 0, kMaxPatternSteps);
    } else if (!place.isUndefined()) {
        fields_.addProblem(fieldAt(where, "place"), isNot(place, QStringLiteral("an object")));
    }
    const QJsonArray actions = fields_.optionalList(where, object, "actions");
    for (int i = 0; i < actions.size(); ++i) {
        const QString at = fieldAt(fieldAt(where, "actions"), i);
        if (actions[i].isObject()) {
            point.actions.push_back(action(at, actions[i].toObject()));
        } else {
            fields_.addProblem(at, isNot(actions[i], QStringLiteral("an object")));
        }
    }
    point.extra =
        without(object, {"id", "name", "move", "rules", "frame", "tcpOffset", "joints", "pose", "jointSpeed",
                         "toolSpeed", "blend", "group", "colour", "note", "actions", "place", "history"});
    return point;
}

WaypointAction WaypointReader::action(const QString& where, const QJsonObject& object) {
    std::vector<const char*> keys;
    for (const WaypointActionKind& kind : waypointActionKinds()) {
        keys.push_back(kind.key);
    }
    WaypointAction action;
    action.kind = static_cast<WaypointAction::Kind>(fields_.word(where, object, "do", keys));
    if (action.usesPin()) {
        action.group = static_cast<IoGroup>(fields_.word(where, object, "group", kIoGroupWords));
        action.pin = fields_.whole(where, object, "pin", 0, pinCount(action.group) - 1);
        action.value = fields_.flag(where, object, "value");
    }
    if (action.usesTime()) {
        action.seconds = fields_.number(where, object, "seconds", 0, kMaxActionTime, "s");
    }
    action.extra = without(object, {"do", "group", "pin", "value", "seconds"});
    return action;
}

WaypointHistory WaypointReader::history(const QString& where, const QJsonObject& object, const QUuid& id) {
    WaypointHistory result;
    const QJsonArray revisions = fields_.optionalList(where, object, "history");
    if (revisions.size() > WaypointHistory::kMaxRevisions) {
        fields_.addProblem(fieldAt(where, "history"), QStringLiteral("has %1 entries, more than %2")
                                                          .arg(revisions.size())
                                                          .arg(WaypointHistory::kMaxRevisions));
    }
    for (int i = 0; i < revisions.size(); ++i) {
        const QString at = fieldAt(fieldAt(where, "history"), i);
        const QJsonObject entry = revisions[i].toObject();
        WaypointRevision revision;
        revision.at = QDateTime::fromString(fields_.text(at, entry, "at"), Qt::ISODate).toUTC();
        if (!revision.at.isValid()) {
            fields_.addProblem(fieldAt(at, "at"), QStringLiteral("is not a date and time (ISO 8601)"));
        }
        revision.who = fields_.optionalText(at, entry, "who");
        revision.what = fields_.optionalText(at, entry, "what");
        revision.before = facts(fieldAt(at, "before"), entry.value(QLatin1String("before")).toObject(),
                                Frames::MayBeDeleted);
        revision.before.id = id;
        revision.extra = without(entry, {"at", "who", "what", "before"});
        result.add(revision);
    }
    return result;
}

}  // namespace tiller::project
