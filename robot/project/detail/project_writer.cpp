// SPDX-License-Identifier: MIT
#include "robot/project/detail/project_writer.h"

#include <QJsonArray>

#include "robot/project/detail/file_words.h"
#include "robot/project/waypoint_revision.h"

namespace tiller::project {
namespace {

QJsonArray arrayOf(const std::array<double, 6>& values) {
    QJsonArray result;
    for (const double value : values) {
        result.append(value);
    }
    return result;
}

QJsonArray arrayOf(const Eigen::Vector3d& point) {
    return {point.x(), point.y(), point.z()};
}

QString textOf(const QUuid& id) {
    return id.toString(QUuid::WithoutBraces);
}

QJsonValue idOrNull(const QUuid& id) {
    return id.isNull() ? QJsonValue(QJsonValue::Null) : QJsonValue(textOf(id));
}

void putText(QJsonObject& object, const char* key, const QString& text) {
    if (!text.isEmpty()) {
        object[QLatin1String(key)] = text;
    }
}

void putId(QJsonObject& object, const char* key, const QUuid& id) {
    if (!id.isNull()) {
        object[QLatin1String(key)] = textOf(id);
    }
}

void putList(QJsonObject& object, const char* key, const QJsonArray& list) {
    if (!list.isEmpty()) {
        object[QLatin1String(key)] = list;
    }
}

/// The fields common to all entries.
template <class Entity>
QJsonObject begun(const Entity& entity) {
    QJsonObject object = entity.extra;
    object["id"] = textOf(entity.id);
    object["name"] = entity.name;
    return object;
}

QJsonObject entryOf(const Frame& frame) {
    QJsonObject object = begun(frame);
    object["pose"] = arrayOf(frame.T_base_frame.array());
    return object;
}

QJsonObject actionOf(const WaypointAction& action) {
    QJsonObject object = action.extra;
    object["do"] = QLatin1String(kindOf(action).key);
    if (action.usesPin()) {
        object["group"] = QLatin1String(kIoGroupWords[static_cast<std::size_t>(action.group)]);
        object["pin"] = action.pin;
        object["value"] = action.value;
    }
    if (action.usesTime()) {
        object["seconds"] = action.seconds;
    }
    return object;
}

/// All fields of a waypoint except ID and history.
QJsonObject factsOf(const Waypoint& point) {
    QJsonObject object = point.extra;
    object["name"] = point.name;
    object["move"] = QLatin1String(kMoveWords[static_cast<std::size_t>(point.move)]);
    object["rules"] = QLatin1String(kTargetWords[static_cast<std::size_t>(point.priority)]);
    object["frame"] = idOrNull(point.frame);
    object["tcpOffset"] = arrayOf(point.tcpOffset.array());
    object["joints"] = arrayOf(point.joints.array());
    object["pose"] = arrayOf(point.pose.array());
    object["jointSpeed"] = point.jointSpeed;
    object["toolSpeed"] = point.toolSpeed;
    object["blend"] = point.blend;
    putText(object, "group", point.group);
    if (point.colour != WaypointColour::None) {
        object["colour"] = QLatin1String(kColourWords[static_cast<std::size_t>(point.colour)]);
    }
    putText(object, "note", point.note);
    QJsonArray actions;
    for (const WaypointAction& action : point.actions) {
        actions.append(actionOf(action));
    }
    putList(object, "actions", actions);
    if (!point.place.isNull()) {
        object["place"] = QJsonObject{{"pattern", textOf(point.place.pattern)},
                                      {"column", point.place.column},
                                      {"row", point.place.row},
                                      {"layer", point.place.layer}};
    }
    return object;
}

QJsonObject entryOf(const Waypoint& point) {
    QJsonObject object = factsOf(point);
    object["id"] = textOf(point.id);
    QJsonArray history;
    for (int i = 0; i < point.history.size(); ++i) {
        const WaypointRevision& revision = point.history.at(i);
        QJsonObject entry = revision.extra;
        entry["at"] = revision.at.toUTC().toString(Qt::ISODate);
        putText(entry, "who", revision.who);
        putText(entry, "what", revision.what);
        entry["before"] = factsOf(revision.before);
        history.append(entry);
    }
    putList(object, "history", history);
    return object;
}

QJsonObject entryOf(const Tool& tool) {
    QJsonObject object = begun(tool);
    object["tcpOffset"] = arrayOf(tool.tcpOffset.array());
    if (tool.radius != 0) {
        object["radius"] = tool.radius;
    }
    putText(object, "note", tool.note);
    return object;
}

QJsonObject entryOf(const Payload& payload) {
    QJsonObject object = begun(payload);
    object["mass"] = payload.mass;
    object["centre"] = arrayOf(payload.centre);
    if (payload.inertia) {
        object["inertia"] = arrayOf(*payload.inertia);
    }
    putText(object, "note", payload.note);
    return object;
}

QJsonObject entryOf(const NamedPosition& position) {
    QJsonObject object = begun(position);
    object["joints"] = arrayOf(position.joints.array());
    putText(object, "note", position.note);
    return object;
}

QJsonObject entryOf(const Pattern& pattern) {
    QJsonObject object = begun(pattern);
    object["first"] = entryOf(pattern.first);
    object["columnEnd"] = arrayOf(pattern.columnEnd);
    object["rowEnd"] = arrayOf(pattern.rowEnd);
    object["columns"] = pattern.columns;
    object["rows"] = pattern.rows;
    object["layers"] = pattern.layers;
    object["layerStep"] = pattern.layerStep;
    object["order"] = QLatin1String(kOrderWords[static_cast<std::size_t>(pattern.order)]);
    QJsonArray excluded;
    for (const PatternCell& cell : pattern.excluded) {
        excluded.append(QJsonObject{{"column", cell.column}, {"row", cell.row}});
    }
    putList(object, "excluded", excluded);
    if (pattern.corners != std::array<QUuid, 3>()) {
        object["corners"] = QJsonArray{idOrNull(pattern.corners[0]), idOrNull(pattern.corners[1]),
                                       idOrNull(pattern.corners[2])};
    }
    putText(object, "note", pattern.note);
    return object;
}

void putDisabled(QJsonObject& object, bool enabled) {
    if (!enabled) {
        object["enabled"] = false;
    }
}

QJsonObject entryOf(const CellPlane& plane) {
    QJsonObject object = begun(plane);
    object["frame"] = idOrNull(plane.frame);
    object["pose"] = arrayOf(plane.pose.array());
    putDisabled(object, plane.enabled);
    return object;
}

QJsonObject entryOf(const CellBox& box) {
    QJsonObject object = begun(box);
    object["frame"] = idOrNull(box.frame);
    object["pose"] = arrayOf(box.pose.array());
    object["size"] = arrayOf(box.size);
    putDisabled(object, box.enabled);
    return object;
}

QJsonObject entryOf(const RecordedPath& path) {
    QJsonObject object = begun(path);
    object["tcpOffset"] = arrayOf(path.tcpOffset.array());
    object["tolerance"] = path.tolerance;
    QJsonArray points;
    for (const PathPoint& point : path.points) {
        points.append(QJsonObject{{"t", point.time}, {"q", arrayOf(point.q.array())}});
    }
    object["points"] = points;
    putText(object, "note", path.note);
    return object;
}

QJsonObject entryOf(const ProgramStep& step) {
    QJsonObject object = step.fields;
    object["id"] = textOf(step.id);
    object["do"] = step.kind;
    if (step.disabled) {
        object["disabled"] = true;
    }
    QJsonArray steps;
    for (const ProgramStep& inner : step.steps) {
        steps.append(entryOf(inner));
    }
    putList(object, "steps", steps);
    return object;
}

QJsonObject entryOf(const Program& program) {
    QJsonObject object = begun(program);
    putList(object, "parameters", QJsonArray::fromStringList(program.parameters));
    QJsonArray steps;
    for (const ProgramStep& step : program.steps) {
        steps.append(entryOf(step));
    }
    putList(object, "steps", steps);
    putText(object, "note", program.note);
    return object;
}

template <class List>
QJsonArray entriesOf(const List& list) {
    QJsonArray result;
    for (const auto& entity : list) {
        result.append(entryOf(entity));
    }
    return result;
}

QJsonObject objectOf(const CellGeometry& cell) {
    QJsonObject object = cell.extra;
    if (cell.floor) {
        object["floor"] = *cell.floor;
    }
    putList(object, "boxes", entriesOf(cell.boxes));
    putList(object, "planes", entriesOf(cell.planes));
    if (cell.safetyDistance != kDefaultSafetyDistance) {
        object["safetyDistance"] = cell.safetyDistance;
    }
    return object;
}

}  // namespace

QJsonObject toJson(const Project& document) {
    QJsonObject root = document.extra;
    root["format"] = QLatin1String(kProjectFormat);
    root["version"] = kProjectFileVersion;
    if (document.robot) {
        root["robot"] = QLatin1String(robotModel(*document.robot).name);
    }
    root["frames"] = entriesOf(document.frames);
    root["waypoints"] = entriesOf(document.waypoints);
    putList(root, "tools", entriesOf(document.tooling.tools));
    putId(root, "activeTool", document.tooling.activeTool);
    putList(root, "payloads", entriesOf(document.tooling.payloads));
    putId(root, "activePayload", document.tooling.activePayload);
    putList(root, "positions", entriesOf(document.positions.list));
    putId(root, "home", document.positions.home);
    if (document.positions.safeHeight) {
        root["safeHeight"] = QJsonObject{{"frame", idOrNull(document.positions.safeHeight->frame)},
                                         {"height", document.positions.safeHeight->height}};
    }
    putList(root, "patterns", entriesOf(document.patterns));
    if (const QJsonObject cell = objectOf(document.cell); !cell.isEmpty()) {
        root["cell"] = cell;
    }
    putList(root, "paths", entriesOf(document.paths));
    putList(root, "programs", entriesOf(document.programs));
    return root;
}

}  // namespace tiller::project
