// SPDX-License-Identifier: MIT
#include "robot/project/detail/part_reader.h"
#include "robot/project/detail/file_words.h"

#include "robot/project/detail/waypoint_reader.h"

namespace tiller::project {

Frame PartReader::frame(const QString& where, const QJsonObject& object) {
    Frame frame;
    frame.id = fields_.id(where, object, "id");
    frame.name = fields_.text(where, object, "name");
    frame.T_base_frame = fields_.pose(where, object, "pose");
    frame.extra = without(object, {"id", "name", "pose"});
    return frame;
}

Tool PartReader::tool(const QString& where, const QJsonObject& object) {
    Tool tool;
    tool.id = fields_.id(where, object, "id");
    tool.name = fields_.text(where, object, "name");
    tool.tcpOffset = fields_.pose(where, object, "tcpOffset");
    tool.radius = object.contains(QLatin1String("radius"))
                      ? fields_.number(where, object, "radius", 0, kWidestTool, "m")
                      : 0;
    tool.note = fields_.optionalText(where, object, "note");
    tool.extra = without(object, {"id", "name", "tcpOffset", "radius", "note"});
    return tool;
}

Payload PartReader::payload(const QString& where, const QJsonObject& object) {
    Payload payload;
    payload.id = fields_.id(where, object, "id");
    payload.name = fields_.text(where, object, "name");
    payload.mass = fields_.number(where, object, "mass", 0, kHeaviestPayload, "kg");
    payload.centre = fields_.point(where, object, "centre", kFarthestPayload);
    if (object.contains(QLatin1String("inertia"))) {
        std::array<double, 6> inertia = fields_.six(where, object, "inertia");
        for (int i = 0; i < 6; ++i) {
            double& component = inertia[static_cast<std::size_t>(i)];
            component = fields_.number(fieldAt(fieldAt(where, "inertia"), i), component, i < 3 ? 0 : -1000,
                                       1000, "kg m2");
        }
        payload.inertia = inertia;
    }
    payload.note = fields_.optionalText(where, object, "note");
    payload.extra = without(object, {"id", "name", "mass", "centre", "inertia", "note"});
    return payload;
}

NamedPosition PartReader::position(const QString& where, const QJsonObject& object) {
    NamedPosition position;
    position.id = fields_.id(where, object, "id");
    position.name = fields_.text(where, object, "name");
    position.joints = fields_.joints(fieldAt(where, "joints"), object.value(QLatin1String("joints")));
    position.note = fields_.optionalText(where, object, "note");
    position.extra = without(object, {"id", "name", "joints", "note"});
    return position;
}

SafeHeight PartReader::safeHeight(const QString& where, const QJsonObject& object) {
    SafeHeight result;
    result.frame = fields_.frame(where, object, frames_);
    result.height = fields_.number(where, object, "height", -FieldReader::kMaxCoordinate,
                                   FieldReader::kMaxCoordinate, "m");
    return result;
}

Pattern PartReader::pattern(const QString& where, const QJsonObject& object) {
    Pattern pattern;
    pattern.id = fields_.id(where, object, "id");
    pattern.name = fields_.text(where, object, "name");
    pattern.first = WaypointReader(fields_, frames_)
                        .read(fieldAt(where, "first"), object.value(QLatin1String("first")).toObject());
    pattern.columnEnd = fields_.point(where, object, "columnEnd");
    pattern.rowEnd = fields_.point(where, object, "rowEnd");
    pattern.columns = fields_.whole(where, object, "columns", 1, kMaxPatternSteps);
    pattern.rows = fields_.whole(where, object, "rows", 1, kMaxPatternSteps);
    pattern.layers = fields_.whole(where, object, "layers", 1, kMaxPatternSteps);
    if (const qint64 places = qint64(pattern.columns) * pattern.rows * pattern.layers;
        places > kMaxPatternPositions) {
        fields_.addProblem(
            where, QStringLiteral("has %1 cells, more than %2").arg(places).arg(kMaxPatternPositions));
    }
    pattern.layerStep = fields_.number(where, object, "layerStep", -FieldReader::kMaxCoordinate,
                                       FieldReader::kMaxCoordinate, "m");
    pattern.order = static_cast<PatternOrder>(fields_.word(where, object, "order", kOrderWords));
    const QJsonArray excluded = fields_.optionalList(where, object, "excluded");
    for (int i = 0; i < excluded.size(); ++i) {
        const QString at = fieldAt(fieldAt(where, "excluded"), i);
        const QJsonObject cell = excluded[i].toObject();
        pattern.excluded.push_back({fields_.whole(at, cell, "column", 0, kMaxPatternSteps),
                                    fields_.whole(at, cell, "row", 0, kMaxPatternSteps)});
    }
    const QJsonArray corners = fields_.optionalList(where, object, "corners");
    for (int i = 0; i < corners.size(); ++i) {
        const QUuid corner(corners[i].toString());
        if (i >= 3 || (corner.isNull() && !corners[i].isNull())) {
            fields_.addProblem(fieldAt(fieldAt(where, "corners"), i),
                               i >= 3 ? QStringLiteral("is a fourth corner; a pattern has three")
                                      : QStringLiteral("is not an id"));
            break;
        }
        pattern.corners[static_cast<std::size_t>(i)] = corner;
    }
    pattern.note = fields_.optionalText(where, object, "note");
    pattern.extra = without(object, {"id", "name", "first", "columnEnd", "rowEnd", "columns", "rows",
                                     "layers", "layerStep", "order", "excluded", "corners", "note"});
    return pattern;
}

CellBox PartReader::box(const QString& where, const QJsonObject& object) {
    CellBox box;
    box.id = fields_.id(where, object, "id");
    box.name = fields_.text(where, object, "name");
    // Keep an object whose frame is missing, because the arm would not avoid a removed object. See
    // collision::CellSurroundings::unplaced.
    box.frame = fields_.frameId(where, object);
    box.pose = fields_.pose(where, object, "pose");
    box.size = fields_.point(where, object, "size", 2 * FieldReader::kMaxCoordinate);
    for (int i = 0; i < 3; ++i) {
        if (!(box.size[i] >= kMinBoxEdge)) {
            fields_.addProblem(
                fieldAt(fieldAt(where, "size"), i),
                QStringLiteral("is %1 m; the minimum edge length is %2 m").arg(box.size[i]).arg(kMinBoxEdge));
        }
    }
    box.enabled = !object.contains(QLatin1String("enabled")) || fields_.flag(where, object, "enabled");
    box.extra = without(object, {"id", "name", "frame", "pose", "size", "enabled"});
    return box;
}

CellPlane PartReader::plane(const QString& where, const QJsonObject& object) {
    CellPlane plane;
    plane.id = fields_.id(where, object, "id");
    plane.name = fields_.text(where, object, "name");
    plane.frame = fields_.frameId(where, object);
    plane.pose = fields_.pose(where, object, "pose");
    plane.enabled = !object.contains(QLatin1String("enabled")) || fields_.flag(where, object, "enabled");
    plane.extra = without(object, {"id", "name", "frame", "pose", "enabled"});
    return plane;
}

RecordedPath PartReader::path(const QString& where, const QJsonObject& object) {
    RecordedPath path;
    path.id = fields_.id(where, object, "id");
    path.name = fields_.text(where, object, "name");
    path.tcpOffset = fields_.pose(where, object, "tcpOffset");
    path.tolerance = fields_.number(where, object, "tolerance", 0, 1, "m");
    const QJsonArray points = fields_.list(where, object, "points");
    if (points.size() > kMaxPathPoints) {
        fields_.addProblem(
            fieldAt(where, "points"),
            QStringLiteral("has %1 entries, more than %2").arg(points.size()).arg(kMaxPathPoints));
    }
    double last = 0;
    for (int i = 0; i < points.size(); ++i) {
        const QString at = fieldAt(fieldAt(where, "points"), i);
        const QJsonObject entry = points[i].toObject();
        PathPoint point;
        point.time = fields_.number(at, entry, "t", last, kMaxPathDuration, "s");
        point.q = fields_.joints(fieldAt(at, "q"), entry.value(QLatin1String("q")));
        last = std::max(last, point.time);
        path.points.push_back(point);
    }
    path.note = fields_.optionalText(where, object, "note");
    path.extra = without(object, {"id", "name", "tcpOffset", "tolerance", "points", "note"});
    return path;
}

void PartReader::readSteps(const QString& where, const QJsonObject& object, std::vector<ProgramStep>& steps,
                           QSet<QUuid>& ids, int depth) {
    const QJsonArray entries = fields_.optionalList(where, object, "steps");
    if (depth > kMaxProgramDepth && !entries.isEmpty()) {
        fields_.addProblem(where, QStringLiteral("has steps nested deeper than %1").arg(kMaxProgramDepth));
        return;
    }
    for (int i = 0; i < entries.size(); ++i) {
        const QString at = fieldAt(fieldAt(where, "steps"), i);
        if (!entries[i].isObject()) {
            fields_.addProblem(at, isNot(entries[i], QStringLiteral("an object")));
            continue;
        }
        const QJsonObject entry = entries[i].toObject();
        ProgramStep step;
        step.id = fields_.id(at, entry, "id");
        if (ids.contains(step.id)) {
            fields_.addProblem(fieldAt(at, "id"), QStringLiteral("is used by another step"));
        }
        ids.insert(step.id);
        if (ids.size() == kMaxProgramSteps + 1) {
            fields_.addProblem(where, QStringLiteral("has more than %1 steps").arg(kMaxProgramSteps));
        }
        step.kind = fields_.text(at, entry, "do");
        step.disabled = entry.contains(QLatin1String("disabled")) && fields_.flag(at, entry, "disabled");
        readSteps(at, entry, step.steps, ids, depth + 1);
        step.fields = without(entry, {"id", "do", "disabled", "steps"});
        steps.push_back(std::move(step));
    }
}

Program PartReader::program(const QString& where, const QJsonObject& object) {
    Program program;
    program.id = fields_.id(where, object, "id");
    program.name = fields_.text(where, object, "name");
    const QJsonArray parameters = fields_.optionalList(where, object, "parameters");
    for (int i = 0; i < parameters.size(); ++i) {
        const QString at = fieldAt(fieldAt(where, "parameters"), i);
        if (!parameters[i].isString()) {
            fields_.addProblem(at, isNot(parameters[i], QStringLiteral("a text")));
        }
        program.parameters.append(parameters[i].toString());
    }
    QSet<QUuid> ids;
    readSteps(where, object, program.steps, ids, 1);
    program.note = fields_.optionalText(where, object, "note");
    program.extra = without(object, {"id", "name", "parameters", "steps", "note"});
    return program;
}

}  // namespace tiller::project
