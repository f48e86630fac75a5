// SPDX-License-Identifier: MIT
#include "robot/project/detail/project_reader.h"

#include <QJsonDocument>
#include <QSet>

#include "robot/project/detail/waypoint_reader.h"

namespace tiller::project {

int& ProjectReader::countOf(const QString& list) {
    return list == QLatin1String("waypoints") ? result_.lostWaypoints
           : list == QLatin1String("frames")  ? result_.lostFrames
                                              : result_.lostParts;
}

void ProjectReader::addLost(const QString& list) {
    ++countOf(list);
    if (list == QLatin1String("boxes") || list == QLatin1String("planes")) {
        ++result_.lostObstacles;
    }
}

template <class Read, class Accept>
void ProjectReader::readEntries(const QString& where, const QJsonObject& root, const char* key,
                                const Read& readOne, const Accept& accept) {
    const QJsonArray entries = fields_.optionalList(where, root, key);
    for (int i = 0; i < entries.size(); ++i) {
        const QString at = fieldAt(fieldAt(where, key), i);
        const qsizetype before = fields_.problemCount();
        if (!entries[i].isObject()) {
            fields_.addProblem(at, isNot(entries[i], QStringLiteral("an object")));
        } else {
            auto entity = readOne(at, entries[i].toObject());
            if (fields_.problemCount() == before) {
                accept(at, std::move(entity));
            }
        }
        if (fields_.problemCount() != before) {
            addLost(QLatin1String(key));
        }
    }
}

template <class Entity>
void ProjectReader::readList(const QString& where, const QJsonObject& root, const char* key,
                             EntityList<Entity>& list,
                             Entity (PartReader::*readOne)(const QString&, const QJsonObject&)) {
    readEntries(
        where, root, key,
        [&](const QString& at, const QJsonObject& object) { return (parts_.*readOne)(at, object); },
        [&](const QString& at, Entity entity) {
            if (list.find(entity.id) != nullptr) {
                fields_.addProblem(fieldAt(at, "id"),
                                   QStringLiteral("is already used in %1").arg(QLatin1String(key)));
            } else {
                list.append(std::move(entity));
            }
        });
}

template <class Entity>
QUuid ProjectReader::reference(const QJsonObject& root, const char* key, const EntityList<Entity>& list) {
    const QUuid id = fields_.optionalId({}, root, key);
    if (!id.isNull() && list.find(id) == nullptr) {
        fields_.addProblem(QLatin1String(key), QStringLiteral("no item of this project has that id"));
        return {};
    }
    return id;
}

void ProjectReader::read(const QJsonObject& root, bool waypointsRequired) {
    readRobot(root.value(QLatin1String("robot")));
    Project& document = result_.document;
    // Read frames first, because most other entries refer to them.
    readList<Frame>({}, root, "frames", document.frames, &PartReader::frame);
    readList<Pattern>({}, root, "patterns", document.patterns, &PartReader::pattern);
    readWaypoints(root, waypointsRequired);
    checkPatterns();
    readTooling(root);
    readPositions(root);
    readCell(root.value(QLatin1String("cell")));
    readList<RecordedPath>({}, root, "paths", document.paths, &PartReader::path);
    readList<Program>({}, root, "programs", document.programs, &PartReader::program);
    document.extra = without(
        root, {"format", "version", "robot", "frames", "waypoints", "tools", "activeTool", "payloads",
               "activePayload", "positions", "home", "safeHeight", "patterns", "cell", "paths", "programs"});
}

void ProjectReader::readRobot(const QJsonValue& value) {
    if (value.isUndefined() || value.isNull()) {
        return;
    }
    if (!value.isString()) {
        addProblem(QStringLiteral("robot"), isNot(value, QStringLiteral("a text")));
        return;
    }
    result_.document.robot = robotModelByName(value.toString());
    if (!result_.document.robot) {
        addProblem(QStringLiteral("robot"),
                   QStringLiteral("\"%1\" is not a known robot model").arg(value.toString()));
    }
}

void ProjectReader::readWaypoints(const QJsonObject& root, bool required) {
    if (required && !root.contains(QLatin1String("waypoints"))) {
        addProblem(QStringLiteral("waypoints"), QStringLiteral("is missing"));
    }
    WaypointReader reader(fields_, result_.document.frames);
    QSet<QUuid> ids;
    QVector<QString> withoutPattern;
    readEntries(
        {}, root, "waypoints",
        [&](const QString& at, const QJsonObject& object) { return reader.read(at, object); },
        [&](const QString& at, Waypoint point) {
            if (ids.contains(point.id)) {
                fields_.addProblem(fieldAt(at, "id"), QStringLiteral("is used by another waypoint"));
                return;
            }
            if (!point.place.isNull() && result_.document.patterns.find(point.place.pattern) == nullptr) {
                withoutPattern.append(fieldAt(at, "place"));
                point.place = {};  // keep the point as an ordinary waypoint
            }
            ids.insert(point.id);
            result_.document.waypoints.append(std::move(point));
        });
    for (const QString& where : withoutPattern) {
        addProblem(where, QStringLiteral("no pattern of this project has that id"));
    }
}

void ProjectReader::checkPatterns() {
    Project& document = result_.document;
    QSet<QUuid> ids;
    for (const Waypoint& point : document.waypoints) {
        ids.insert(point.id);
    }
    for (std::size_t i = 0; i < document.patterns.size(); ++i) {
        Pattern pattern = document.patterns.at(i);
        for (std::size_t n = 0; n < pattern.corners.size(); ++n) {
            if (!pattern.corners[n].isNull() && !ids.contains(pattern.corners[n])) {
                addProblem(
                    fieldAt(fieldAt(fieldAt(QStringLiteral("patterns"), static_cast<int>(i)), "corners"),
                            static_cast<int>(n)),
                    QStringLiteral("no waypoint of this project has that id"));
                pattern.corners[n] = QUuid();
            }
        }
        document.patterns.replace(i, std::move(pattern));
    }
}

void ProjectReader::readTooling(const QJsonObject& root) {
    Tooling& tooling = result_.document.tooling;
    readList<Tool>({}, root, "tools", tooling.tools, &PartReader::tool);
    readList<Payload>({}, root, "payloads", tooling.payloads, &PartReader::payload);
    tooling.activeTool = reference(root, "activeTool", tooling.tools);
    tooling.activePayload = reference(root, "activePayload", tooling.payloads);
}

void ProjectReader::readPositions(const QJsonObject& root) {
    Positions& positions = result_.document.positions;
    readList<NamedPosition>({}, root, "positions", positions.list, &PartReader::position);
    positions.home = reference(root, "home", positions.list);
    const QJsonValue height = root.value(QLatin1String("safeHeight"));
    if (height.isObject()) {
        const qsizetype before = fields_.problemCount();
        const SafeHeight read = parts_.safeHeight(QStringLiteral("safeHeight"), height.toObject());
        if (fields_.problemCount() == before) {
            positions.safeHeight = read;
        }
    } else if (!height.isUndefined()) {
        addProblem(QStringLiteral("safeHeight"), isNot(height, QStringLiteral("an object")));
    }
}

void ProjectReader::readCell(const QJsonValue& value) {
    if (value.isUndefined()) {
        return;
    }
    const QString where = QStringLiteral("cell");
    if (!value.isObject()) {
        addProblem(where, isNot(value, QStringLiteral("an object")));
        return;
    }
    const QJsonObject object = value.toObject();
    CellGeometry& cell = result_.document.cell;
    if (object.contains(QLatin1String("floor"))) {
        const qsizetype before = fields_.problemCount();
        const double floor = fields_.number(where, object, "floor", -FieldReader::kMaxCoordinate,
                                            FieldReader::kMaxCoordinate, "m");
        if (fields_.problemCount() == before) {
            cell.floor = floor;
        }
    }
    if (object.contains(QLatin1String("safetyDistance"))) {
        const qsizetype before = fields_.problemCount();
        const double distance = fields_.number(where, object, "safetyDistance", 0, kMaxSafetyDistance, "m");
        if (fields_.problemCount() == before) {
            cell.safetyDistance = distance;
        }
    }
    readList<CellBox>(where, object, "boxes", cell.boxes, &PartReader::box);
    readList<CellPlane>(where, object, "planes", cell.planes, &PartReader::plane);
    cell.extra = without(object, {"floor", "boxes", "planes", "safetyDistance"});
}

RecoveredProject ProjectReader::take() {
    result_.problems = fields_.takeProblems();
    return std::move(result_);
}

namespace {

/// Index after the closing quote of the string that begins at `from`; -1 if it is not closed.
qsizetype endOfString(const QByteArray& bytes, qsizetype from) {
    for (qsizetype i = from + 1; i < bytes.size(); ++i) {
        if (bytes[i] == '\\') {
            ++i;
        } else if (bytes[i] == '"') {
            return i + 1;
        }
    }
    return -1;
}

bool isListOfEntries(const QByteArray& name) {
    static constexpr const char* kLists[] = {"frames",    "waypoints", "tools", "payloads",
                                             "positions", "patterns",  "paths", "programs"};
    return std::any_of(std::begin(kLists), std::end(kLists), [&](const char* list) { return name == list; });
}

}  // namespace

SalvagedEntries salvageEntries(const QByteArray& bytes) {
    // Counts brackets: depth 1 is the root object, 2 the list of a field, 3 its entries.
    SalvagedEntries result;
    QHash<QString, QJsonArray> lists;
    QByteArray lastString;
    QByteArray listName;
    int depth = 0;
    qsizetype entryStart = -1;
    const auto finish = [&](qsizetype end) {
        const QJsonDocument entry = QJsonDocument::fromJson(bytes.mid(entryStart, end - entryStart));
        const QString list = QString::fromLatin1(listName);
        entryStart = -1;
        if (entry.isObject()) {
            lists[list].append(entry.object());
        } else {
            ++result.broken[list];
        }
    };
    for (qsizetype i = 0; i < bytes.size(); ++i) {
        switch (bytes[i]) {
            case '"': {
                const qsizetype end = endOfString(bytes, i);
                if (end < 0) {
                    i = bytes.size();
                    break;
                }
                lastString = bytes.mid(i + 1, end - i - 2);
                i = end - 1;
                break;
            }
            case '[':
            case '{':
                ++depth;
                if (depth == 2) {
                    listName = lastString;
                } else if (depth == 3 && bytes[i] == '{' && isListOfEntries(listName)) {
                    entryStart = i;
                }
                break;
            case ']':
            case '}':
                if (depth == 3 && entryStart >= 0) {
                    finish(i + 1);
                }
                --depth;
                break;
            default:
                break;
        }
    }
    if (entryStart >= 0) {
        finish(bytes.size());
    }
    for (auto list = lists.cbegin(); list != lists.cend(); ++list) {
        result.root.insert(list.key(), list.value());
    }
    return result;
}

}  // namespace tiller::project
